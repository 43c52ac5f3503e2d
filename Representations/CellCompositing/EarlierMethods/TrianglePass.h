// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Parts of CellCompositingPass for drawing tetrahedra as fans of triangles (ShirleyTuchman1990)
 * instead of back faces: other shaders, a table of opacities, and a test for tetrahedra that cannot
 * be drawn in this way.
 */
#ifndef nephoscope_TrianglePass_h
#define nephoscope_TrianglePass_h

#include "CellMethod.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMatrix4x4;

namespace nephoscope
{

class CellGeometry;

inline bool DrawsTriangles(CellMethod method)
{
  return method == CellMethod::TrianglesLinear || method == CellMethod::TrianglesTable;
}

/** Sources with the marks that CellCompositingPass fills in. */
const char* TriangleGeometryShader();
const char* TriangleFragmentShader();
/** The shader with the marks filled in that are those of the triangles alone. */
std::string WithTriangleShaders(const char* shader);

/**
 * A vertex nearer to the plane of the eye than this counts as not projectable: a tenth of the near
 * plane's distance.
 */
double SmallestEyeDepth(const double eyeView[4], vtkMatrix4x4* viewToDevice);

/** How many of the drawn tetrahedra have such a vertex: they are left out. */
std::int64_t CountUnprojected(const CellGeometry& geometry, const std::vector<std::int32_t>& drawn,
  vtkMatrix4x4* modelToView, const double eyeView[4], vtkMatrix4x4* viewToDevice);

} // namespace nephoscope

#endif
