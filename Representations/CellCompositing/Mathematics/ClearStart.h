// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A position near the eye that is clear of the faces of a tetrahedron that the eye lies in, on or
 * beside.
 *
 * With the heights h_i of the tetrahedron and barycentric coordinates lambda_i, a point lies
 * lambda_i h_i inside of face i. The centre of the inscribed sphere lies r = 1 / sum(1 / h_i)
 * inside of each. Between the eye and that centre all four distances change linearly, so the first
 * point where all reach the clearance wanted, or half of r in a smaller tetrahedron, is known.
 */
#ifndef nephoscope_ClearStart_h
#define nephoscope_ClearStart_h

#include "TetrahedronRay.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{

struct ClearStart
{
  bool Found = false; ///< false: the eye is farther outside than the clearance, or the tetrahedron
                      ///< has no volume
  Vector3 Position = { { 0, 0, 0 } };
  Vector4 Weights = { { 0, 0, 0, 0 } }; ///< its barycentric coordinates
  double Clearance = 0; ///< its distance from the nearest face, at most the one wanted
  double Moved = 0;     ///< its distance from the eye
};

/**
 * Distance of each vertex from the face opposite it; 0, infinite or NaN in a tetrahedron without
 * volume.
 */
inline Vector4 Heights(const std::array<Vector3, 4>& p)
{
  Vector4 h;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const auto& f = tetrahedronFaces[i];
    const Vector3 normal = Cross(Difference(p[f[1]], p[f[0]]), Difference(p[f[2]], p[f[0]]));
    h[i] = std::abs(Dot(normal, Difference(p[i], p[f[0]]))) / std::sqrt(Dot(normal, normal));
  }
  return h;
}

inline ClearStart FindClearStart(
  const std::array<Vector3, 4>& p, const Vector4& eye, double clearance)
{
  ClearStart start;
  const Vector4 h = Heights(p);
  const double inscribed = 1.0 / (1.0 / h[0] + 1.0 / h[1] + 1.0 / h[2] + 1.0 / h[3]);
  if (!(inscribed > 0) || !std::isfinite(inscribed))
  {
    return start;
  }
  const Vector4 q = EyeCoordinates(p, eye);
  const double wanted = std::min(clearance, inscribed / 2);
  double way = 0; // from the eye to the centre of the inscribed sphere
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double inside = q[i] * h[i];
    if (!(inside >= -clearance))
    {
      return start;
    }
    if (inside < wanted)
    {
      way = std::max(way, (wanted - inside) / (inscribed - inside));
    }
  }
  start.Found = true;
  start.Clearance = wanted;
  start.Position = { { eye[0], eye[1], eye[2] } };
  start.Weights = q;
  if (way > 0)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      start.Weights[i] = q[i] + way * (inscribed / h[i] - q[i]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      start.Position[axis] = start.Weights[0] * p[0][axis] + start.Weights[1] * p[1][axis] +
        start.Weights[2] * p[2][axis] + start.Weights[3] * p[3][axis];
    }
    const Vector3 moved = Difference(start.Position, { { eye[0], eye[1], eye[2] } });
    start.Moved = std::sqrt(Dot(moved, moved));
  }
  return start;
}

} // namespace nephoscope

#endif
