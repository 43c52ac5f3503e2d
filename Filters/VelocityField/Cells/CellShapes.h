// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions in the cells that most meshes are made of. Plain C++17.
#ifndef nephoscope_CellShapes_h
#define nephoscope_CellShapes_h

#include "TrilinearMap.h"

namespace nephoscope
{
// The barycentric coordinates of a position; false if it is outside by more than rounding.
inline bool WeightsInTetrahedron(const Vector3 (&p)[4], const Vector3& x, double* weights)
{
  const auto from = [&](const Vector3& a) {
    return Vector3{ a[0] - x[0], a[1] - x[1], a[2] - x[2] };
  };
  const Vector3 a = from(p[0]);
  const Vector3 b = from(p[1]);
  const Vector3 c = from(p[2]);
  const Vector3 d = from(p[3]);
  const Vector3 ab = Cross(a, b);
  const Vector3 cd = Cross(c, d);
  // Six times the volumes of the tetrahedra that x makes with the faces.
  weights[0] = -Dot(b, cd);
  weights[1] = Dot(a, cd);
  weights[2] = -Dot(d, ab);
  weights[3] = Dot(c, ab);
  const double sum = weights[0] + weights[1] + weights[2] + weights[3];
  bool inside = sum != 0.0;
  for (int i = 0; i < 4; ++i)
  {
    weights[i] /= sum;
    inside = inside && weights[i] >= -PARAMETRIC_TOLERANCE;
  }
  return inside;
}

// The weights of the corners in VTK's order of a hexahedron, or that of a voxel.
inline bool WeightsInHexahedron(
  const Vector3 (&p)[8], bool voxel, const Vector3& x, Vector3& parametric, double* weights)
{
  constexpr std::array<std::int64_t, 8> voxelOrder = { 0, 1, 2, 3, 4, 5, 6, 7 };
  constexpr std::array<std::int64_t, 8> hexahedronOrder = { 0, 1, 3, 2, 4, 5, 7, 6 };
  const auto& order = voxel ? voxelOrder : hexahedronOrder;
  const TrilinearMap map(p[0].data(), order, x);
  if (map.Invert(parametric) != InverseResult::Inside)
  {
    return false;
  }
  const auto trilinear = TrilinearWeights(parametric);
  for (std::size_t e = 0; e < 8; ++e)
  {
    weights[order[e]] = trilinear[e];
  }
  return true;
}
}

#endif
