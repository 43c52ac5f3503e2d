// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's cells as hexahedra, of which vertices may coincide. Vertices are numbered by bits (x = 1, y
// = 2, z = 4).
#ifndef nephoscope_HexahedronForm_h
#define nephoscope_HexahedronForm_h

#include "vtkCellType.h"

#include <array>

namespace nephoscope
{

struct HexahedronForm
{
  int Tetrahedra; ///< into how many the cell is divided where it is; 0: it is no such cell
  std::array<int, 8> Vertices;
};

inline HexahedronForm HexahedronFormOf(int cellType)
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

} // namespace nephoscope

#endif
