// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the ray of each pixel lies in the boxes of two volumes or more, which is where it has to be
 * drawn in slices (VolumeSlices.h).
 */
#ifndef nephoscope_VolumeSpans_h
#define nephoscope_VolumeSpans_h

#include "DepthTiles.h"
#include "FloatAccumulation.h"
#include "vtkBoundingBox.h"
#include "vtkNew.h"

#include <cstddef>
#include <vector>

class vtkOpenGLVertexArrayObject;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class VolumeSpans
{
public:
  VolumeSpans();
  ~VolumeSpans();
  VolumeSpans(const VolumeSpans&) = delete;
  VolumeSpans& operator=(const VolumeSpans&) = delete;

  /** With more boxes than this every ray is drawn in slices all the way. */
  static constexpr std::size_t Most = 16;

  /** Around a medium, which is anywhere in it or, with InTiles, between the depths of DepthTiles.
   */
  struct Box
  {
    vtkBoundingBox Bounds;
    bool InTiles = false;
  };
  /**
   * Whether much of what the boxes cover is covered by one at a time: otherwise it is quicker to
   * draw all rays in slices.
   */
  static bool AreWorthwhile(vtkRenderer* renderer, const std::vector<Box>& boxes);
  /** Near and far depth in a texture of the viewport's size; null if there is none. */
  vtkTextureObject* Draw(vtkRenderer* renderer, const std::vector<Box>& boxes,
    const DepthTiles& tiles, const int viewport[4]);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  FloatAccumulation Image;
  vtkNew<vtkTextureObject> Tiles;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; // without attributes
};

} // namespace nephoscope

#endif
