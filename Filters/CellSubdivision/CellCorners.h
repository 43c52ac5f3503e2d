// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a hexahedron, wedge or pyramid folds over itself, and the order of its points in which it
 * does not.
 *
 * At each corner the edges to its three neighbours span a volume, the Jacobian there. All have one
 * sign in a cell that does not fold; a negative sign is that of a cell that is numbered inside out,
 * which is drawn like any other.
 */
#ifndef nephoscope_CellCorners_h
#define nephoscope_CellCorners_h

#include "Vector3.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{

enum class CellShape
{
  Whole,
  Misnumbered, ///< as it is numbered, it folds; in another order of its points it does not
  Folded
};

/**
 * A corner, and its neighbours, counterclockwise as seen from inside or, in a cell that is inside
 * out, from outside.
 */
using CellCorner = std::array<int, 4>;

struct CellCorners
{
  const CellCorner* Begin = nullptr;
  const CellCorner* End = nullptr;
};

constexpr CellCorner hexahedronCorners[] = { { 0, 1, 3, 4 }, { 1, 2, 0, 5 }, { 2, 3, 1, 6 },
  { 3, 0, 2, 7 }, { 4, 7, 5, 0 }, { 5, 4, 6, 1 }, { 6, 5, 7, 2 }, { 7, 6, 4, 3 } };
constexpr CellCorner voxelCorners[] = { { 0, 1, 2, 4 }, { 1, 3, 0, 5 }, { 3, 2, 1, 7 },
  { 2, 0, 3, 6 }, { 4, 6, 5, 0 }, { 5, 4, 7, 1 }, { 7, 5, 6, 3 }, { 6, 7, 4, 2 } };
constexpr CellCorner wedgeCorners[] = { { 0, 1, 2, 3 }, { 1, 2, 0, 4 }, { 2, 0, 1, 5 },
  { 3, 5, 4, 0 }, { 4, 3, 5, 1 }, { 5, 4, 3, 2 } };
constexpr CellCorner pyramidCorners[] = { { 0, 1, 3, 4 }, { 1, 2, 0, 4 }, { 2, 3, 1, 4 },
  { 3, 0, 2, 4 } };

/** None for cells that cannot fold, or of which this is not known. */
inline CellCorners CellCornersOf(int cellType)
{
  switch (cellType)
  {
    case VTK_HEXAHEDRON:
      return { std::begin(hexahedronCorners), std::end(hexahedronCorners) };
    case VTK_VOXEL:
      return { std::begin(voxelCorners), std::end(voxelCorners) };
    case VTK_WEDGE:
      return { std::begin(wedgeCorners), std::end(wedgeCorners) };
    case VTK_PYRAMID:
      return { std::begin(pyramidCorners), std::end(pyramidCorners) };
    default:
      return {};
  }
}

/** Jacobians at the corners, as parts of the largest. */
struct CornerJacobians
{
  static constexpr double Rounding = 1e-3;
  double Largest = 0; ///< itself
  double Least = 1;   ///< negative: the cell folds
  std::size_t Corners = 0;
  std::size_t Flat =
    0; ///< corners of no volume but for rounding; without those where vertices coincide
};

/** `at(vertex)` is the place of a vertex of the cell. */
template <typename At>
CornerJacobians FindCornerJacobians(const CellCorners& corners, At at)
{
  std::array<double, 8> jacobians;
  double sum = 0;
  std::size_t collapsed = 0;
  CornerJacobians result;
  for (const CellCorner* corner = corners.Begin; corner != corners.End; ++corner)
  {
    constexpr Vector3 none{};
    const Vector3& x = at((*corner)[0]);
    const Vector3 a = at((*corner)[1]) - x, b = at((*corner)[2]) - x, c = at((*corner)[3]) - x;
    const double jacobian = TripleProduct(a, b, c);
    collapsed +=
      jacobian == 0 && (a == none || b == none || c == none || a == b || b == c || c == a);
    jacobians[result.Corners++] = jacobian;
    sum += jacobian;
    result.Largest = std::max(result.Largest, std::abs(jacobian));
  }
  for (std::size_t i = 0; i < result.Corners && result.Largest > 0; ++i)
  {
    const double part = (sum < 0 ? -jacobians[i] : jacobians[i]) / result.Largest;
    result.Least = std::min(result.Least, part);
    result.Flat += part <= CornerJacobians::Rounding;
  }
  result.Flat -= std::min(collapsed, result.Flat);
  return result;
}

/** Sum of the squares of the lengths of all edges, each from both its ends. */
template <typename At>
double EdgeSquares(const CellCorners& corners, At at)
{
  double sum = 0;
  for (const CellCorner* corner = corners.Begin; corner != corners.End; ++corner)
  {
    for (std::size_t k = 1; k < 4; ++k)
    {
      const Vector3 edge = at((*corner)[k]) - at((*corner)[0]);
      sum += Dot(edge, edge);
    }
  }
  return sum;
}

