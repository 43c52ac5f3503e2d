// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellVelocity.h"

#include "ArrayInterpolation.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"

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

  double Position[3] = { 0.0, 0.0, 0.0 };
  vtkNew<vtkGenericCell> Cell;
  vtkIdType CellId = -1; // what Cell holds
  double Parametric[3] = { 0.0, 0.0, 0.0 };
  std::vector<double> Weights;
  vtkNew<vtkIdList> Candidates;
};

CellVelocity::CellVelocity(vtkDataSet* data, vtkDataArray* velocity)
  : Data(data)
  , Velocity(velocity)
  , Hidden(data)
  , LargestCell(static_cast<std::size_t>(std::max(data->GetMaxCellSize(), 8)))
{
  double bounds[6];
  data->GetBounds(bounds); // computed here, so that threads only read it
  double largest = data->GetLength();
  for (const double bound : bounds)
  {
    largest = std::max(largest, std::abs(bound));
  }
  this->Rounding = 1e-14 * largest;
  vtkNew<vtkGenericCell> cell;
  data->GetCell(0, cell); // the first call makes what later ones share
}

CellVelocity::~CellVelocity() = default;

void CellVelocity::BuildLocator() const
{
  std::call_once(this->LocatorOnce, [this]() {
    this->Locator->SetDataSet(this->Data);
    this->Locator->BuildLocator();
  });
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
  std::copy(position.begin(), position.end(), search.Position);
  const bool known = hint.Cell >= 0 && hint.Cell < this->Data->GetNumberOfCells();
  if ((known && this->TryCell(search, hint.Cell, 0.0, velocity)) || this->Locate(search, velocity))
  {
    hint.Cell = search.CellId;
    std::copy_n(search.Parametric, 3, hint.Parametric.begin());
    return true;
  }
  return false;
}

bool CellVelocity::Locate(Search& search, Vector3& velocity) const
{
  this->BuildLocator();
  int part = 0;
  search.CellId = this->Locator->FindCell(
    search.Position, 0.0, search.Cell, part, search.Parametric, search.Weights.data());
  // Surfaces among the cells have no inside.
  if (search.CellId >= 0 && search.Cell->GetCellDimension() == 3 &&
    this->Interpolate(search, velocity))
  {
    return true;
  }
  const double r = this->Rounding;
  double box[6];
  for (int a = 0; a < 3; ++a)
  {
    box[2 * a] = search.Position[a] - r;
    box[2 * a + 1] = search.Position[a] + r;
  }
  this->Locator->FindCellsWithinBounds(box, search.Candidates);
  std::sort(search.Candidates->begin(), search.Candidates->end());
  return std::any_of(search.Candidates->begin(), search.Candidates->end(),
    [&](vtkIdType cell) { return this->TryCell(search, cell, r, velocity); });
}

bool CellVelocity::TryCell(
  Search& search, vtkIdType cell, double tolerance, Vector3& velocity) const
{
  if (this->Hidden[cell])
  {
    return false;
  }
  if (search.CellId != cell)
  {
    this->Data->GetCell(cell, search.Cell);
    search.CellId = cell;
  }
  if (search.Cell->GetCellDimension() != 3)
  {
    return false;
  }
  int part = 0;
  double closest[3];
  double distance2 = 0.0;
  const int status = search.Cell->EvaluatePosition(search.Position,
    tolerance > 0.0 ? closest : nullptr, part, search.Parametric, distance2, search.Weights.data());
  const bool near = status == 0 && tolerance > 0.0 && distance2 <= tolerance * tolerance;
  return (status == 1 || near) && this->Interpolate(search, velocity);
}

bool CellVelocity::Interpolate(const Search& search, Vector3& velocity) const
{
  if (this->Hidden[search.CellId])
  {
    return false;
  }
  velocity = Vector3{};
  vtkIdList* ids = search.Cell->GetPointIds();
  for (vtkIdType p = 0; p < ids->GetNumberOfIds(); ++p)
  {
    double value[3];
    this->Velocity->GetTuple(ids->GetId(p), value);
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
        vtkIdList* ids = search.Cell->GetPointIds();
        for (vtkIdType p = 0; p < ids->GetNumberOfIds(); ++p)
        {
          stencils.Add(ids->GetId(p), search.Weights[static_cast<std::size_t>(p)]);
        }
      }
      stencils.End();
    }
  };
  InterpolateArrays(this->Data->GetPointData(), count, output, fill);
}
}
