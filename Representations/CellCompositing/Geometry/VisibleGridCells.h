// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which cells of a structured grid can be seen: the number of their tetrahedra, and the box that
 * holds them.
 */
#ifndef nephoscope_VisibleGridCells_h
#define nephoscope_VisibleGridCells_h

#include "BoundaryFaces.h"
#include "CellGeometry.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

namespace nephoscope
{

/**
 * `IsTransparent(cell, vertices, low, high)`: of a tetrahedron whose scalars of opacity lie between
 * low and high.
 */
template <typename IsTransparent>
class VisibleGridCells
{
public:
  struct Result
  {
    std::int64_t Tetrahedra = 0;
    CellBox Box = { { std::numeric_limits<int>::max(), std::numeric_limits<int>::max(),
                      std::numeric_limits<int>::max() },
      { -1, -1, -1 } };

    void Add(const std::array<int, 3>& low, const std::array<int, 3>& high)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->Box.Low[axis] = std::min(this->Box.Low[axis], low[axis]);
        this->Box.High[axis] = std::max(this->Box.High[axis], high[axis]);
      }
    }
  };

  VisibleGridCells(const CellGeometry& geometry, const IsTransparent& isTransparent)
    : Geometry(geometry)
    , Transparent(isTransparent)
  {
  }

  /** Marks the cells that can be seen with 1 in `marks`, unless it is empty. */
  Result Find(std::vector<std::uint8_t>& marks) const
  {
    vtkSMPThreadLocal<Result> parts;
    vtkSMPTools::For(0, this->Geometry.Grid.NumberOfCells(), [&](vtkIdType begin, vtkIdType end) {
      Result& part = parts.Local();
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const int visible = this->CountVisible(cell);
        if (visible > 0)
        {
          part.Tetrahedra += visible;
          const std::array<int, 3> index = this->Geometry.Grid.CellIndex(cell);
          part.Add(index, index);
          if (!marks.empty())
          {
            marks[static_cast<std::size_t>(cell)] = 1;
          }
        }
      }
    });
    Result result;
    for (const Result& part : parts)
    {
      result.Tetrahedra += part.Tetrahedra;
      result.Add({ { part.Box.Low[0], part.Box.Low[1], part.Box.Low[2] } },
        { { part.Box.High[0], part.Box.High[1], part.Box.High[2] } });
    }
    return result;
  }

private:
  int CountVisible(std::int64_t cell) const
  {
    const CellGeometry& geometry = this->Geometry;
    const std::size_t number = static_cast<std::size_t>(cell);
    if (!geometry.HiddenCells.empty() && geometry.HiddenCells[number])
    {
      return 0;
    }
    const bool separate = geometry.HasOpacityScalars;
    const bool onCells = separate ? geometry.OpacityOnCells : !geometry.CellScalars.empty();
    int visible = 0;
    for (const auto& t : geometry.Grid.Tetrahedra(cell))
    {
      std::array<float, 4> s;
      std::transform(t.begin(), t.end(), s.begin(), [&](std::int64_t point) {
        const std::size_t i = onCells ? number : static_cast<std::size_t>(point);
        return separate ? geometry.OpacityScalars[i]
          : onCells     ? geometry.CellScalars[i]
                        : geometry.Points[i].Scalar;
      });
      const auto range = std::minmax_element(s.begin(), s.end());
      visible += !this->Transparent(number, t, *range.first, *range.second);
    }
    return visible;
  }

  const CellGeometry& Geometry;
  const IsTransparent& Transparent;
};

} // namespace nephoscope

#endif
