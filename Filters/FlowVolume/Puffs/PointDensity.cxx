// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointDensity.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace nephoscope
{
const std::vector<double>& PointDensity::Of(vtkUnstructuredGrid* grid, vtkDataArray* density)
{
  const vtkMTimeType cellsTime = grid->GetCells()->GetMTime();
  const bool same = this->CellsTime == cellsTime && this->DensityTime == density->GetMTime() &&
    this->Values.size() == static_cast<std::size_t>(grid->GetNumberOfPoints());
  if (!same)
  {
    this->Average(grid, density);
    this->CellsTime = cellsTime;
    this->DensityTime = density->GetMTime();
  }
  return this->Values;
}

void PointDensity::Average(vtkUnstructuredGrid* grid, vtkDataArray* density)
{
  const auto count = static_cast<std::size_t>(grid->GetNumberOfPoints());
  std::vector<double> cellsAtPoint(count, 0.0);
  this->Values.assign(count, 0.0);
  auto cells = vtk::TakeSmartPointer(grid->GetCells()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const double value = density->GetComponent(cells->GetCurrentCellId(), 0);
    if (!std::isfinite(value))
    {
      continue;
    }
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCurrentCell(size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const auto point = static_cast<std::size_t>(points[i]);
      this->Values[point] += value;
      cellsAtPoint[point] += 1.0;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Values[i] /= cellsAtPoint[i] > 0.0 ? cellsAtPoint[i] : 1.0;
  }
}
}
