// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a curvilinear grid. Plain C++17.
//
//   1. From a known cell: invert its map; if the position is outside, go on to the neighbour on
//      that side, across a seam or a pole too, and repeat.
//   2. If that does not arrive: boxes tell the cells that may hold the position, and each is tried.
//      They are made when they are needed first.
#ifndef nephoscope_CurvilinearCells_h
#define nephoscope_CurvilinearCells_h

#include "GridBoxes.h"
#include "GridLinks.h"
#include "TrilinearMap.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

namespace nephoscope
{
template <typename Coordinate>
class CurvilinearCells
{
public:
  // `points`: triples, along axis 0 first; `keeper` owns them.
  CurvilinearCells(
    const GridSize& size, const Coordinate* points, std::shared_ptr<const void> keeper = nullptr)
    : Size_(size)
    , Links_(size)
    , Points(points)
    , Keeper(std::move(keeper))
    , Corners(size.CornerOffsets())
    , Lazy(std::make_unique<LazyBoxes>())
  {
    const auto distance = [this](const std::array<int, 3>& p, const std::array<int, 3>& q) {
      return this->Distance(p, q);
    };
    const auto& n = this->Size_.Points;
    const double length = distance({ 0, 0, 0 }, { n[0] / 2, n[1] / 2, n[2] / 2 }) +
      distance({ 0, 0, 0 }, { n[0] - 1, n[1] - 1, n[2] - 1 });
    this->Links_.Detect(distance, 1e-9 * length);
  }

  const GridSize& Size() const { return this->Size_; }
  const GridLinks& Links() const { return this->Links_; }

  // The cell to begin with is `cell` if `known`.
  bool Find(const Vector3& position, bool known, GridCell& cell) const
  {
    return (known && this->Walk(position, cell)) || this->Search(position, cell);
  }

private:
  struct LazyBoxes
  {
    std::once_flag Once;
    GridBoxes Boxes;
  };

  static constexpr int LONGEST_WALK = 24;

  const Coordinate* Corner(const std::array<int, 3>& index) const
  {
    return this->Points + 3 * this->Size_.PointId(index);
  }

  double Distance(const std::array<int, 3>& p, const std::array<int, 3>& q) const
  {
    const Coordinate* a = this->Corner(p);
    const Coordinate* b = this->Corner(q);
    const Vector3 d = { static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1],
      static_cast<double>(a[2]) - b[2] };
    return std::sqrt(Dot(d, d));
  }

  InverseResult Invert(const Vector3& position, GridCell& cell) const
  {
    const TrilinearMap map(this->Corner(cell.Index), this->Corners, position);
    const InverseResult result = map.Invert(cell.Parametric);
    if (result == InverseResult::Inside)
    {
      for (double& r : cell.Parametric)
      {
        r = std::clamp(r, 0.0, 1.0);
      }
    }
    return result;
  }

  bool Walk(const Vector3& position, GridCell& cell) const
  {
    for (int step = 0; step < LONGEST_WALK; ++step)
    {
      const InverseResult result = this->Invert(position, cell);
      if (result != InverseResult::Outside)
      {
        return result == InverseResult::Inside;
      }
      if (!this->GoOn(cell))
      {
        return false;
      }
    }
    return false;
  }

  // To the cell that the parametric coordinates point to; false at a boundary.
  bool GoOn(GridCell& cell) const
  {
    bool moved = false;
    const Vector3 r = cell.Parametric;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double beyond = r[axis] < 0.0 ? r[axis] : std::max(r[axis] - 1.0, 0.0);
      if (std::abs(beyond) > 0.5 * PARAMETRIC_TOLERANCE)
      {
        const int steps = static_cast<int>(beyond < 0.0 ? std::floor(beyond) : std::ceil(beyond));
        moved = this->Links_.Move(cell, axis, steps) || moved;
      }
    }
    for (double& parametric : cell.Parametric)
    {
      parametric = std::clamp(parametric, 0.0, 1.0);
    }
    return moved;
  }

  bool Search(const Vector3& position, GridCell& cell) const
  {
    std::call_once(
      this->Lazy->Once, [this]() { this->Lazy->Boxes.Build(this->Points, this->Size_); });
    const GridBoxes& boxes = this->Lazy->Boxes;
    const auto walkFrom = [&](const std::array<int, 3>& block) {
      for (std::size_t a = 0; a < 3; ++a)
      {
        const int middle = GridBoxes::BRANCH * block[a] + GridBoxes::BRANCH / 2;
        cell.Index[a] = std::min(middle, this->Size_.Cells(a) - 1);
      }
      cell.Parametric = { 0.5, 0.5, 0.5 };
      return this->Walk(position, cell);
    };
    const auto tryCell = [&](const std::array<int, 3>& index) {
      cell.Index = index;
      cell.Parametric = { 0.5, 0.5, 0.5 };
      return this->BoxOf(index).Holds(position) &&
        this->Invert(position, cell) == InverseResult::Inside;
    };
    return boxes.ForEachBlock(position, walkFrom) ||
      boxes.ForEachBlock(position,
        [&](const std::array<int, 3>& block) { return boxes.ForEachCell(block, tryCell); });
  }

  Box BoxOf(const std::array<int, 3>& index) const
  {
    Box box;
    const Coordinate* first = this->Corner(index);
    for (const std::int64_t corner : this->Corners)
    {
      box.AddPoint(first + 3 * corner);
    }
    return box;
  }

  GridSize Size_;
  GridLinks Links_;
  const Coordinate* Points;
  std::shared_ptr<const void> Keeper;
  std::array<std::int64_t, 8> Corners;
  std::unique_ptr<LazyBoxes> Lazy;
};
}

#endif
