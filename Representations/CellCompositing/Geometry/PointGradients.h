// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Gradients of a point scalar over a mesh, by least squares.
 *
 * At a point p the gradient g minimises the sum of ((x_j - x_p) . g - (s_j - s_p))^2 / |x_j -
 * x_p|^2 over the ends j of the edges of the cells around p; a field that is linear around p is
 * reproduced. The edges are those of VTK's cells, whatever tetrahedra these are divided into: in an
 * image, the gradient is the central difference. Points with the same coordinates are one, so that
 * the gradient is continuous over the seam of a globe and between blocks. Where the neighbours do
 * not span space (a tetrahedron that is nearly flat), the gradient is 0.
 */
#ifndef nephoscope_PointGradients_h
#define nephoscope_PointGradients_h

#include "Vector3.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

class CellGeometry;

/**
 * The point array that has the gradients already where other ranks have some of the cells around a
 * point.
 */
constexpr const char* storedGradientsName = "NephoscopeContourGradients";
/** The field array that then has the least and the greatest of the values on all ranks. */
constexpr const char* storedContourRangeName = "NephoscopeContourRange";

/**
 * The normal equations of the least squares at a point, m g = r with a symmetric m: sums over
 * edges.
 */
struct GradientSums
{
  double XX = 0, XY = 0, XZ = 0, YY = 0, YZ = 0, ZZ = 0;
  Vector3 Right = { { 0, 0, 0 } };

  /** An edge, from either end: its difference of positions and of scalars. */
  void Add(const Vector3& d, double change);
  void Add(const GradientSums& others)
  {
    this->XX += others.XX;
    this->XY += others.XY;
    this->XZ += others.XZ;
    this->YY += others.YY;
    this->YZ += others.YZ;
    this->ZZ += others.ZZ;
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Right[c] += others.Right[c];
    }
  }
  /** The gradient. */
  Vector3 Solve() const;
};

/**
 * One for each place of `places`, as FindPlaces has them; `geometry` gives the positions of the
 * points, `scalars` one value for each.
 */
std::vector<GradientSums> SumGradients(vtkDataSet* data, const CellGeometry& geometry,
  const std::vector<float>& scalars, const std::vector<std::int32_t>& places);

/** One per point. */
std::vector<std::array<float, 4>> PointGradients(
  vtkDataSet* data, const CellGeometry& geometry, const std::vector<float>& scalars);

} // namespace nephoscope

#endif
