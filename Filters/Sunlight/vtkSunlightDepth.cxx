// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings about implausible optical depths, for example because an array is not an extinction coefficient or has another unit of length.
#include "vtkSunlight.h"

#include "LitData.h"
#include "vtkSunlightInternals.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr vtkIdType mostSamples = 500;
constexpr double opaqueCell = 30, clearData = 0.003; // optical depths

double shortestEdge(vtkGenericCell* cell)
{
  double shortest = VTK_DOUBLE_MAX;
  for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
  {
    double ends[2][3];
    vtkPoints* points = cell->GetEdge(e)->GetPoints();
    points->GetPoint(0, ends[0]);
    points->GetPoint(1, ends[1]);
    const double square = vtkMath::Distance2BetweenPoints(ends[0], ends[1]);
    shortest = square > 0 ? std::min(shortest, square) : shortest;
  }
  return shortest < VTK_DOUBLE_MAX ? std::sqrt(shortest) : 0;
}

// The optical depth along the shortest edge that half of the 3-D cells exceed; clear cells count.
double medianDepth(vtkDataSet* data, const std::vector<float>& extinction)
{
  std::vector<double> depths;
  vtkNew<vtkGenericCell> cell;
  const vtkIdType count = data->GetNumberOfCells(), step = 1 + count / mostSamples;
  for (vtkIdType i = 0; i < count; i += step)
  {
    data->GetCell(i, cell);
    if (cell->GetCellDimension() < 3)
    {
      continue;
    }
    double sum = 0;
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
    {
      sum += extinction[cell->GetPointId(static_cast<int>(k))];
    }
    depths.push_back(sum / cell->GetNumberOfPoints() * shortestEdge(cell));
  }
  if (depths.empty())
  {
    return 0;
  }
  std::nth_element(depths.begin(), depths.begin() + depths.size() / 2, depths.end());
  return depths[depths.size() / 2];
}

double withOneDigit(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return std::round(value / unit) * unit;
}
}

void vtkSunlight::WarnOfDepth(vtkDataSet* data, const Work& work)
{
  const double densest =
    work.Extinction.empty() ? 0 : *std::max_element(work.Extinction.begin(), work.Extinction.end());
  const char* remedy =
    "The extinction is per unit of length of the data: set ExtinctionScale, such as ";
  const double cell = medianDepth(data, work.Extinction), whole = densest * data->GetLength();
  if (cell > opaqueCell)
  {
    vtkWarningMacro(<< "Half of the cells have an optical depth above " << withOneDigit(cell)
                    << " along their shortest edge, so only the outer faces are visible. " << remedy
                    << withOneDigit(this->ExtinctionScale / cell) << ", if '"
                    << this->UsedExtinction << "' is no extinction or has another unit.");
  }
  else if (densest > 0 && whole < clearData)
  {
    vtkWarningMacro(
      << "The clouds are hardly visible: their greatest optical depth, across all of the data, is "
      << withOneDigit(whole) << ". " << remedy << withOneDigit(this->ExtinctionScale * 10 / whole)
      << ", if '" << this->UsedExtinction << "' has another unit.");
  }
}
