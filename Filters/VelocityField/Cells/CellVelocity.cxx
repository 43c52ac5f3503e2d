// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellVelocity.h"

#include "ArrayInterpolation.h"
#include "CellShapes.h"
#include "DataSets.h"
#include "GhostCells.h"

#include "vtkBoundingBox.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephoscope
{
// What one thread needs to find positions, one after the other.
struct CellVelocity::Search
{
  explicit Search(std::size_t largestCell)
    : Weights(largestCell)
  {
  }

  Vector3 Position{};
  vtkIdType Found = -1;
  vtkNew<vtkIdList> Ids; // of the points of the cell that was tried last
  std::vector<double> Weights;
  Vector3 Parametric{};
  vtkNew<vtkGenericCell> Cell;
};

CellVelocity::CellVelocity(vtkDataSet* data, vtkDataArray* velocity)
  : Data(data)
  , Velocity(velocity)
  , Hidden(data)
  , LargestCell(static_cast<std::size_t>(std::max(data->GetMaxCellSize(), 8)))
{
  data->GetLength(); // computed here, so that threads only read it
  const vtkBoundingBox box = FiniteBounds(data);
  double bounds[6];
  box.GetBounds(bounds);
  double largest = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  for (const double bound : bounds)
  {
    largest = std::max(largest, std::abs(bound));
  }
  this->Rounding = 1e-14 * largest;
  vtkNew<vtkGenericCell> cell;
  data->GetCell(0, cell); // the first call makes what later ones share
}

CellVelocity::~CellVelocity() = default;

const CellTree& CellVelocity::Tree() const
{
  std::call_once(this->TreeOnce, [this]() {
    const vtkIdType count = this->Data->GetNumberOfCells();
    std::vector<Box> boxes(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      double b[6];
      this->Data->GetCellBounds(i, b);
      boxes[static_cast<std::size_t>(i)] = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
    }
    this->LazyTree.Build(boxes);
  });
  return this->LazyTree;
}

void CellVelocity::Sample(const SampleBatch& batch) const
{
  Search search(this->LargestCell);
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    batch.Inside[i] =
      this->SampleOne(search, batch.Positions[i], batch.Hints[i], batch.Velocities[i]);
  }
}

bool CellVelocity::SampleOne(
  Search& search, const Vector3& position, CellHint& hint, Vector3& velocity) const
{
  if (!std::isfinite(position[0] + position[1] + position[2]))
  {
    return false;
  }
  search.Position = position;
  search.Parametric = hint.Parametric;
  if (hint.Cell >= 0 && hint.Cell < this->Data->GetNumberOfCells() &&
    this->TryCell(search, hint.Cell, false, velocity))
  {
    hint.Parametric = search.Parametric;
    return true;
  }
  for (const bool nearToo : { false, true })
  {
    const bool found = this->Tree().ForEachCell(position, [&](vtkIdType cell) {
      search.Parametric = { 0.5, 0.5, 0.5 };
      search.Found = cell;
      return this->TryCell(search, cell, nearToo, velocity);
    });
    if (found)
    {
      hint.Cell = search.Found;
      hint.Parametric = search.Parametric;
      return true;
    }
  }
  return false;
}

bool CellVelocity::TryCell(Search& search, vtkIdType cell, bool nearToo, Vector3& velocity) const
{
  if (this->Hidden[cell])
  {
    return false;
  }
  const int type = this->Data->GetCellType(cell);
  if (type == VTK_TETRA || type == VTK_HEXAHEDRON || type == VTK_VOXEL)
  {
    this->Data->GetCellPoints(cell, search.Ids);
    return this->WeightsByFormula(search, type) && this->Interpolate(search, velocity);
  }
  return this->WeightsByCell(search, cell, nearToo) && this->Interpolate(search, velocity);
}

bool CellVelocity::WeightsByFormula(Search& search, int type) const
{
  Vector3 points[8];
  for (vtkIdType i = 0; i < search.Ids->GetNumberOfIds(); ++i)
  {
    this->Data->GetPoint(search.Ids->GetId(i), points[i].data());
  }
  if (type == VTK_TETRA)
  {
    const Vector3 corners[4] = { points[0], points[1], points[2], points[3] };
    return WeightsInTetrahedron(corners, search.Position, search.Weights.data());
  }
  return WeightsInHexahedron(
    points, type == VTK_VOXEL, search.Position, search.Parametric, search.Weights.data());
}

bool CellVelocity::WeightsByCell(Search& search, vtkIdType cell, bool nearToo) const
{
  // VTK's polyhedra draw from its one sequence of random numbers to tell inside from outside, and
  // its Bezier cells share tables: threads must not evaluate them at the same time.
  static std::mutex oneAtATime;
  std::unique_lock<std::mutex> alone(oneAtATime, std::defer_lock);
  const int type = this->Data->GetCellType(cell);
  if (type == VTK_POLYHEDRON || (type >= VTK_BEZIER_CURVE && type <= VTK_BEZIER_PYRAMID))
  {
    alone.lock();
  }
  this->Data->GetCell(cell, search.Cell);
  if (search.Cell->GetCellDimension() != 3)
  {
    return false; // surfaces among the cells have no inside
  }
  search.Ids->DeepCopy(search.Cell->GetPointIds());
  int part = 0;
  double closest[3];
  double distance2 = 0.0;
  const int status = search.Cell->EvaluatePosition(search.Position.data(),
    nearToo ? closest : nullptr, part, search.Parametric.data(), distance2, search.Weights.data());
  return status == 1 || (status == 0 && nearToo && distance2 <= this->Rounding * this->Rounding);
}

bool CellVelocity::Interpolate(const Search& search, Vector3& velocity) const
{
  velocity = Vector3{};
  for (vtkIdType p = 0; p < search.Ids->GetNumberOfIds(); ++p)
  {
    double value[3];
    this->Velocity->GetTuple(search.Ids->GetId(p), value);
    for (std::size_t c = 0; c < 3; ++c)
    {
      velocity[c] += search.Weights[static_cast<std::size_t>(p)] * value[c];
    }
  }
  return std::isfinite(velocity[0] + velocity[1] + velocity[2]);
}

void CellVelocity::SampleArrays(
  std::size_t count, const Vector3* positions, const CellHint* hints, vtkPointData* output) const
{
  const auto fill = [&](std::size_t begin, std::size_t end, Stencils& stencils) {
    Search search(this->LargestCell);
    for (std::size_t i = begin; i < end; ++i)
    {
      CellHint hint = hints[i];
      Vector3 velocity;
      if (this->SampleOne(search, positions[i], hint, velocity))
      {
        for (vtkIdType p = 0; p < search.Ids->GetNumberOfIds(); ++p)
        {
          stencils.Add(search.Ids->GetId(p), search.Weights[static_cast<std::size_t>(p)]);
        }
      }
      stencils.End();
    }
  };
  InterpolateArrays(this->Data->GetPointData(), count, output, fill);
}

bool CellVelocity::IsInGhostCell(const CellHint& found) const
{
  return IsGhostCell(this->Data, found.Cell);
}
}
