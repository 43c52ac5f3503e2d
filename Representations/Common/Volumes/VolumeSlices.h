// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws volumes that overlap in space but use different methods, such as cells and splats, in
 * slices of depth.
 *
 * Every volume draws its part of a slice into an image of its own, as it answers a peel
 * (VolumePeel.h). In a slice all of them are one medium: optical depths add, and each shines in
 * proportion to its own. With colours and extinctions that are constant in a slice this is exact;
 * where they change, the error falls with the square of the number of slices.
 */
#ifndef nephoscope_VolumeSlices_h
#define nephoscope_VolumeSlices_h

#include "DepthTiles.h"
#include "FloatAccumulation.h"
#include "OpaqueDepth.h"
#include "VolumePeel.h"
#include "VolumeSpans.h"
#include "vtkBoundingBox.h"
#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkNew.h"

#include <array>
#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkVolume;
class vtkWindow;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT VolumeSlices
{
public:
  VolumeSlices();
  ~VolumeSlices();
  VolumeSlices(const VolumeSlices&) = delete;
  VolumeSlices& operator=(const VolumeSlices&) = delete;

  using Drawer = std::function<void(vtkRenderer*, vtkVolume*)>;
  /** Volumes that are drawn as one. */
  struct Medium
  {
    std::vector<vtkVolume*> Volumes;
    std::function<bool(vtkRenderer*, vtkVolume*, DepthTiles&)> AddTo; ///< VolumeOrder::Part

    vtkBoundingBox GetBox() const;
  };
  /**
   * Where the boxes of two volumes overlap there are so many slices; a quarter of them while the
   * camera moves.
   */
  static constexpr int Count = 32;

  void Draw(vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes,
    const std::vector<Medium>& media, const Drawer& draw);

  /** Those that are being drawn; null where there are none. */
  static VolumeSlices* GetCurrent();
  /** Depths in [0, 1] between which volumes are asked to draw now, in any pixel. */
  std::array<float, 2> GetDepths() const { return this->Depths; }
  /**
   * The same as distances from the eye's plane; the lowest and the greatest double where there is
   * no end.
   */
  std::array<double, 2> GetDistances() const { return this->Distances; }
  /** Whether this is the front of the rays, which has an end in every pixel, but no beginning. */
  bool IsFront() const { return this->Front; }
  ///@{
  /** The queries that VolumePeel makes instead of those to a peeling pass. */
  vtkShaderProgram* ReadyRanges(vtkOpenGLRenderWindow* window, bool farthestDepth);
  void Take(vtkOpenGLRenderWindow* window, vtkTextureObject* first, vtkTextureObject* second);
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void FindSpans(vtkRenderer* renderer, const std::vector<Medium>& media);
  void DrawSlices(
    vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes, const Drawer& draw);
  void Lay(vtkOpenGLRenderWindow* window);

  VolumePeel Outer; // of the pass that peels surfaces
  OpaqueDepth Depth;
  FloatAccumulation Sums;  // of a pair of slices: optical depth, and colours by it
  FloatAccumulation Light; // of all before
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; // without attributes
  vtkTextureObject* Source = nullptr;             // ranges of the pass, or the opaque depth
  VolumeSpans Spans;
  vtkTextureObject* Spanned = nullptr;      // null: rays are divided all the way
  std::array<double, 2> Overlap = { 0, 0 }; // distances between which media overlap
  bool Peeled = false;
  int Viewport[4] = { 0, 0, 0, 0 };
  float Slice[4] = { 0, 1, 0, 1 }; // depths, near and far, of a pair
  std::array<float, 2> Depths = { 0, 1 };
  std::array<double, 2> Distances = { 0, 0 };
  bool Front = false;
};

} // namespace nephoscope

#endif
