// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Higher-order cells as linear cells between their points, for the kinds whose neighbours do not agree on the diagonals of common
 * faces when VTK divides them: quadratic pyramids, and Lagrange and Bezier hexahedra and wedges.
 *
 * Each linear cell goes through decomposeCell, so that faces are cut by the same rule from both sides.
 */
#ifndef HigherOrderCells_h
#define HigherOrderCells_h

#include "CellDecomposition.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderWedge.h"

#include <array>

namespace nephoscope
{

/** The middle of a quadratic pyramid, between the middles of its edges: two squares and eight triangles. */
constexpr int pyramidCoreFaceList[] = { 4, 0, 1, 2, 3, 4, 4, 5, 6, 7, 3, 0, 4, 5, 3, 1, 5, 6, 3, 2,
  6, 7, 3, 3, 7, 4, 3, 0, 3, 4, 3, 1, 0, 5, 3, 2, 1, 6, 3, 3, 2, 7 };

/** Calls emit(faces, points): a linear cell, and its points as the numbers that they have in the quadratic pyramid. */
template <typename Emit>
void splitQuadraticPyramid(Emit emit)
{
  const FaceList<int> tetrahedron = makeFaceList(tetrahedronFaceList);
  const int corners[4][4] = { { 0, 5, 8, 9 }, { 1, 6, 5, 10 }, { 2, 7, 6, 11 }, { 3, 8, 7, 12 } };
  for (const auto& corner : corners)
  {
    emit(tetrahedron, corner);
  }
  const int top[] = { 9, 10, 11, 12, 4 };
  emit(makeFaceList(pyramidFaceList), top);
  const int core[] = { 5, 6, 7, 8, 9, 10, 11, 12 };
  emit(makeFaceList(pyramidCoreFaceList), core);
}

template <typename Emit>
void splitHexahedron(vtkHigherOrderHexahedron* cell, Emit emit)
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
        emit(makeFaceList(hexahedronFaceList), points);
      }
    }
  }
}

template <typename Emit>
void splitWedge(vtkHigherOrderWedge* cell, Emit emit)
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
        emit(makeFaceList(wedgeFaceList), upright);
        if (i + j + 1 < order[0])
        {
          const int turned[] = { at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(1, 0, 1), at(1, 1, 1),
            at(0, 1, 1) };
          emit(makeFaceList(wedgeFaceList), turned);
        }
      }
    }
  }
}

/** False for all other cells. */
template <typename Emit>
bool splitHigherOrderCell(vtkCell* cell, Emit emit)
{
  if (cell->GetCellType() == VTK_QUADRATIC_PYRAMID)
  {
    splitQuadraticPyramid(emit);
    return true;
  }
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    splitHexahedron(hexahedron, emit);
    return true;
  }
  auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell);
  if (wedge && wedge->GetNumberOfPoints() != 21) // a special wedge, which has no lattice
  {
    splitWedge(wedge, emit);
    return true;
  }
  return false;
}

} // namespace nephoscope

#endif
