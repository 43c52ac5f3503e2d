// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The half of GlobeGridBuilder's plan that finds arrays, the order of the axes, seam and poles.
#include "GlobeGridBuilder.h"

#include "FieldUnits.h"
#include "LongitudeRow.h"
#include "MissingValue.h"
#include "PoleRows.h"

#include "vtkDataArray.h"

#include <algorithm>

namespace nephoscope
{
GridOrder PlanColumns(const LonLatLevelGrid& grid, const GlobeGridSettings& settings)
{
  GridOrder order;
  order.InputDimensions = order.OutputDimensions = grid.Dimensions();
  std::vector<double> row = grid.MiddleRow();
  const int columns = order.InputDimensions[0];
  order.Reversed[0] = row.back() < row.front();
  if (order.Reversed[0])
  {
    std::reverse(row.begin(), row.end());
  }
  const bool rotated = settings.OnMap && settings.UseCentralMeridian;
  const Coverage coverage = JudgeCoverage(row);
  order.InputIsClosed = coverage == Coverage::Closed;
  if (order.InputIsClosed)
  {
    order.Period = columns - 1;
  }
  else if (coverage == Coverage::Open && (settings.CloseSeam || rotated))
  {
    order.Period = columns;
    order.OutputDimensions[0] = columns + (settings.CloseSeam ? 1 : 0);
  }
  if (rotated)
  {
    order.Centre(row, settings.CentralMeridian);
  }
  return order;
}

bool SpansAllLongitudes(const LonLatLevelGrid& grid)
{
  const Coverage coverage = JudgeCoverage(grid.MiddleRow());
  return coverage == Coverage::Open || coverage == Coverage::Closed;
}

GridOrder PlanRows(const LonLatLevelGrid& grid, const GlobeGridSettings& settings)
{
  GridOrder order = PlanColumns(grid, settings);
  const int last = order.InputDimensions[1] - 1;
  const int middle = order.InputDimensions[0] / 2;
  order.Reversed[1] =
    grid.Coordinates({ middle, last, 0 })[1] < grid.Coordinates({ middle, 0, 0 })[1];
  if (settings.ClosePoles && SpansAllLongitudes(grid))
  {
    order.AddPoles(MissingPoles(grid));
  }
  return order;
}

std::string GlobeGridBuilder::Plan(vtkFieldData* units, const LonLatLevelGrid* surface)
{
  this->Order_ = PlanRows(this->Grid, this->Settings);
  this->CheckAxes();
  this->FindHeights(units);
  this->OrderLevels();
  this->CheckHeights();
  const std::string error = this->FindWinds(units);
  this->FindWindComponents();
  if (error.empty() && this->Settings.MaskBelowGround)
  {
    this->FindSurface(surface);
  }
  return error;
}

void GlobeGridBuilder::FindHeights(vtkFieldData* units)
{
  const std::string& name = this->Settings.Height;
  this->Heights = this->Grid.Array(name);
  if (!this->Heights && !name.empty() && name != "gh")
  {
    this->Notes.push_back("There is no one-component point array '" + name +
      "' of heights; the level axis gives the heights. Set HeightArrayName to one of: " +
      this->Grid.ArrayNames() + ".");
  }
  this->Temperatures = this->Grid.Array(this->Settings.Temperature);
  this->FindLevelUnits();
  if (this->Heights)
  {
    this->FindHeightUnits(units);
  }
}

HeightTrend GlobeGridBuilder::TrendOfHeights() const
{
  const std::array<int, 3>& size = this->Grid.Dimensions();
  std::vector<std::array<double, 2>> found; // level, height
  for (int k = 0; this->Heights && k < size[2]; ++k)
  {
    const std::array<int, 3> index = { size[0] / 2, size[1] / 2, k };
    const double height = this->Heights->GetComponent(this->Grid.Id(index), 0);
    if (!IsMissing(height))
    {
      found.push_back({ this->Grid.Coordinates(index)[2], height });
    }
  }
  if (found.size() < 2)
  {
    return HeightTrend::Unknown;
  }
  const double product =
    (found.back()[0] - found.front()[0]) * (found.back()[1] - found.front()[1]);
  return product > 0.0 ? HeightTrend::GrowsWithLevel : HeightTrend::FallsWithLevel;
}

// Bottom to top.
void GlobeGridBuilder::OrderLevels()
{
  const int last = this->Grid.Dimensions()[2] - 1;
  const double levels[2] = { this->Grid.Coordinates({ 0, 0, 0 })[2],
    this->Grid.Coordinates({ 0, 0, last })[2] };
  const HeightTrend trend = this->TrendOfHeights();
  if (trend != HeightTrend::Unknown)
  {
    const bool levelsGrow = levels[1] > levels[0];
    this->Order_.Reversed[2] = levelsGrow != (trend == HeightTrend::GrowsWithLevel);
    return;
  }
  this->Order_.Reversed[2] =
    LevelHeight(this->Units, levels[1]) < LevelHeight(this->Units, levels[0]);
}

std::string GlobeGridBuilder::FindWinds(vtkFieldData* units)
{
  const GlobeGridSettings& names = this->Settings;
  this->U = this->Grid.Array(names.Eastward);
  this->V = this->Grid.Array(names.Northward);
  const std::string remedy = std::string(this->U || this->V ? " Load it" : " Load them") +
    " in the reader, or set the wind array names to those of the input: " +
    this->Grid.ArrayNames() + ".";
  if (!this->U != !this->V)
  {
    return "For the horizontal wind, the one-component point array '" +
      (this->U ? names.Northward : names.Eastward) + "' is missing." + remedy;
  }
  if (!this->U && names.Eastward.empty() && names.Northward.empty())
  {
    return std::string(); // no wind is wanted
  }
  if (!this->U)
  {
    this->Notes.push_back("There are no wind arrays '" + names.Eastward + "' and '" +
      names.Northward + "', so Wind and DisplayVelocity are not made." + remedy);
    return std::string();
  }
  this->W = this->Grid.Array(names.Vertical);
  if (!this->W && !names.Vertical.empty())
  {
    this->Notes.push_back("There is no vertical wind array '" + names.Vertical +
      "'; the vertical wind is 0. Load it, or set its name empty to say so.");
  }
  const std::string unitsOfW = UnitsOf(units, names.Vertical);
  const bool isSpeed = unitsOfW == "ms-1" || unitsOfW == "m/s";
  const bool isOmega = unitsOfW == "pas-1" || unitsOfW == "pa/s";
  if (this->W && (names.VerticalIsOmega ? isSpeed : isOmega))
  {
    this->Notes.push_back("The units of '" + names.Vertical + "' are " + unitsOfW +
      (names.VerticalIsOmega ? ": switch VerticalWindIsOmega off."
                             : ": switch VerticalWindIsOmega on."));
  }
  return std::string();
}

void GlobeGridBuilder::FindSurface(const LonLatLevelGrid* surface)
{
  const GlobeGridSettings& names = this->Settings;
  for (const LonLatLevelGrid* grid : { surface, &this->Grid })
  {
    if (!grid)
    {
      continue;
    }
    vtkDataArray* pressures =
      IsPressure(this->Units) ? grid->Array(names.SurfacePressure) : nullptr;
    vtkDataArray* terrain = grid->Array(names.TerrainHeight);
    if (!pressures && !terrain)
    {
      if (grid == surface)
      {
        this->Notes.push_back("The surface input has neither '" + names.SurfacePressure +
          "' (on pressure levels) nor '" + names.TerrainHeight +
          "'; its arrays are: " + grid->ArrayNames() + ". It is not used.");
      }
      continue;
    }
    const GridOrder order = PlanRows(*grid, names);
    if (grid == surface && !this->SurfaceMatches(*grid, order))
    {
      this->Notes.push_back(
        "The longitudes and latitudes of the surface input are not those of the first "
        "input; it is not used. Read both from one file.");
      continue;
    }
    this->SurfaceGrid = grid;
    this->SurfaceOrder = grid == surface ? order : this->Order_;
    this->SurfacePressures = pressures;
    this->TerrainHeights = terrain;
    if (pressures)
    {
      double range[2];
      pressures->GetFiniteRange(range, 0);
      const double highest = range[1];
      this->SurfacePressureScale = highest < 2000.0 ? 100.0 : 1.0; // hPa or Pa
    }
    return;
  }
}

bool GlobeGridBuilder::SurfaceMatches(const LonLatLevelGrid& surface, const GridOrder& order) const
{
  const std::array<int, 3>& size = this->Order_.OutputDimensions;
  if (order.OutputDimensions[0] != size[0] || order.OutputDimensions[1] != size[1])
  {
    return false;
  }
  for (int j : { 0, size[1] / 2, size[1] - 1 })
  {
    for (int i : { 0, size[0] / 2, size[0] - 1 })
    {
      const std::array<double, 3> a = this->Grid.Coordinates(this->Order_.InputPoint(i, j, 0));
      const std::array<double, 3> b = surface.Coordinates(order.InputPoint(i, j, 0));
      if (std::abs(std::remainder(a[0] - b[0], 360.0)) > 1e-3 || std::abs(a[1] - b[1]) > 1e-3)
      {
        return false;
      }
    }
  }
  return true;
}
}
