// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Higher-order cells as linear cells between their points, for the kinds whose neighbours do not
 * agree on the diagonals of common faces when VTK divides them: quadratic pyramids, and Lagrange
 * and Bezier hexahedra and wedges; and for those that VTK 9.2 does not divide into tetrahedra at
 * all: its Triangulate gives nothing, or wedges, for the four kinds of SplitQuadraticSolid.
 *
 * Each linear cell goes through DecomposeCell, so that faces are cut by the same rule from both
 * sides.
 */
#ifndef nephoscope_HigherOrderCells_h
#define nephoscope_HigherOrderCells_h

#include "CellDecomposition.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

/**
 * The middle of a quadratic pyramid, between the middles of its edges: two squares and eight
 * triangles.
 */
constexpr int pyramidCoreFaceList[] = { 4, 0, 1, 2, 3, 4, 4, 5, 6, 7, 3, 0, 4, 5, 3, 1, 5, 6, 3, 2,
  6, 7, 3, 3, 7, 4, 3, 0, 3, 4, 3, 1, 0, 5, 3, 2, 1, 6, 3, 3, 2, 7 };

/**
 * Calls emit(faces, points): a linear cell, and its points as the numbers that they have in the
 * quadratic pyramid.
 */
template <typename Emit>
void SplitQuadraticPyramid(Emit emit)
{
  const FaceList<int> tetrahedron = MakeFaceList(tetrahedronFaceList);
  const int corners[4][4] = { { 0, 5, 8, 9 }, { 1, 6, 5, 10 }, { 2, 7, 6, 11 }, { 3, 8, 7, 12 } };
  for (const auto& corner : corners)
  {
    emit(tetrahedron, corner);
  }
  const int top[] = { 9, 10, 11, 12, 4 };
  emit(MakeFaceList(pyramidFaceList), top);
  const int core[] = { 5, 6, 7, 8, 9, 10, 11, 12 };
  emit(MakeFaceList(pyramidCoreFaceList), core);
}

/** Eight hexahedra between the 27 points of a triquadratic one. */
template <typename Emit>
void SplitTriquadraticHexahedron(Emit emit)
{
  constexpr int lattice[3][3][3] = { { { 0, 8, 1 }, { 11, 24, 9 }, { 3, 10, 2 } },
    { { 16, 22, 17 }, { 20, 26, 21 }, { 19, 23, 18 } },
    { { 4, 12, 5 }, { 15, 25, 13 }, { 7, 14, 6 } } };
  for (int part = 0; part < 8; ++part)
  {
    const int i = part & 1, j = part >> 1 & 1, k = part >> 2;
    auto at = [&](int a, int b, int c) { return lattice[k + c][j + b][i + a]; };
    const int points[] = { at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1),
      at(1, 0, 1), at(1, 1, 1), at(0, 1, 1) };
    emit(MakeFaceList(hexahedronFaceList), points);
  }
}

/**
 * A hexahedron with points in the middle of its edges and of four faces: in each half a wedge at
 * every corner, and a hexahedron between them.
 */
template <typename Emit>
void SplitBiquadraticHexahedron(Emit emit)
{
  constexpr int corners[3][4] = { { 0, 1, 2, 3 }, { 16, 17, 18, 19 }, { 4, 5, 6, 7 } };
  constexpr int middles[3][4] = { { 8, 9, 10, 11 }, { 22, 21, 23, 20 }, { 12, 13, 14, 15 } };
  for (int half = 0; half < 2; ++half)
  {
    const int(&low)[4] = middles[half];
    const int(&high)[4] = middles[half + 1];
    for (int c = 0; c < 4; ++c)
    {
      const int before = (c + 3) % 4;
      const int wedge[] = { corners[half][c], low[c], low[before], corners[half + 1][c], high[c],
        high[before] };
      emit(MakeFaceList(wedgeFaceList), wedge);
    }
    const int core[] = { low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3] };
    emit(MakeFaceList(hexahedronFaceList), core);
  }
}

template <typename Emit>
void SplitQuadraticWedge(bool linearUpwards, Emit emit)
{
  constexpr int linear[4][6] = { { 0, 6, 8, 3, 9, 11 }, { 6, 7, 8, 9, 10, 11 },
    { 6, 1, 7, 9, 4, 10 }, { 8, 7, 2, 11, 10, 5 } };
  constexpr int quadratic[8][6] = { { 0, 6, 8, 12, 15, 17 }, { 6, 7, 8, 15, 16, 17 },
    { 6, 1, 7, 15, 13, 16 }, { 8, 7, 2, 17, 16, 14 }, { 12, 15, 17, 3, 9, 11 },
    { 15, 16, 17, 9, 10, 11 }, { 15, 13, 16, 9, 4, 10 }, { 17, 16, 14, 11, 10, 5 } };
  for (int part = 0; part < (linearUpwards ? 4 : 8); ++part)
  {
    emit(MakeFaceList(wedgeFaceList), linearUpwards ? linear[part] : quadratic[part]);
  }
}

