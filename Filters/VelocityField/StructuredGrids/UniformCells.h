// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a uniform grid, turned or not. Plain C++17.
#ifndef nephoscope_UniformCells_h
#define nephoscope_UniformCells_h

#include "GridCell.h"
#include "GridLinks.h"

namespace nephoscope
{
class UniformCells
{
public:
  // `origin`: the first point; `toIndex`: from a difference of positions to a difference of
  // indices, by rows.
  UniformCells(const GridSize& size, const Vector3& origin, const std::array<Vector3, 3>& toIndex)
    : Size_(size)
    , Links_(size)
    , Origin(origin)
    , ToIndex(toIndex)
  {
  }

  const GridSize& Size() const { return this->Size_; }
  const GridLinks& Links() const { return this->Links_; }

  bool Find(const Vector3& position, bool, GridCell& cell) const
  {
    const Vector3 d = { position[0] - this->Origin[0], position[1] - this->Origin[1],
      position[2] - this->Origin[2] };
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Vector3& row = this->ToIndex[axis];
      inside = inside &&
        SplitCoordinate(row[0] * d[0] + row[1] * d[1] + row[2] * d[2], this->Size_.Cells(axis),
          cell.Index[axis], cell.Parametric[axis]);
    }
    return inside;
  }

private:
  GridSize Size_;
  GridLinks Links_;
  Vector3 Origin;
  std::array<Vector3, 3> ToIndex;
};
}

#endif
