// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells as hexahedra, of which vertices may coincide: a wedge is a hexahedron two edges of which have no length, a pyramid one of which a
 * face is a point. The trilinear field of such a hexahedron is the field of VTK's cell.
 *
 * Vertices are numbered by bits (x = 1, y = 2, z = 4), faces by axis and end: 2 * axis + end.
 */
#ifndef HexahedronCells_h
#define HexahedronCells_h

#include "vtkCellType.h"

#include <array>
#include <cstdint>

namespace nephoscope
{

using Hexahedron = std::array<std::int32_t, 8>;

struct HexahedronForm
{
  int Tetrahedra; ///< into how many the cell is divided where it is; 0: it is no such cell
  std::array<int, 8> Vertices;
};

inline HexahedronForm hexahedronForm(int cellType)
{
  switch (cellType)
  {
    case VTK_HEXAHEDRON:
      return { 6, { { 0, 1, 3, 2, 4, 5, 7, 6 } } };
    case VTK_VOXEL:
      return { 6, { { 0, 1, 2, 3, 4, 5, 6, 7 } } };
    case VTK_WEDGE:
      return { 3, { { 0, 1, 2, 2, 3, 4, 5, 5 } } };
    case VTK_PYRAMID:
      return { 2, { { 0, 1, 3, 2, 4, 4, 4, 4 } } };
    case VTK_TETRA:
      return { 1, { { 0, 1, 2, 2, 3, 3, 3, 3 } } };
    default:
      return { 0, {} };
  }
}

/** Vertices of a face: at the ends of the two other axes, the first of which changes first. */
inline std::array<std::size_t, 4> hexahedronFace(int face)
{
  const std::size_t axis = std::size_t(1) << (face >> 1);
  const std::size_t first = axis == 1 ? 2 : 1, second = axis == 4 ? 2 : 4;
  const std::size_t at = (face & 1) != 0 ? axis : 0;
  return { { at, at | first, at | second, at | first | second } };
}

/** Six tetrahedra around the diagonal from the first vertex to the last. */
inline std::array<std::size_t, 4> hexahedronPart(int part)
{
  const std::size_t first = std::size_t(1) << (part >> 1);
  const std::size_t second = std::size_t(1) << (((part >> 1) + 1 + (part & 1)) % 3);
  return { { 0, first, first | second, 7 } };
}

} // namespace nephoscope

#endif
