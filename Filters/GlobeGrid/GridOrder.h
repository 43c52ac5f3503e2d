// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// From output indices (west to east, south to north, bottom to top, closed, rotated) to input
// indices. A row added at a pole represents the last ring before it.
// Plain C++17.
#ifndef nephoscope_GridOrder_h
#define nephoscope_GridOrder_h

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nephoscope
{
struct GridOrder
{
  std::array<int, 3> InputDimensions = { 1, 1, 1 };
  std::array<int, 3> OutputDimensions = { 1, 1, 1 };
  std::array<bool, 3> Reversed = { false, false, false };
  int Period =
    0; // distinct columns of a grid that goes round the globe and is rotated or closed; else 0
  int FirstColumn = 0; // of the distinct columns, the one that comes first in the output
  bool InputIsClosed = false;
  std::array<bool, 2> PoleIsAdded = { false,
    false };          // south, north; OutputDimensions count these rows
  double Turns = 0.0; // whole turns, in degrees, added to every longitude on a map

  // The column among the ordered ones, and the whole turns that its longitude needs.
  int OrderedColumn(int column) const
  {
    const bool repeated = this->InputIsClosed && this->FirstColumn == 0;
    return this->Period > 0 && !repeated ? (column + this->FirstColumn) % this->Period : column;
  }

  double LongitudeOffset(int column) const
  {
    const bool repeated = this->InputIsClosed && this->FirstColumn == 0;
    const int turns =
      this->Period > 0 && !repeated ? (column + this->FirstColumn) / this->Period : 0;
    return this->Turns + 360.0 * turns;
  }

  // -1 if output row j is added at the South Pole, 1 at the North Pole, else 0.
  int AddedPole(int j) const
  {
    const bool south = this->PoleIsAdded[0] && j == 0;
    const bool north = this->PoleIsAdded[1] && j == this->OutputDimensions[1] - 1;
    return north ? 1 : south ? -1 : 0;
  }

  void AddPoles(const std::array<bool, 2>& added)
  {
    this->PoleIsAdded = added;
    this->OutputDimensions[1] += (added[0] ? 1 : 0) + (added[1] ? 1 : 0);
  }

  std::array<int, 3> InputPoint(int i, int j, int k) const
  {
    return { this->Turned(0, this->OrderedColumn(i), 1), this->Turned(1, this->OrderedRow(j, 1), 1),
      this->Turned(2, k, 1) };
  }

  // The cell that begins at output point (i, j, k). The seam cell that closing adds is not in the
  // input: it takes its western neighbour; those at an added pole take the nearest row's.
  std::array<int, 3> InputCell(int i, int j, int k) const
  {
    const int cells = std::max(this->InputDimensions[0] - 1, 1);
    const int column = std::min(this->OrderedColumn(i), cells - 1);
    return { this->Turned(0, column, 2), this->Turned(1, this->OrderedRow(j, 2), 2),
      this->Turned(2, k, 2) };
  }

  // Puts the meridian in the middle of the map. `longitudes`: unwrapped, of the ordered columns.
  void Centre(const std::vector<double>& longitudes, double meridian)
  {
    if (this->Period == 0)
    {
      const double middle = 0.5 * (longitudes.front() + longitudes.back());
      this->Turns = -360.0 * std::round((middle - meridian) / 360.0);
      return;
    }
    const double west = meridian - 180.0;
    double nearest = 360.0;
    for (int column = 0; column < this->Period; ++column)
    {
      double eastOfEdge = longitudes[column] - west;
      eastOfEdge -= 360.0 * std::floor(eastOfEdge / 360.0 + 1e-9);
      if (eastOfEdge < nearest)
      {
        nearest = eastOfEdge;
        this->FirstColumn = column;
        this->Turns = 360.0 * std::round((west + eastOfEdge - longitudes[column]) / 360.0);
      }
    }
  }

private:
  // The row among those of the input, south to north; `shortBy` is 1 for points, 2 for cells.
  int OrderedRow(int j, int shortBy) const
  {
    const int last = std::max(this->InputDimensions[1] - shortBy, 0);
    return std::max(0, std::min(j - (this->PoleIsAdded[0] ? 1 : 0), last));
  }

  int Turned(int axis, int index, int shortBy) const
  {
    const int last = std::max(this->InputDimensions[axis] - shortBy, 0);
    return this->Reversed[axis] ? last - index : index;
  }
};
}

#endif
