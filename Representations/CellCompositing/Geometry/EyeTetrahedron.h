// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The tetrahedron that holds the eye, where all rays start when the camera is inside the mesh. */
#ifndef EyeTetrahedron_h
#define EyeTetrahedron_h

#include "CellGeometry.h"
#include "TetrahedronNeighbors.h"

#include <array>
#include <cstdint>

namespace nephoscope
{

struct EyeTetrahedron
{
  bool Found = false;
  std::array<std::int32_t, 4> Vertices = { { 0, 0, 0, 0 } };
  /** Where a walk is: the tetrahedron (x); or the cell of a grid, and its odd vertex or -1 (w). */
  std::array<std::int32_t, 4> Place = { { 0, 0, 0, 0 } };
  float Scalar = 0;  ///< at the eye
  float Opacity = 0; ///< second scalar at the eye, where there is one per point
};

/** Looks at all tetrahedra, in parallel, unless the eye is outside of all points or infinitely far (eye w = 0). */
EyeTetrahedron findEyeTetrahedron(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors, const Vector4& eye);

} // namespace nephoscope

#endif