/** Divides the cells that VTK does not divide into tetrahedra; false for all other cells. */
template <typename Emit>
bool SplitQuadraticSolid(int cellType, Emit emit)
{
  switch (cellType)
  {
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      SplitTriquadraticHexahedron(emit);
      return true;
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
      SplitBiquadraticHexahedron(emit);
      return true;
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
      SplitQuadraticWedge(cellType == VTK_QUADRATIC_LINEAR_WEDGE, emit);
      return true;
    default:
      return false;
  }
}

inline void ScalePoints(vtkPoints* points, double factor)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    points->SetPoint(i, factor * x[0], factor * x[1], factor * x[2]);
  }
  points->Modified();
}

// VTK solves systems for the triangulation of a polyhedron, and takes them for singular where edges
// are shorter than about 1e-10. Small cells are made larger for it by a power of two, which changes
// no digit.
inline bool TriangulateByVTK(vtkCell* cell, vtkIdList* ids, vtkPoints* points)
{
  constexpr double small = 1e-3;
  double bounds[6];
  cell->GetPoints()->GetBounds(bounds);
  const double length =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  const bool scaled = length > 0 && length < small;
  const double factor = scaled ? std::ldexp(1.0, -std::ilogb(length)) : 1.0;
  if (!scaled || !std::isfinite(factor))
  {
    return cell->Triangulate(0, ids, points) != 0;
  }
  ScalePoints(cell->GetPoints(), factor);
  const bool divided = cell->Triangulate(0, ids, points) != 0;
  ScalePoints(cell->GetPoints(), 1 / factor);
  ScalePoints(points, 1 / factor);
  return divided;
}

/** vtkCell::Triangulate, for cells of all kinds. */
inline bool TriangulateCell(vtkCell* cell, vtkIdList* ids, vtkPoints* points)
{
  vtkIdList* own = cell->GetPointIds();
  auto part = [&](FaceList<int> faces, const int* vertices) {
    DecomposeCell(
      faces, [&](int a, int b) { return own->GetId(vertices[a]) < own->GetId(vertices[b]); },
      [&](const std::array<int, 4>& tetrahedron) {
        for (int vertex : tetrahedron)
        {
          ids->InsertNextId(own->GetId(vertices[vertex]));
          points->InsertNextPoint(cell->GetPoints()->GetPoint(vertices[vertex]));
        }
      });
  };
  ids->Reset();
  points->Reset();
  return SplitQuadraticSolid(cell->GetCellType(), part) || TriangulateByVTK(cell, ids, points);
}

template <typename Emit>
void SplitHexahedron(vtkHigherOrderHexahedron* cell, Emit emit)
{
  const int* order = cell->GetOrder();
  for (int k = 0; k < order[2]; ++k)
  {
    for (int j = 0; j < order[1]; ++j)
    {
      for (int i = 0; i < order[0]; ++i)
      {
        auto at = [&](int a, int b, int c) { return cell->PointIndexFromIJK(i + a, j + b, k + c); };
        const int points[] = { at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1),
          at(1, 0, 1), at(1, 1, 1), at(0, 1, 1) };
        emit(MakeFaceList(hexahedronFaceList), points);
      }
    }
  }
}

template <typename Emit>
void SplitWedge(vtkHigherOrderWedge* cell, Emit emit)
{
  const int* order = cell->GetOrder();
  for (int k = 0; k < order[2]; ++k)
  {
    for (int j = 0; j < order[0]; ++j)
    {
      for (int i = 0; i + j < order[0]; ++i)
      {
        auto at = [&](int a, int b, int c) { return cell->PointIndexFromIJK(i + a, j + b, k + c); };
        const int upright[] = { at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1),
          at(0, 1, 1) };
        emit(MakeFaceList(wedgeFaceList), upright);
        if (i + j + 1 < order[0])
        {
          const int turned[] = { at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(1, 0, 1), at(1, 1, 1),
            at(0, 1, 1) };
          emit(MakeFaceList(wedgeFaceList), turned);
        }
      }
    }
  }
}

/** False for all other cells. */
template <typename Emit>
bool SplitHigherOrderCell(vtkCell* cell, Emit emit)
{
  if (cell->GetCellType() == VTK_QUADRATIC_PYRAMID)
  {
    SplitQuadraticPyramid(emit);
    return true;
  }
  if (SplitQuadraticSolid(cell->GetCellType(), emit))
  {
    return true;
  }
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    SplitHexahedron(hexahedron, emit);
    return true;
  }
  auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell);
  if (wedge && wedge->GetNumberOfPoints() != 21) // a special wedge, which has no lattice
  {
    SplitWedge(wedge, emit);
    return true;
  }
  return false;
}

} // namespace nephoscope

#endif
