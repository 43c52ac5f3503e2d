// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellVelocity.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"

#include <cmath>
#include <vector>

namespace nephoscope
{
CellVelocity::CellVelocity(vtkDataSet* data, vtkDataArray* velocity)
  : Data(data)
  , Velocity(velocity)
{
  this->Locator->SetDataSet(data);
  this->Locator->BuildLocator();
}

CellVelocity::~CellVelocity() = default;

bool CellVelocity::Find(
  const Vector3& position, CellHint& hint, vtkGenericCell* cell, double* weights) const
{
  double point[3] = { position[0], position[1], position[2] };
  double parametric[3] = { 0.0, 0.0, 0.0 };
  int part = 0;
  hint.Cell = this->Locator->FindCell(point, 0.0, cell, part, parametric, weights);
  return hint.Cell >= 0;
}

void CellVelocity::Sample(const SampleBatch& batch) const
{
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(static_cast<std::size_t>(this->Data->GetMaxCellSize()) + 1);
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    batch.Inside[i] = this->Find(batch.Positions[i], batch.Hints[i], cell, weights.data());
    if (!batch.Inside[i])
    {
      continue;
    }
    Vector3 sum{};
    for (vtkIdType p = 0; p < cell->GetNumberOfPoints(); ++p)
    {
      double value[3];
      this->Velocity->GetTuple(cell->GetPointId(static_cast<int>(p)), value);
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += weights[static_cast<std::size_t>(p)] * value[c];
      }
    }
    batch.Velocities[i] = sum;
    batch.Inside[i] = std::isfinite(sum[0] + sum[1] + sum[2]);
  }
}

void CellVelocity::SampleArrays(
  std::size_t count, const Vector3* positions, const CellHint* hints, vtkPointData* output) const
{
  vtkPointData* input = this->Data->GetPointData();
  output->InterpolateAllocate(input, static_cast<vtkIdType>(count));
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(static_cast<std::size_t>(this->Data->GetMaxCellSize()) + 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    CellHint hint = hints[i];
    if (this->Find(positions[i], hint, cell, weights.data()))
    {
      output->InterpolatePoint(
        input, static_cast<vtkIdType>(i), cell->GetPointIds(), weights.data());
    }
    else
    {
      output->NullData(static_cast<vtkIdType>(i));
    }
  }
}
}
