// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity field of a structured grid: `Cells` finds a position, the corners of its cell give
// the value.
#ifndef nephoscope_StructuredField_h
#define nephoscope_StructuredField_h

#include "ArrayInterpolation.h"
#include "GhostCells.h"
#include "GridCell.h"
#include "HiddenCells.h"
#include "VelocityFields.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <utility>

namespace nephoscope
{
template <typename Cells, typename Value>
class StructuredField : public DataSetField
{
public:
  // `values`: the velocities, triples along axis 0 first; `keeper` owns them.
  StructuredField(vtkDataSet* data, Cells cells, vtkDataArray* keeper, const Value* values)
    : Data(data)
    , Grid(std::move(cells))
    , Corners(this->Grid.Size().CornerOffsets())
    , Hidden(data)
    , Keeper(keeper)
    , Values(values)
  {
  }

  void Sample(const SampleBatch& batch) const override
  {
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      batch.Inside[i] = this->SampleOne(batch.Positions[i], batch.Hints[i], batch.Velocities[i]);
    }
  }

  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override
  {
    const auto fill = [&](std::size_t begin, std::size_t end, Stencils& stencils) {
      for (std::size_t i = begin; i < end; ++i)
      {
        CellHint hint = hints[i];
        Vector3 velocity;
        GridCell cell;
        if (this->SampleOne(positions[i], hint, velocity) &&
          this->Grid.Size().IndexOfCell(hint.Cell, cell.Index))
        {
          const vtkIdType first = this->Grid.Size().PointId(cell.Index);
          const auto weights = TrilinearWeights(hint.Parametric);
          for (std::size_t e = 0; e < 8; ++e)
          {
            stencils.Add(first + this->Corners[e], weights[e]);
          }
        }
        stencils.End();
      }
    };
    InterpolateArrays(this->Data->GetPointData(), count, output, fill);
  }

  bool IsInGhostCell(const CellHint& found) const override
  {
    return IsGhostCell(this->Data, found.Cell);
  }

private:
  bool SampleOne(const Vector3& position, CellHint& hint, Vector3& velocity) const
  {
    GridCell cell;
    const bool known = this->Grid.Size().IndexOfCell(hint.Cell, cell.Index);
    cell.Parametric = hint.Parametric;
    if (!this->Grid.Find(position, known, cell))
    {
      return false;
    }
    if (!this->Interpolate(cell, velocity) && !this->InterpolateTouching(cell, velocity))
    {
      return false;
    }
    hint.Cell = this->Grid.Size().CellId(cell.Index);
    hint.Parametric = cell.Parametric;
    return true;
  }

  bool Interpolate(const GridCell& cell, Vector3& velocity) const
  {
    if (this->Hidden.Any() && this->Hidden[this->Grid.Size().CellId(cell.Index)])
    {
      return false;
    }
    const Value* first = this->Values + 3 * this->Grid.Size().PointId(cell.Index);
    velocity = InterpolateTrilinear(first, this->Corners, cell.Parametric);
    return std::isfinite(velocity[0] + velocity[1] + velocity[2]);
  }

  // A position on a face belongs to both cells: it is inside if one of them can be used, whichever
  // was found.
  bool InterpolateTouching(GridCell& cell, Vector3& velocity) const
  {
    std::array<int, 3> side{};
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double r = cell.Parametric[a];
      side[a] = r <= PARAMETRIC_TOLERANCE ? -1 : r >= 1.0 - PARAMETRIC_TOLERANCE ? 1 : 0;
    }
    for (unsigned int subset = 1; subset < 8; ++subset)
    {
      GridCell other = cell;
      bool exists = true;
      for (std::size_t a = 0; a < 3; ++a)
      {
        const bool cross = (subset >> a) & 1U;
        exists = exists && (!cross || (side[a] != 0 && this->Grid.Links().Move(other, a, side[a])));
        other.Parametric[a] = std::min(std::max(other.Parametric[a], 0.0), 1.0);
      }
      if (exists && this->Interpolate(other, velocity))
      {
        cell = other;
        return true;
      }
    }
    return false;
  }

  vtkSmartPointer<vtkDataSet> Data;
  Cells Grid;
  std::array<std::int64_t, 8> Corners;
  HiddenCells Hidden;
  vtkSmartPointer<vtkDataArray> Keeper;
  const Value* Values;
};
}

#endif
