// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The half of GlobeGridBuilder's plan that judges what the numbers mean: units of levels and
// heights, degrees, winds.
#include "GlobeGridBuilder.h"

#include "FieldUnits.h"
#include "LongitudeRow.h"
#include "MissingValue.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace nephoscope
{
namespace
{
constexpr double EARTH_RADIUS = 6371000.0;
constexpr double LOWEST_PLAUSIBLE = -1000.0;   // m
constexpr double HIGHEST_PLAUSIBLE = 100000.0; // m: where space begins
constexpr double THINNEST_PLAUSIBLE = 100.0;   // m, of a grid that is wider than a degree
constexpr int SAMPLES_ALONG_AXIS = 24;
constexpr double TURNED_GRID = 1.0; // degrees

std::vector<double> LevelsOf(const LonLatLevelGrid& grid)
{
  std::vector<double> levels;
  for (int k = 0; k < grid.Dimensions()[2]; ++k)
  {
    levels.push_back(grid.Coordinates({ 0, 0, k })[2]);
  }
  return levels;
}

// Indices from 0 to count - 1, evenly spread, with both ends.
std::vector<int> Spread(int count)
{
  std::vector<int> indices;
  const int samples = std::min(count, SAMPLES_ALONG_AXIS);
  for (int s = 0; s < samples; ++s)
  {
    indices.push_back(
      samples > 1 ? static_cast<int>(static_cast<long long>(s) * (count - 1) / (samples - 1)) : 0);
  }
  return indices;
}

bool IsEarth(const GlobeGridSettings& settings)
{
  return std::abs(settings.Planet.radius / EARTH_RADIUS - 1.0) < 0.1;
}

std::string Text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string UnitName(HeightUnits units)
{
  return units == HeightUnits::Geopotential ? "a geopotential in m2 s-2"
    : units == HeightUnits::Kilometre       ? "heights in kilometres"
    : units == HeightUnits::Decametre       ? "heights in decametres"
                                            : "heights in metres";
}
}

void GlobeGridBuilder::FindLevelUnits()
{
  this->Units = this->Settings.Units;
  const std::vector<double> levels = LevelsOf(this->Grid);
  if (this->Units == LevelUnits::Automatic)
  {
    const auto ends = std::minmax(levels.front(), levels.back());
    const HeightTrend trend = this->TrendOfHeights();
    this->Units =
      AreIndices(levels) ? LevelUnits::Index : GuessLevelUnits(ends.first, ends.second, trend);
    const double deepest = -ends.first;
    if (IsPressure(this->Units) && deepest > 0.0 && trend == HeightTrend::Unknown &&
      levels.size() > 1 && !EndsNearGround(this->Units, deepest))
    {
      this->Notes.push_back("The level axis points down and ends at " + Text(deepest) +
        ", which is not an air pressure near the "
        "ground. It is taken as a pressure in " +
        (this->Units == LevelUnits::Hectopascal ? "hPa" : "Pa") +
        ". Set LevelUnits to confirm this, or to a height if it is a depth.");
    }
  }
  if (this->Units == LevelUnits::Sigma && !this->Heights)
  {
    this->Notes.push_back(
      "The levels end near 1, like sigma and hybrid levels. Pressures of such levels depend on the position and are not "
      "in the input. The heights assume a ground pressure of 1013.25 hPa. Load an array of heights in metres "
      "and set HeightArrayName, or set LevelUnits if these are pressures.");
  }
  if (this->Units == LevelUnits::Index && !this->Heights)
  {
    this->Notes.push_back("The level axis runs from " + Text(levels.front()) + " to " +
      Text(levels.back()) +
      " in steps of 1. These look like numbers of levels, not heights. They are taken as metres, so the grid is almost flat. "
      "Load an array of heights and set HeightArrayName, or set LevelUnits if they are pressures or heights.");
  }
}

void GlobeGridBuilder::FindHeightUnits(vtkFieldData* fieldData)
{
  HeightUnits units = this->Settings.HeightsIn;
  const std::string& name = this->Settings.Height;
  const double ratio = IsEarth(this->Settings) ? this->RatioToStandardAtmosphere() : std::nan("");
  const std::string said = UnitsOf(fieldData, name);
  const bool told = units != HeightUnits::Automatic;
  units = told ? units : HeightUnitsOf(said);
  if (units == HeightUnits::Automatic)
  {
    units = ratio > 0.0 ? GuessHeightUnits(ratio) : HeightUnits::Metre;
    if (units != HeightUnits::Automatic && units != HeightUnits::Metre)
    {
      this->Notes.push_back("The height array '" + name + "' has no units. Its values are " +
        Text(ratio) +
        " times the heights of the standard atmosphere at these pressures, so it is taken as " +
        UnitName(units) + ". Set HeightUnits to confirm or change this.");
    }
  }
  if (ratio > 0.0 && !RatioFits(ratio, units))
  {
    this->Notes.push_back("The height array '" + name + "'" +
      (said.empty() ? "" : ", whose units are '" + said + "',") + " is implausible: taken as " +
      UnitName(units) + ", it is " + Text(ratio * MetresPer(units)) +
      " times as high as the standard atmosphere at these pressures. Set HeightUnits, HeightArrayName or LevelUnits.");
  }
  this->HeightScale = MetresPer(units);
}

// The mean ratio of the height array to the heights of the levels' pressures, from 1 km up; not a
// number without pressures.
double GlobeGridBuilder::RatioToStandardAtmosphere() const
{
  double sum = 0.0;
  long long count = 0;
  for (int k = 0; k < this->Grid.Dimensions()[2]; ++k)
  {
    const double level = this->Grid.Coordinates({ 0, 0, k })[2];
    const double standard = LevelHeight(this->Units, level);
    if ((!IsPressure(this->Units) && this->Units != LevelUnits::Sigma) || standard < 1000.0 ||
      standard > 50000.0)
    {
      continue;
    }
    for (const int j : Spread(this->Grid.Dimensions()[1]))
    {
      for (const int i : Spread(this->Grid.Dimensions()[0]))
      {
        const double height = this->Heights->GetComponent(this->Grid.Id({ i, j, k }), 0);
        sum += IsMissing(height) ? 0.0 : height / standard;
        count += IsMissing(height) ? 0 : 1;
      }
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : std::nan("");
}

void GlobeGridBuilder::CheckHeights()
{
  if (!IsEarth(this->Settings))
  {
    return;
  }
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (int k = 0; k < this->Grid.Dimensions()[2]; ++k)
  {
    for (const int j : Spread(this->Grid.Dimensions()[1]))
    {
      for (const int i : Spread(this->Grid.Dimensions()[0]))
      {
        bool missing = false;
        const double height = this->HeightOf(
          this->Grid.Id({ i, j, k }), this->Grid.Coordinates({ i, j, k })[2], missing);
        lowest = missing ? lowest : std::min(lowest, height);
        highest = missing ? highest : std::max(highest, height);
      }
    }
  }
  const std::string range = "The heights run from " + Text(lowest) + " to " + Text(highest) + " m";
  const bool ofArray = this->Heights != nullptr;
  const bool deep = lowest < LOWEST_PLAUSIBLE && ofArray; // of a level axis these are depths
  if (deep || highest > HIGHEST_PLAUSIBLE)
  {
    this->Notes.push_back(range + ", which is implausible on Earth. " +
      (ofArray
          ? "Set HeightUnits if '" + this->Settings.Height +
            "' is a geopotential (m2 s-2) or in kilometres, or choose another HeightArrayName."
          : "Set LevelUnits to what the level axis is: a pressure in hPa or Pa, or a height in m or km."));
  }
  const std::vector<double> row = this->Grid.MiddleRow();
  const bool guessed =
    this->Settings.Units == LevelUnits::Automatic && this->Units == LevelUnits::Metre;
  if (!ofArray && guessed && highest > lowest && highest - lowest < THINNEST_PLAUSIBLE &&
    std::abs(row.back() - row.front()) > 1.0)
  {
    this->Notes.push_back(range +
      " only. If the level axis is in kilometres or is a pressure, set LevelUnits. If it holds numbers of "
      "levels, load an array of heights and set HeightArrayName.");
  }
}

void GlobeGridBuilder::CheckAxes()
{
  std::vector<double> row = this->Grid.MiddleRow();
  if (JudgeCoverage(row) == Coverage::Overlap)
  {
    this->Notes.push_back(
      "The longitudes cover more than one turn, so cells overlap. Extract one turn "
      "(Extract Subset) before this filter.");
  }
  double largest = 0.0;
  for (int j = 0; j < this->Grid.Dimensions()[1]; ++j)
  {
    largest = std::max(largest, std::abs(this->Grid.Coordinates({ 0, j, 0 })[1]));
  }
  // One turn and a pole in radians: as degrees, a patch of 6 by 3 degrees about the equator.
  for (double& longitude : row)
  {
    longitude /= geodesy::RADIANS_PER_DEGREE;
  }
  const Coverage turned = JudgeCoverage(row);
  if ((turned == Coverage::Open || turned == Coverage::Closed) && largest > 1.3 && largest < 1.5709)
  {
    this->Notes.push_back(
      "Longitudes and latitudes look like radians: multiplied by 57.29578 they go once around the globe and from pole to "
      "pole. The filter needs degrees: multiply both axes by that number before it.");
  }
}

// By the names of the arrays, else with a warning where the rows of the grid leave the parallels.
void GlobeGridBuilder::FindWindComponents()
{
  const std::string& east = this->Settings.Eastward;
  const bool named = east == "x_wind" || east == "grid_eastward_wind";
  const bool automatic = this->Settings.Components == WindComponents::Automatic;
  this->WindsAlongGrid = this->U && this->Grid.IsCurvilinear() &&
    (this->Settings.Components == WindComponents::AlongGrid || (automatic && named));
  if (!this->U || !automatic || named || !this->Grid.IsCurvilinear())
  {
    return;
  }
  double largest = 0.0;
  for (const int j : Spread(this->Grid.Dimensions()[1]))
  {
    for (const int i : Spread(this->Grid.Dimensions()[0]))
    {
      double u = 1.0;
      double v = 0.0;
      this->TurnFromGrid({ i, j, 0 }, u, v);
      largest = std::max(largest, std::abs(std::atan2(v, u)) / geodesy::RADIANS_PER_DEGREE);
    }
  }
  if (largest > TURNED_GRID)
  {
    this->Notes.push_back("The rows of the grid deviate by up to " + Text(std::round(largest)) +
      " degrees from the parallels, but the winds '" + east + "' and '" + this->Settings.Northward +
      "' are taken as eastward and northward. If they are along the grid (GRIB: uvRelativeToGrid = 1; CF: x_wind, y_wind), set "
      "WindComponents to Along Grid; else set it to East And North.");
  }
}
}
