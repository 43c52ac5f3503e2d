// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What shaders need of the view and of a region of space: rays through pixels, and the region's
 * planes.
 */
#ifndef nephoscope_SplatRegionUniforms_h
#define nephoscope_SplatRegionUniforms_h

#include <array>

class vtkMatrix4x4;
class vtkShaderProgram;

namespace nephoscope
{

struct SceneView;
struct SplatDrawingOptions;

/**
 * A ray through a pixel at (px, py): X = x + z px, Y = y + w py, at a depth of 1 or in a parallel
 * projection.
 */
std::array<float, 4> RayOfPixel(vtkMatrix4x4* viewToDevice, const float pixelsPerDevice[2]);

/** Those of SplatRegion.glsl and SplatInRegion.glsl; nothing where there is no region. */
void SetRegionUniforms(vtkShaderProgram* program, const SceneView& view,
  const SplatDrawingOptions& options, const float pixelsPerDevice[2]);

} // namespace nephoscope

#endif
