// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The faces of a tetrahedron, on which side of them a point lies, and its volume. Plain C++17. */
#ifndef nephoscope_Tetrahedron_h
#define nephoscope_Tetrahedron_h

#include "Vector3.h"

namespace nephoscope
{

/** Vertices of the face opposite each vertex. */
constexpr int tetrahedronFaces[4][3] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };

/**
 * The side of the plane of triangle (a, b, c) on which the homogeneous point e lies, as the sign of
 * a number; 0 on the plane.
 */
inline double PlaneSide(const Vector3& a, const Vector3& b, const Vector3& c, const Vector4& e)
{
  const Vector3 normal = Cross(Difference(b, a), Difference(c, a));
  return Dot(normal, { e[0] - e[3] * a[0], e[1] - e[3] * a[1], e[2] - e[3] * a[2] });
}

/**
 * Positive if b, c, d are counter-clockwise seen from the far side of a, as VTK numbers a
 * tetrahedron.
 */
inline double SignedVolume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return TripleProduct(b - a, c - a, d - a) / 6.0;
}

} // namespace nephoscope

#endif
