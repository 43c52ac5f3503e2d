// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Triangles that bound a mesh of tetrahedra, where rays enter it. */
#ifndef nephoscope_BoundaryFaces_h
#define nephoscope_BoundaryFaces_h

#include "CellGeometry.h"
#include "ChessboardGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace nephoscope
{

/** Three vertices, and what is inside: a vertex, or a tetrahedron. */
using BoundaryFace = std::array<std::int32_t, 4>;

/** False for a face that cannot be distinguished from an edge in pixels or in float. */
inline bool HasExtent(const CellGeometry& geometry, const BoundaryFace& face)
{
  const Vector3 a = geometry.Position(face[0]), b = geometry.Position(face[1]),
                c = geometry.Position(face[2]);
  const Vector3 edges[3] = { Difference(b, a), Difference(c, b), Difference(a, c) };
  const Vector3 normal = Cross(edges[0], edges[1]);
  const double longest =
    std::max({ Dot(edges[0], edges[0]), Dot(edges[1], edges[1]), Dot(edges[2], edges[2]) });
  double largest = 0;
  for (const Vector3& p : { a, b, c })
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  constexpr double thinnest = 1e-6; // height by length
  const double rounding = 0.5 * std::numeric_limits<float>::epsilon() * largest;
  return Dot(normal, normal) >
    longest * std::min(rounding * rounding, thinnest * thinnest * longest);
}

/**
 * Makes the first three vertices run counterclockwise as seen from outside. The first one stays.
 * Returns false if `inside` is so near their plane that the side on which it lies is a matter of
 * rounding.
 */
inline bool TurnOutwards(const CellGeometry& geometry, BoundaryFace& face, const Vector3& inside)
{
  const Vector3 a = geometry.Position(face[0]);
  const Vector3 normal =
    Cross(Difference(geometry.Position(face[1]), a), Difference(geometry.Position(face[2]), a));
  const Vector3 inwards = Difference(inside, a);
  const double height = Dot(normal, inwards);
  if (height > 0)
  {
    std::swap(face[1], face[2]);
  }
  constexpr double rounding = 1e-4;
  return height * height > rounding * rounding * Dot(normal, normal) * Dot(inwards, inwards);
}

/** The same, the fourth vertex being inside. */
inline bool TurnOutwards(const CellGeometry& geometry, BoundaryFace& face)
{
  return TurnOutwards(geometry, face, geometry.Position(face[3]));
}

/** The mean of the vertices of a cell of the grid. */
inline Vector3 MiddleOfCell(const CellGeometry& geometry, const std::array<int, 3>& cell)
{
  Vector3 sum{ { 0, 0, 0 } };
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 p = geometry.Position(static_cast<std::int32_t>(geometry.Grid.PointNumber(
      cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1))));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum[axis] += p[axis] / 8;
    }
  }
  return sum;
}

/** Cells from `Low` to `High` along each axis, both included. */
struct CellBox
{
  int Low[3] = { 0, 0, 0 };
  int High[3] = { -1, -1, -1 };

  bool IsEmpty() const { return this->High[0] < this->Low[0]; }
  bool Contains(const std::array<std::int32_t, 4>& cell) const
  {
    return cell[0] >= this->Low[0] && cell[0] <= this->High[0] && cell[1] >= this->Low[1] &&
      cell[1] <= this->High[1] && cell[2] >= this->Low[2] && cell[2] <= this->High[2];
  }
  /** It covers the whole of a grid that closes along the first axis. */
  bool IsClosed(const ChessboardGrid& grid) const
  {
    return grid.WrapCells > 0 && this->Low[0] == 0 && this->High[0] == grid.WrapCells - 1;
  }
};

/**
 * The boundary of a box of cells of a structured grid: of each face the odd vertex, the two others,
 * and the vertex inside.
 */
inline std::vector<BoundaryFace> ChessboardBoundary(
  const CellGeometry& geometry, const CellBox& box)
{
  const ChessboardGrid& grid = geometry.Grid;
  std::vector<BoundaryFace> faces;
  // Triangles of a cell's face: the corner tetrahedra at its odd vertices.
  const auto addSide = [&](const std::array<int, 3>& cell, int axis, int end) {
    for (const auto& t : grid.CornerTetrahedra(cell))
    {
      if (t.Corner[axis] == end)
      {
        const std::array<std::int64_t, 3> others = t.Across(axis);
        BoundaryFace face = { { std::int32_t(t.Odd), std::int32_t(others[0]),
          std::int32_t(others[1]), std::int32_t(others[2]) } };
        if (!TurnOutwards(geometry, face)) // at an axis where vertices coincide
        {
          TurnOutwards(geometry, face, MiddleOfCell(geometry, cell));
        }
        faces.push_back(face);
      }
    }
  };
  for (int axis = 0; axis < 3 && !box.IsEmpty(); ++axis)
  {
    const int first = axis == 0 ? 1 : 0;
    const int second = axis == 2 ? 1 : 2;
    for (int end = 0; end < 2 && !(axis == 0 && box.IsClosed(grid)); ++end)
    {
      std::array<int, 3> cell;
      cell[axis] = end ? box.High[axis] : box.Low[axis];
      for (cell[second] = box.Low[second]; cell[second] <= box.High[second]; ++cell[second])
      {
        for (cell[first] = box.Low[first]; cell[first] <= box.High[first]; ++cell[first])
        {
          addSide(cell, axis, end);
        }
      }
    }
  }
  return faces;
}

} // namespace nephoscope

#endif
