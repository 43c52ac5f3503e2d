// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The corners, edges and tetrahedra of VTK's linear solids. Plain C++17.
#ifndef nephoscope_CellKinds_h
#define nephoscope_CellKinds_h

#include "CellMoments.h"

namespace nephoscope
{
// Which corners each corner has an edge to, and tetrahedra that fill the cell.
struct CellKind
{
  int Corners;
  int Neighbors[8][3];
  int NumberOfTetrahedra;
  int Tetrahedra[6][4];
};

constexpr CellKind tetrahedron{ 4, { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } }, 1,
  { { 0, 1, 2, 3 } } };
constexpr CellKind hexahedron{ 8,
  { { 1, 3, 4 }, { 0, 2, 5 }, { 1, 3, 6 }, { 0, 2, 7 }, { 0, 5, 7 }, { 1, 4, 6 }, { 2, 5, 7 },
    { 3, 4, 6 } },
  6,
  { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 },
    { 0, 5, 1, 6 } } };
// In the order of the points in their middles, where there are any.
constexpr int hexahedronEdges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
  { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
constexpr CellKind wedge{ 6,
  { { 1, 2, 3 }, { 0, 2, 4 }, { 0, 1, 5 }, { 0, 4, 5 }, { 1, 3, 5 }, { 2, 3, 4 } }, 3,
  { { 0, 1, 2, 5 }, { 0, 1, 5, 4 }, { 0, 4, 5, 3 } } };

// By both diagonals of its base, so that it counts twice.
constexpr CellKind pyramid{ 5, {}, 4,
  { { 0, 1, 2, 4 }, { 0, 2, 3, 4 }, { 0, 1, 3, 4 }, { 1, 2, 3, 4 } } };

inline CellMoments MomentsOf(const CellKind& kind, const Vector3* x)
{
  CellMoments moments(x[0]);
  for (int t = 0; t < kind.NumberOfTetrahedra; ++t)
  {
    const int* c = kind.Tetrahedra[t];
    moments.AddTetrahedron(x[c[0]], x[c[1]], x[c[2]], x[c[3]]);
  }
  return moments;
}

// Faces of a hexahedron, from each of their edges on, and the corners on the other side.
constexpr int collapsed[12][8] = { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 1, 2, 3, 0, 5, 6, 7, 4 },
  { 2, 3, 0, 1, 6, 7, 4, 5 }, { 3, 0, 1, 2, 7, 4, 5, 6 }, { 0, 4, 5, 1, 3, 7, 6, 2 },
  { 4, 5, 1, 0, 7, 6, 2, 3 }, { 5, 1, 0, 4, 6, 2, 3, 7 }, { 1, 0, 4, 5, 2, 3, 7, 6 },
  { 0, 3, 7, 4, 1, 2, 6, 5 }, { 3, 7, 4, 0, 2, 6, 5, 1 }, { 7, 4, 0, 3, 6, 5, 1, 2 },
  { 4, 0, 3, 7, 5, 1, 2, 6 } };
}

#endif
