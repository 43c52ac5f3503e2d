// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeShape.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double PI = GlobeColumns::PI;
// Radians; single precision coordinates are good to 1e-7.
constexpr double ANGLE_TOLERANCE = 2e-6;

bool NumberOf(vtkDataSet* data, const char* name, double& value)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  const bool found = array && array->GetNumberOfTuples() == 1;
  value = found ? array->GetComponent(0, 0) : value;
  return found;
}

double LatitudeOf(const double p[3])
{
  return std::atan2(p[2], std::hypot(p[0], p[1]));
}

// From an angle to the next, eastwards.
double Eastwards(double from, double to)
{
  const double way = std::fmod(to - from, TURN);
  return way < 0.0 ? way + TURN : way;
}
}

bool GlobeShape::Recognize(
  vtkDataSet* data, GridKind kind, double planetRadius, std::string& problem)
{
  auto* grid = vtkStructuredGrid::SafeDownCast(data);
  if (!grid || kind == GridKind::Cartesian)
  {
    problem =
      "A grid on a globe or a map is a structured grid with curvilinear points, as Globe Grid makes it; this is "
      "another dataset. Put the fields through Globe Grid first.";
    return false;
  }
  double projection = -1.0;
  this->Radius_ = planetRadius;
  const bool told = NumberOf(data, "GlobeGridProjection", projection);
  const bool hasRadius = NumberOf(data, "PlanetRadius", this->Radius_);
  this->OnMap = kind == GridKind::Map || (kind == GridKind::Automatic && told && projection == 1.0);
  grid->GetDimensions(this->Size);
  if (this->Size[0] < 2 || this->Size[1] < 2 || this->Size[2] < 1)
  {
    problem = "The grid has fewer than two columns or rows of points.";
    return false;
  }
  if (this->OnMap)
  {
    return this->RecognizeMap(grid, problem);
  }
  if (!hasRadius && !(this->Radius_ > 0.0))
  {
    double first[3];
    grid->GetPoint(0, first);
    this->Radius_ = LengthOf(first);
  }
  return this->RecognizeGlobe(grid, problem);
}

bool GlobeShape::RecognizeGlobe(vtkStructuredGrid* grid, std::string& problem)
{
  std::vector<double> longitudes;
  std::vector<double> latitudes;
  double p[3];
  for (int j = 0; j < this->Size[1]; ++j)
  {
    grid->GetPoint(this->IndexOfData(0, j, 0), p);
    latitudes.push_back(LatitudeOf(p));
  }
  const auto nearest = std::min_element(latitudes.begin(), latitudes.end(),
    [](double a, double b) { return std::abs(a) < std::abs(b); });
  const int equator = static_cast<int>(nearest - latitudes.begin());
  for (int i = 0; i < this->Size[0]; ++i)
  {
    grid->GetPoint(this->IndexOfData(i, equator, 0), p);
    const double angle = std::atan2(p[1], p[0]);
    const double before = longitudes.empty() ? angle : longitudes.back();
    longitudes.push_back(before + Eastwards(before, angle));
  }
  return this->AdoptAxes(std::move(longitudes), std::move(latitudes), problem) &&
    (this->Fits(grid) ||
      (problem =
          "The points are not on meridians and parallels of a globe that is centred at the origin with its axis along z.",
        false));
}

bool GlobeShape::RecognizeMap(vtkStructuredGrid* grid, std::string& problem)
{
  if (!(this->Radius_ > 0.0))
  {
    problem =
      "The planet's radius is needed to tell longitudes from a map's lengths. Set PlanetRadius.";
    return false;
  }
  std::vector<double> longitudes;
  std::vector<double> latitudes;
  double p[3];
  for (int i = 0; i < this->Size[0]; ++i)
  {
    grid->GetPoint(this->IndexOfData(i, 0, 0), p);
    longitudes.push_back(p[0] / this->Radius_);
  }
  for (int j = 0; j < this->Size[1]; ++j)
  {
    grid->GetPoint(this->IndexOfData(0, j, 0), p);
    latitudes.push_back(p[1] / this->Radius_);
  }
  return this->AdoptAxes(std::move(longitudes), std::move(latitudes), problem) &&
    (this->Fits(grid) || (problem = "The points are not on columns and rows of a map.", false));
}

