// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings about implausible optical depths, for example because an array is not an extinction
// coefficient or has another unit of length; about data without a depth, and light through the
// sides.
#include "vtkSunlight.h"

#include "LightGrid.h"
#include "LitData.h"
#include "vtkSunlightInternals.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr vtkIdType mostSamples = 500;
constexpr double opaqueCell = 30, clearData = 0.003; // optical depths

double ShortestEdge(vtkGenericCell* cell)
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
double MedianDepth(vtkDataSet* data, const std::vector<float>& extinction)
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
    depths.push_back(sum / cell->GetNumberOfPoints() * ShortestEdge(cell));
  }
  if (depths.empty())
  {
    return 0;
  }
  std::nth_element(depths.begin(), depths.begin() + depths.size() / 2, depths.end());
  return depths[depths.size() / 2];
}

// The part of the beam at a side of the grid that enters there and meets clouds.
double BeamThroughSide(const nephoscope::LightGrid& grid, std::size_t p, int axis, bool isLast)
{
  const double inwards = (isLast ? -1 : 1) * grid.SunAt(p)[axis],
               width = grid.Step[p][axis] * (grid.Size[axis] - 1),
               area = grid.Step[p][1 - axis] * grid.Step[p][2];
  return inwards > 0 ? inwards * area * grid.BeamAt(p) * (1 - std::exp(-grid.Extinction[p] * width))
                     : 0;
}

// Power of the beam through the cloudy sides, as a fraction of that through the top; infinite if
// the sun is on the horizon.
double FractionThroughSides(const nephoscope::LightGrid& grid)
{
  double top = 0, sides = 0;
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    const int index[2] = { int(p % grid.Size[0]), int(p / grid.Size[0] % grid.Size[1]) };
    for (int axis = 0; axis < 2; ++axis)
    {
      for (const bool isLast : { false, true })
      {
        const bool isSide = !grid.Closed[axis] && index[axis] == (isLast ? grid.Size[axis] - 1 : 0);
        sides += isSide ? BeamThroughSide(grid, p, axis, isLast) : 0;
      }
    }
    const bool isTop = p + grid.Columns() >= grid.Points();
    top += isTop ? std::max(-grid.SunAt(p)[2], 0.0f) * grid.Step[p][0] * grid.Step[p][1] : 0;
  }
  return sides > 0 ? sides / top : 0;
}

double WithOneDigit(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return std::round(value / unit) * unit;
}

// `fraction` is above one half.
std::string LightThroughSides(double fraction)
{
  if (!std::isfinite(fraction))
  {
    return "all sunlight enters there";
  }
  const double times = WithOneDigit(fraction);
  std::ostringstream amount;
  times > 1 ? amount << times << " times as much"
            : amount << (times < 1 ? "more than half as much" : "about as much");
  amount << " sunlight enters there as from above";
  return amount.str();
}
}

void vtkSunlight::WarnOfDepth(vtkDataSet* data, const Work& work)
{
  const double densest =
    work.Extinction.empty() ? 0 : *std::max_element(work.Extinction.begin(), work.Extinction.end());
  if (densest > 0 && data->GetNumberOfCells() > 0 && !nephoscope::HasCellsInSpace(data))
  {
    vtkWarningMacro(
      << "The data have an extinction, but no 3-D cells: sunlight crosses no medium on its way, so there are no shadows. Give the data a depth: cells between two layers of points, as an image has that is two points thick.");
    return;
  }
  const char* remedy =
    "The extinction is per unit of length of the data: set ExtinctionScale, such as ";
  const double cell = MedianDepth(data, work.Extinction), whole = densest * data->GetLength();
  if (cell > opaqueCell)
  {
    vtkWarningMacro(<< "Half of the cells have an optical depth above " << WithOneDigit(cell)
                    << " along their shortest edge, so only the outer faces are visible. " << remedy
                    << WithOneDigit(this->ExtinctionScale / cell) << ", if '"
                    << this->UsedExtinction << "' is not an extinction or has another unit.");
  }
  else if (densest > 0 && whole < clearData)
  {
    vtkWarningMacro(
      << "The clouds are hardly visible: their maximum optical depth across the data is "
      << WithOneDigit(whole) << ". " << remedy << WithOneDigit(this->ExtinctionScale * 10 / whole)
      << ", if '" << this->UsedExtinction << "' has another unit.");
  }
}

void vtkSunlight::WarnOfSides(const nephoscope::LightGrid& grid)
{
  constexpr double much = 0.5;
  const bool hasRemedy = !grid.Open && !grid.Closed[0] && !grid.Closed[1];
  const double fraction = hasRemedy ? FractionThroughSides(grid) : 0;
  if (fraction > much)
  {
    vtkWarningMacro(
      << "Clouds reach the sides of the data, and " << LightThroughSides(fraction)
      << ". The sides are mirrors for diffuse light, which cannot leave, so the light is too bright. "
         "Turn OpenSides on for clouds that end there, or PeriodicSides for clouds that repeat.");
  }
}
