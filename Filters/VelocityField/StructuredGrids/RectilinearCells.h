// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a rectilinear grid. Plain C++17.
#ifndef nephoscope_RectilinearCells_h
#define nephoscope_RectilinearCells_h

#include "GridCell.h"
#include "GridLinks.h"

#include <algorithm>
#include <vector>

namespace nephoscope
{
// Coordinates that grow or fall from point to point.
class RectilinearAxis
{
public:
  RectilinearAxis() = default;

  explicit RectilinearAxis(std::vector<double> coordinates)
    : Coordinates(std::move(coordinates))
    , Sign(this->Coordinates.back() < this->Coordinates.front() ? -1.0 : 1.0)
  {
    for (double& coordinate : this->Coordinates)
    {
      coordinate *= this->Sign;
    }
    const double length = this->Coordinates.back() - this->Coordinates.front();
    const auto cells = static_cast<double>(this->Coordinates.size() - 1);
    this->Tolerance = PARAMETRIC_TOLERANCE * length / cells;
  }

  int Points() const { return static_cast<int>(this->Coordinates.size()); }

  // `index` is where to look first, if it is a cell.
  bool Find(double position, int& index, double& fraction) const
  {
    const double x = position * this->Sign;
    const int last = this->Points() - 2;
    if (!(x >= this->Coordinates.front() - this->Tolerance &&
          x <= this->Coordinates.back() + this->Tolerance))
    {
      return false;
    }
    if (index < 0 || index > last || !this->Holds(index, x))
    {
      const auto after = std::upper_bound(this->Coordinates.begin(), this->Coordinates.end(), x);
      index = std::clamp(static_cast<int>(after - this->Coordinates.begin()) - 1, 0, last);
    }
    const double low = this->At(index);
    fraction = std::clamp((x - low) / (this->At(index + 1) - low), 0.0, 1.0);
    return true;
  }

private:
  double At(int index) const { return this->Coordinates[static_cast<std::size_t>(index)]; }

  // The lower end belongs to a cell, the upper one to the next: no position is in two.
  bool Holds(int index, double x) const { return x >= this->At(index) && x < this->At(index + 1); }

  std::vector<double> Coordinates;
  double Sign = 1.0;
  double Tolerance = 0.0;
};

class RectilinearCells
{
public:
  explicit RectilinearCells(std::array<RectilinearAxis, 3> axes)
    : Axes(std::move(axes))
    , Size_{ { { this->Axes[0].Points(), this->Axes[1].Points(), this->Axes[2].Points() } } }
    , Links_(this->Size_)
  {
  }

  const GridSize& Size() const { return this->Size_; }
  const GridLinks& Links() const { return this->Links_; }

  // The index that `cell` has is where to look first if `known`.
  bool Find(const Vector3& position, bool known, GridCell& cell) const
  {
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cell.Index[axis] = known ? cell.Index[axis] : -1;
      inside =
        inside && this->Axes[axis].Find(position[axis], cell.Index[axis], cell.Parametric[axis]);
    }
    return inside;
  }

private:
  std::array<RectilinearAxis, 3> Axes;
  GridSize Size_;
  GridLinks Links_;
};
}

#endif
