// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tetrahedron that holds the eye, where all rays start when the camera is inside the mesh.
 *
 * A camera often stands exactly on a face, an edge or a vertex: on a plane of the grid, at a pole,
 * on the boundary. Then no single tetrahedron holds the eye. All rays therefore start at a position
 * that lies inside one of the tetrahedra that touch the eye, by `eyeClearance` of the mesh's radius
 * from each of its faces: too near to be visible, yet far enough to distinguish the sides in float.
 */
#ifndef nephoscope_EyeTetrahedron_h
#define nephoscope_EyeTetrahedron_h

#include "CellGeometry.h"
#include "TetrahedronNeighbors.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

/**
 * Distance that the start of the rays keeps from the faces around it, as a fraction of the mesh's
 * radius: 64 roundings to float.
 */
constexpr double eyeClearance = 1.0 / (1 << 18);

struct EyeTetrahedron
{
  bool Found = false;
  /** Where the rays start: the eye itself, unless it lies nearer to a face. */
  std::array<double, 3> Start = { { 0, 0, 0 } };
  std::array<std::int32_t, 4> Vertices = { { 0, 0, 0, 0 } }; ///< corners of a divided hexahedron
  /**
   * Where a walk is: the tetrahedron (x) and the result of FindOneNeighbor (y, z); the hexahedron
   * (x); or the cell of a grid or a divided hexahedron (x), and its odd vertex or -1 (w).
   */
  std::array<std::int32_t, 4> Place = { { 0, 0, 0, 0 } };
  /** The same of the hexahedron, with its bent faces, that holds the start. */
  std::array<std::int32_t, 4> Hexahedron = { { 0, 0, 0, 0 } };
  std::array<float, 4> Weights = { { 0, 0, 0, 0 } }; ///< of the vertices, at the start
  float Scalar = 0;                                  ///< at the start
  float Opacity = 0; ///< second scalar at the start, where there is one per point
  std::vector<EyeTetrahedron> Overlapping; ///< where parts of a mesh overlap: others in which the
                                           ///< start lies, one of each part
};

/**
 * Tests all tetrahedra in parallel, unless the eye is outside the bounds of all points or
 * infinitely far (eye w = 0); then it finds nothing.
 */
EyeTetrahedron FindEyeTetrahedron(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors, const Vector4& eye);

} // namespace nephoscope

#endif
