// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws volumes that overlap in space but use different methods, such as cells and splats, in
 * slices of depth.
 *
 * Some slices are drawn in one pass: every volume draws its part of each of them into an image of
 * its own, along with its answer to a peel (VolumePeel.h); its shader follows shaders/Slices.glsl.
 * In a slice all volumes are one medium: optical depths add, and each shines in proportion to its
 * own. With colours and extinctions that are constant in a slice this is exact; where they change,
 * the error falls with the square of the number of slices.
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
#include <string>
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
    int SlicesAtOnce = 2;                                             ///< VolumeOrder::Part

    vtkBoundingBox GetBox() const;
  };
  static constexpr int PerPass = FloatAccumulation::MostLayers;
  static constexpr int Passes = 4;         ///< the first and the last slice lie outside of overlaps
  static constexpr int PassesInMotion = 1; ///< while the camera moves

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
  void Take(vtkOpenGLRenderWindow* window, const std::vector<vtkTextureObject*>& lights);
  ///@}
  ///@{
  /**
   * For volumes that draw PerPass slices at once: constants and functions for their shaders, empty
   * where no slices are drawn; uniforms; calls `cast`, which draws into as many layers.
   */
  static std::string Definition();
  static void SetUniforms(vtkShaderProgram* program);
  std::string DrawAtOnce(vtkOpenGLRenderWindow* window, const std::function<std::string()>& cast);
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void FindSpans(vtkRenderer* renderer, const std::vector<Medium>& media);
  struct Division;
  void DrawSlices(vtkRenderer* renderer, const std::vector<Medium>& media, const Drawer& draw);
  void DrawPass(vtkRenderer* renderer, const Medium& medium, const std::vector<Division>& ends,
    std::size_t first, const Drawer& draw);
  void SelectSlices(const std::vector<Division>& ends, std::size_t first, int count);
  /** To what is there. */
  void Draw(vtkOpenGLRenderWindow* window, const char* shader,
    const std::vector<vtkTextureObject*>& textures);

  VolumePeel Outer; // of the pass that peels surfaces
  OpaqueDepth Depth;
  FloatAccumulation Image;    // of a volume that draws all slices of a pass at once
  FloatAccumulation Sums;     // of all volumes in these: optical depth, and colours by it
  FloatAccumulation Light[2]; // of all before, in each range of a peel
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; // without attributes
  vtkTextureObject* Source = nullptr;             // ranges of the pass, or the opaque depth
  VolumeSpans Spans;
  vtkTextureObject* Spanned = nullptr;      // null: rays are divided all the way
  std::array<double, 2> Overlap = { 0, 0 }; // distances between which media overlap
  bool Peeled = false;
  int Viewport[4] = { 0, 0, 0, 0 };
  int Range = 0;                // of the peel
  int First = 0, AtOnce = 2;    // slices of the pass that are drawn now
  float Ends[PerPass + 1] = {}; // their depths
  std::array<float, 2> Depths = { 0, 1 };
  std::array<double, 2> Distances = { 0, 0 };
  bool Front = false;
};

} // namespace nephoscope

#endif