/**
 * Whether one end of a hexahedron is turned by half a round, so that the edges between the ends
 * meet in the middle.
 */
template <typename At>
bool IsTwisted(const CellCorners& corners, double largestJacobian, At at)
{
  if (corners.End - corners.Begin < 8)
  {
    return false;
  }
  // The Jacobian in the middle, by the mean edges in three directions.
  Vector3 edges[3] = {};
  const auto vertex = [&](int number) -> const Vector3& { return at(corners.Begin[number][0]); };
  for (int k = 0; k < 4; ++k)
  {
    edges[2] = edges[2] + (vertex(k + 4) - vertex(k));
    for (const int end : { 0, 4 })
    {
      const Vector3 edge = vertex(end + (k + 1) % 4) - vertex(end + k);
      edges[k % 2] = k < 2 ? edges[k % 2] + edge : edges[k % 2] - edge;
    }
  }
  const double middle = std::abs(TripleProduct(edges[0], edges[1], edges[2])) / 64;
  return largestJacobian > 0 && middle <= CornerJacobians::Rounding * largestJacobian;
}

/** The corners are alike by far, so that rounding can not make the cell fold. */
template <typename At>
bool IsWellShaped(const CellCorners& corners, At at)
{
  constexpr double wellShaped = 0.1;
  const CornerJacobians jacobians = FindCornerJacobians(corners, at);
  return jacobians.Least > wellShaped && !IsTwisted(corners, jacobians.Largest, at);
}

/**
 * Other orders of the points of a cell: which number takes the place of each. The first leaves
 * them.
 */
class PointOrders
{
public:
  using Order = std::array<int, 8>;

  /**
   * Calls visit(order) for two points exchanged, for one end turned, and for a hexahedron numbered
   * like a voxel or the other way round.
   */
  template <typename Visit>
  static void ForEach(int cellType, Visit visit)
  {
    const int size = cellType == VTK_PYRAMID ? 5 : cellType == VTK_WEDGE ? 6 : 8;
    for (int i = 0; i < size; ++i)
    {
      for (int j = i + 1; j < size; ++j)
      {
        Order order = same;
        std::swap(order[std::size_t(i)], order[std::size_t(j)]);
        visit(order);
      }
    }
    if (cellType == VTK_HEXAHEDRON || cellType == VTK_VOXEL)
    {
      visit(Order{ { 0, 1, 3, 2, 4, 5, 7, 6 } });
    }
    const int ring = cellType == VTK_WEDGE ? 3 : 4;
    for (int turn = 0; size > 5 && turn < 2 * ring; ++turn)
    {
      visit(OtherEnd(ring, turn % ring, turn >= ring, cellType == VTK_VOXEL));
    }
  }

private:
  static constexpr Order same{ { 0, 1, 2, 3, 4, 5, 6, 7 } };

  // The second triangle or quadrilateral, turned, or the other way round.
  static Order OtherEnd(int ring, int turn, bool reversed, bool isVoxel)
  {
    static constexpr std::array<int, 4> aroundVoxel{ { 0, 1, 3, 2 } };
    const auto number = [&](int place) {
      return ring + (isVoxel ? aroundVoxel[std::size_t(place)] : place);
    };
    Order order = same;
    for (int k = 0; k < ring; ++k)
    {
      const int from = reversed ? (2 * ring - k + turn) % ring : (k + turn) % ring;
      order[std::size_t(number(k))] = number(from);
    }
    return order;
  }
};

/**
 * Finds how a cell of this type is numbered. If it is misnumbered, `best` is the order of its
 * points that has the shortest edges of those in which it does not fold: best[i] is the number of
 * the point that takes the place of point i.
 */
template <typename At>
CellShape FindCellShape(int cellType, At at, PointOrders::Order& best)
{
  const CellCorners corners = CellCornersOf(cellType);
  if (corners.Begin == corners.End)
  {
    return CellShape::Whole;
  }
  const CornerJacobians own = FindCornerJacobians(corners, at);
  const bool folds = own.Least < -CornerJacobians::Rounding || IsTwisted(corners, own.Largest, at);
  if (!folds && 3 * own.Flat < own.Corners) // two points exchanged make many of them flat
  {
    return CellShape::Whole;
  }
  double shortest = 0.99 * EdgeSquares(corners, at);
  bool found = false;
  PointOrders::ForEach(cellType, [&](const PointOrders::Order& order) {
    const auto there = [&](int vertex) -> const Vector3& { return at(order[std::size_t(vertex)]); };
    const double squares = EdgeSquares(corners, there);
    if (squares < 0.999 * shortest && IsWellShaped(corners, there))
    {
      shortest = squares;
      best = order;
      found = true;
    }
  });
  return found ? CellShape::Misnumbered : folds ? CellShape::Folded : CellShape::Whole;
}

} // namespace nephoscope

#endif
