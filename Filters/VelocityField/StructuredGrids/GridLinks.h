// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cell lies behind the face of another, also where a grid is closed upon itself. Plain C++17.
#ifndef nephoscope_GridLinks_h
#define nephoscope_GridLinks_h

#include "GridCell.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
// A grid is closed along an axis if its last points are its first ones again (the seam of a globe,
// of an O-grid). An end of another axis is a pole if all its points around the closed axis are one:
// behind it is the cell on the opposite side.
class GridLinks
{
public:
  explicit GridLinks(const GridSize& size)
    : Size(size)
  {
  }

  bool IsClosed(std::size_t axis) const { return this->Closed[axis]; }

  // The closed axis around the pole at the end of `axis` (0: first, 1: last), or -1.
  int PoleAround(std::size_t axis, std::size_t end) const { return this->Pole[axis][end]; }

  // `distance(p, q)` is the distance of two points of the grid, given by their indices.
  template <typename Distance>
  void Detect(const Distance& distance, double tolerance)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Closed[axis] = this->EndsMeet(axis, distance, tolerance);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t end = 0; end < 2; ++end)
      {
        this->Pole[axis][end] = this->FindPole(axis, end, distance, tolerance);
      }
    }
  }

  // Goes up to `steps` cells along an axis, fewer at a boundary; true if the cell is another one.
  // The parametric coordinates follow.
  bool Move(GridCell& cell, std::size_t axis, int steps) const
  {
    const int cells = this->Size.Cells(axis);
    const int target = cell.Index[axis] + steps;
    double& parametric = cell.Parametric[axis];
    if (target >= 0 && target < cells)
    {
      cell.Index[axis] = target;
      parametric -= steps;
      return true;
    }
    if (this->Closed[axis])
    {
      cell.Index[axis] = (target % cells + cells) % cells;
      parametric -= steps;
      return true;
    }
    const std::size_t end = target < 0 ? 0 : 1;
    const int boundary = end == 0 ? 0 : cells - 1;
    if (this->Pole[axis][end] >= 0)
    {
      this->CrossPole(cell, axis, boundary);
      return true;
    }
    const int moved = boundary - cell.Index[axis];
    cell.Index[axis] = boundary;
    parametric -= moved;
    return moved != 0;
  }

private:
  void CrossPole(GridCell& cell, std::size_t axis, int boundary) const
  {
    const auto around = static_cast<std::size_t>(this->Pole[axis][boundary == 0 ? 0 : 1]);
    const int cells = this->Size.Cells(around);
    cell.Index[axis] = boundary;
    cell.Parametric[axis] = boundary == 0 ? -cell.Parametric[axis] : 2.0 - cell.Parametric[axis];
    cell.Index[around] = (cell.Index[around] + cells / 2) % cells;
    cell.Parametric[around] = 0.5;
  }

  template <typename Function>
  bool AllOfFace(std::size_t axis, int index, const Function& holds) const
  {
    const std::size_t b = (axis + 1) % 3;
    const std::size_t c = (axis + 2) % 3;
    std::array<int, 3> p{};
    p[axis] = index;
    for (p[c] = 0; p[c] < this->Size.Points[c]; ++p[c])
    {
      for (p[b] = 0; p[b] < this->Size.Points[b]; ++p[b])
      {
        if (!holds(p))
        {
          return false;
        }
      }
    }
    return true;
  }

  template <typename Distance>
  bool EndsMeet(std::size_t axis, const Distance& distance, double tolerance) const
  {
    const int last = this->Size.Points[axis] - 1;
    bool apart = false; // at least somewhere, from the first to the middle
    const bool meet = last >= 3 && this->AllOfFace(axis, 0, [&](const std::array<int, 3>& p) {
      std::array<int, 3> other = p;
      other[axis] = last / 2;
      apart = apart || distance(p, other) > tolerance;
      other[axis] = last;
      return distance(p, other) <= tolerance;
    });
    return meet && apart;
  }

  template <typename Distance>
  int FindPole(std::size_t axis, std::size_t end, const Distance& distance, double tolerance) const
  {
    for (std::size_t around = 0; around < 3; ++around)
    {
      const int index = end == 0 ? 0 : this->Size.Points[axis] - 1;
      const bool collapsed = around != axis && this->Closed[around] &&
        this->AllOfFace(axis, index, [&](const std::array<int, 3>& p) {
          std::array<int, 3> first = p;
          first[around] = 0;
          return distance(p, first) <= tolerance;
        });
      if (collapsed)
      {
        return static_cast<int>(around);
      }
    }
    return -1;
  }

  GridSize Size;
  std::array<bool, 3> Closed{ { false, false, false } };
  std::array<std::array<int, 2>, 3> Pole{ { { { -1, -1 } }, { { -1, -1 } }, { { -1, -1 } } } };
};
}

#endif
