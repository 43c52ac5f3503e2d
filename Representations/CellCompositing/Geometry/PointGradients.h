// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Gradients of a point scalar over a mesh of tetrahedra or hexahedra, by least squares.
 *
 * At a point p the gradient g minimises the sum of ((x_j - x_p) . g - (s_j - s_p))^2 / |x_j - x_p|^2 over the ends j of edges of the cells
 * around p; a field that is linear around p is reproduced. Points with the same coordinates are one, so that the gradient is continuous
 * over the seam of a globe and between blocks. Where the neighbours do not span space (a tetrahedron that is nearly flat), the gradient
 * is 0.
 */
#ifndef PointGradients_h
#define PointGradients_h

#include <array>
#include <vector>

namespace nephoscope
{

class CellGeometry;

/** One per point; `scalars` has one per point too. The result does not depend on the number of threads. */
std::vector<std::array<float, 4>> pointGradients(
  const CellGeometry& geometry, const std::vector<float>& scalars);

} // namespace nephoscope

#endif
