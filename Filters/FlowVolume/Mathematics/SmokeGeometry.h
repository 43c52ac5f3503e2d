// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Lengths, areas and volumes of flow volumes. Volumes are taken from differences of positions, so
// that they keep their digits far from the origin (a globe in metres). Plain C++17.
#ifndef nephoscope_SmokeGeometry_h
#define nephoscope_SmokeGeometry_h

#include "PrismTetrahedra.h"
#include "Tetrahedron.h"
#include "VelocityField.h"

#include <vector>

namespace nephoscope
{
inline Vector3 Midpoint(const Vector3& a, const Vector3& b)
{
  return 0.5 * (a + b);
}

// Area times normal; the triangle is counter-clockwise seen from the normal's tip.
inline Vector3 AreaVector(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return 0.5 * Cross(b - a, c - a);
}

inline double VolumeOf(const TetrahedronPoints& tetrahedron, const std::vector<Vector3>& points)
{
  const auto corner = [&](std::size_t i) -> const Vector3& {
    return points[static_cast<std::size_t>(tetrahedron[i])];
  };
  return SignedVolume(corner(0), corner(1), corner(2), corner(3));
}

// Volume flow out of the side a b c d, taken from the origin, as the mean over both of its
// diagonals. That mean is the centre of the corners times the vector area of the (skew)
// quadrilateral, 1/2 (c - a) x (d - b), over 3.
inline double SideVolume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return Dot(a + b + c + d, Cross(c - a, d - b)) / 24.0;
}

// Volume of a prism with bilinear sides, by the divergence theorem; second order in the step where
// the tetrahedra of one diagonal are first order. Vertices as in PrismPoints, of which some may
// coincide.
inline double PrismVolume(const Vector3& p0, const Vector3& p1, const Vector3& p2,
  const Vector3& p3, const Vector3& p4, const Vector3& p5)
{
  const Vector3 o{};
  const Vector3 a = p1 - p0, b = p2 - p0, c = p3 - p0, d = p4 - p0, e = p5 - p0;
  // The bottom contains the origin p0 and adds nothing.
  return Dot(c, Cross(d, e)) / 6.0 + SideVolume(o, a, d, c) + SideVolume(a, b, e, d) +
    SideVolume(b, o, c, e);
}
}

#endif
