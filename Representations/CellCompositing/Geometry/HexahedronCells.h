// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells as hexahedra whose vertices may coincide: a wedge is a hexahedron with two edges of length
 * 0, and a pyramid one with a face collapsed to a point. The trilinear field of such a hexahedron
 * is the field of VTK's cell.
 *
 * Vertices are numbered by bits (x = 1, y = 2, z = 4), faces by axis and end: 2 * axis + end.
 */
#ifndef nephoscope_HexahedronCells_h
#define nephoscope_HexahedronCells_h

#include "HexahedronForm.h"

#include <array>
#include <cstdint>

namespace nephoscope
{

using Hexahedron = std::array<std::int32_t, 8>;

/** Vertices of a face: at the ends of the two other axes, the first of which changes first. */
inline std::array<std::size_t, 4> HexahedronFace(int face)
{
  const std::size_t axis = std::size_t(1) << (face >> 1);
  const std::size_t first = axis == 1 ? 2 : 1, second = axis == 4 ? 2 : 4;
  const std::size_t at = (face & 1) != 0 ? axis : 0;
  return { { at, at | first, at | second, at | first | second } };
}

/** Six tetrahedra around the diagonal from the first vertex to the last. */
inline std::array<std::size_t, 4> HexahedronPart(int part)
{
  const std::size_t first = std::size_t(1) << (part >> 1);
  const std::size_t second = std::size_t(1) << (((part >> 1) + 1 + (part & 1)) % 3);
  return { { 0, first, first | second, 7 } };
}

/** True for vertices with an odd number of bits. */
inline bool IsOddCorner(std::size_t corner)
{
  return ((corner ^ corner >> 1 ^ corner >> 2) & 1) != 0;
}

/**
 * Five tetrahedra, as ChessboardGrid.h divides a cell whose first vertex is even: that of the even
 * vertices, and one at each odd vertex, which comes first.
 */
inline std::array<std::size_t, 4> ChessboardPart(int part)
{
  constexpr std::array<std::size_t, 4> odd = { { 1, 2, 4, 7 } };
  if (part == 0)
  {
    return { { 0, 3, 5, 6 } };
  }
  const std::size_t o = odd[static_cast<std::size_t>(part - 1)];
  return { { o, o ^ 1, o ^ 2, o ^ 4 } };
}

} // namespace nephoscope

#endif
