// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh of hexahedra as a ray walks through it: 24 bytes of neighbours beside the 32 of vertices.
 *
 * A neighbour is one number: its cell, how the face lies in it, and whether the ray finds other
 * points there, at the same places. How the face lies: which of its vertices is that of the first
 * end of both axes of the face in this cell, and along which axes of the neighbour these two run.
 */
#ifndef nephoscope_HexahedronNeighbors_h
#define nephoscope_HexahedronNeighbors_h

#include "CellGeometry.h"
#include "TetrahedronNeighbors.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace nephoscope
{

constexpr std::int64_t mostLinkedHexahedra = std::numeric_limits<std::int32_t>::max() / 96;
constexpr std::int64_t mostDividedHexahedra = std::numeric_limits<std::int32_t>::max() / 128;

/**
 * Neighbours and boundary faces of the hexahedra. Points at one place get the position of the first
 * of them. `third`: as for TetrahedronNeighbors::Build, for divided hexahedra. False when stopped.
 */
bool FindHexahedronNeighbors(CellGeometry& geometry, TetrahedronNeighbors& neighbors,
  const std::vector<float>& third = {}, const Progress& progress = {});

} // namespace nephoscope

#endif
