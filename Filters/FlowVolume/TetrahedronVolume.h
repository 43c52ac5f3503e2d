// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume of a tetrahedron of a mesh. Plain C++17.
#ifndef nephoscope_TetrahedronVolume_h
#define nephoscope_TetrahedronVolume_h

#include "PrismTetrahedra.h"
#include "SmokeGeometry.h"

#include <vector>

namespace nephoscope
{
inline double VolumeOf(const TetrahedronPoints& tetrahedron, const std::vector<Vector3>& points)
{
  const auto corner = [&](std::size_t i) -> const Vector3& {
    return points[static_cast<std::size_t>(tetrahedron[i])];
  };
  return signedVolume(corner(0), corner(1), corner(2), corner(3));
}
}

#endif