bool GlobeShape::AdoptAxes(
  std::vector<double> longitudes, std::vector<double> latitudes, std::string& problem)
{
  const auto rises = [](const std::vector<double>& axis) {
    return std::adjacent_find(
             axis.begin(), axis.end(), [](double a, double b) { return !(b > a); }) == axis.end();
  };
  const double span = longitudes.back() - longitudes.front();
  if (!rises(longitudes) || !rises(latitudes) || span > TURN + 1e-5 ||
    latitudes.front() < -0.5 * PI - 1e-6 || latitudes.back() > 0.5 * PI + 1e-6)
  {
    problem =
      "Longitudes must increase from column to column by no more than a turn in all, and latitudes from row to row. "
      "Sort the columns and rows of the grid by their coordinates.";
    return false;
  }
  this->Longitudes = longitudes;
  this->Latitudes = latitudes;
  const double gap = TURN - span;
  const double widest = span / static_cast<double>(longitudes.size() - 1);
  this->ColumnAdded = gap > 1e-5 && gap < 1.5 * widest && longitudes.size() > 2;
  if (this->ColumnAdded)
  {
    longitudes.push_back(longitudes.front() + TURN);
  }
  else if (std::abs(gap) <= 1e-5)
  {
    longitudes.back() = longitudes.front() + TURN;
  }
  const bool closed = this->ColumnAdded || std::abs(gap) <= 1e-5;
  const auto lacksPole = [&](double last, double before) {
    const double left = 0.5 * PI - std::abs(last);
    return closed && left > ANGLE_TOLERANCE && left < 2.5 * std::abs(last - before);
  };
  const std::size_t rows = latitudes.size();
  this->SouthRows = lacksPole(latitudes[0], latitudes[1]) && latitudes[0] < 0.0 ? 1 : 0;
  this->NorthRows =
    lacksPole(latitudes[rows - 1], latitudes[rows - 2]) && latitudes[rows - 1] > 0.0 ? 1 : 0;
  const auto toPole = [](double& latitude) {
    latitude = 0.5 * PI - std::abs(latitude) < ANGLE_TOLERANCE ? std::copysign(0.5 * PI, latitude)
                                                               : latitude;
  };
  toPole(latitudes.front());
  toPole(latitudes.back());
  if (this->SouthRows)
  {
    latitudes.insert(latitudes.begin(), -0.5 * PI);
  }
  if (this->NorthRows)
  {
    latitudes.push_back(0.5 * PI);
  }
  this->Columns_ = GlobeColumns(std::move(longitudes), latitudes);
  return true;
}

bool GlobeShape::Fits(vtkDataSet* data) const
{
  auto* grid = vtkStructuredGrid::SafeDownCast(data);
  int size[3] = { 0, 0, 0 };
  if (!grid || !grid->GetPoints())
  {
    return false;
  }
  grid->GetDimensions(size);
  if (!std::equal(size, size + 3, this->Size))
  {
    return false;
  }
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const double latitude = this->Latitudes[static_cast<std::size_t>(j)];
      for (int i = 0; i < size[0]; ++i)
      {
        double p[3];
        grid->GetPoint(this->IndexOfData(i, j, k), p);
        const double longitude = this->Longitudes[static_cast<std::size_t>(i)];
        double expected[3] = { longitude, latitude, p[2] / this->Radius_ };
        double scale = 1.0 / this->Radius_;
        if (!this->OnMap)
        {
          const double cosine = std::cos(latitude);
          expected[0] = cosine * std::cos(longitude);
          expected[1] = cosine * std::sin(longitude);
          expected[2] = std::sin(latitude);
          scale = 1.0 / LengthOf(p);
        }
        for (int c = 0; c < 3; ++c)
        {
          if (!(std::abs(p[c] * scale - expected[c]) < 3.0 * ANGLE_TOLERANCE))
          {
            return false;
          }
        }
      }
    }
  }
  return true;
}

void GlobeShape::PlaceOf(const double position[3], double direction[3], double& height) const
{
  if (this->OnMap)
  {
    const double longitude = position[0] / this->Radius_;
    const double latitude = std::clamp(position[1] / this->Radius_, -0.5 * PI, 0.5 * PI);
    const double cosine =
      0.5 * PI - std::abs(latitude) < ANGLE_TOLERANCE ? 0.0 : std::cos(latitude);
    direction[0] = cosine * std::cos(longitude);
    direction[1] = cosine * std::sin(longitude);
    direction[2] = std::sin(latitude);
    height = position[2];
    return;
  }
  const double length = LengthOf(position);
  for (int c = 0; c < 3; ++c)
  {
    direction[c] = length > 0.0 ? position[c] / length : c == 2 ? 1.0 : 0.0;
  }
  height = length - this->Radius_;
}

double GlobeShape::LongitudeOf(int column) const
{
  return this->Longitudes[static_cast<std::size_t>(std::clamp(column, 0, this->Size[0] - 1))];
}

std::int64_t GlobeShape::Index(int column, int row, int level) const
{
  return column +
    static_cast<std::int64_t>(this->Columns_.ColumnCount()) *
    (row + static_cast<std::int64_t>(this->Columns_.RowCount()) * level);
}

std::int64_t GlobeShape::IndexOfData(int i, int j, int k) const
{
  return i +
    static_cast<std::int64_t>(this->Size[0]) * (j + static_cast<std::int64_t>(this->Size[1]) * k);
}
}
