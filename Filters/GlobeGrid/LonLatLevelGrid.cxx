// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LonLatLevelGrid.h"

#include "ArrayLengths.h"
#include "ArrayNames.h"
#include "LongitudeRow.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nephoscope
{
namespace
{
constexpr double LATITUDE_TOLERANCE = 1e-4; // degrees; single-precision axes
const char* const AXIS_NAMES[3] = { "longitude", "latitude", "level" };

std::vector<double> Values(vtkDataArray* array)
{
  std::vector<double> values(array ? array->GetNumberOfTuples() : 0);
  for (size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

// A latitude a rounding away from the pole is at the pole.
double SnapLatitude(double latitude)
{
  const bool nearPole = std::abs(std::abs(latitude) - 90.0) <= LATITUDE_TOLERANCE;
  return nearPole ? std::copysign(90.0, latitude) : latitude;
}

std::string LatitudeMessage(double latitude)
{
  std::ostringstream text;
  text << "The second axis must be latitude in degrees, within -90 to 90, but has the value "
       << latitude
       << ". The axes must be longitude, latitude, level; with the NetCDF CF reader switch "
          "'Spherical Coordinates' off.";
  return text.str();
}

std::string MonotoneMessage(int axis, size_t index)
{
  std::ostringstream text;
  text << "The " << AXIS_NAMES[axis]
       << " axis must increase or decrease throughout, but does not at index " << index
       << ". Sort the " << AXIS_NAMES[axis]
       << "s and remove repeated or missing ones before this filter.";
  return text.str();
}

// The first index where the axis stands still, turns, or is not a number; 0 if it never does.
size_t FirstFault(const std::vector<double>& axis)
{
  if (!axis.empty() && !std::isfinite(axis[0]))
  {
    return axis.size();
  }
  for (size_t i = 1; i < axis.size(); ++i)
  {
    const double rise = (axis[i] - axis[i - 1]) * (axis.back() - axis.front());
    if (!(rise > 0.0))
    {
      return i;
    }
  }
  return 0;
}
}

std::string LonLatLevelGrid::Read(vtkDataSet* grid, bool cellCentres)
{
  if (!grid || grid->GetNumberOfPoints() == 0)
  {
    return "The input is empty: there are no points. Check the reader and its file.";
  }
  if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    if (!image->GetDirectionMatrix()->IsIdentity())
    {
      return "The input image has a direction matrix; its axes must be longitude, latitude, level.";
    }
  }
  const std::string problem = ArrayLengthProblem(grid);
  if (!problem.empty())
  {
    return problem;
  }
  this->ReadAxes(grid);
  this->AtCellCentres = cellCentres;
  this->OnPoints = grid->GetPointData();
  this->OnCells = grid->GetCellData();
  if (cellCentres)
  {
    this->TakeCellCentres();
  }
  const int extended = static_cast<int>(
    std::count_if(this->Size.begin(), this->Size.end(), [](int n) { return n > 1; }));
  if (extended < 2)
  {
    return "The input has fewer than two axes of more than one point; a grid needs at least two "
           "longitudes and two latitudes, or one of them and two levels.";
  }
  return this->Points ? this->CheckPoints() : this->CheckAxes();
}

void LonLatLevelGrid::ReadAxes(vtkDataSet* grid)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetExtent(extent);
    this->Axes = { Values(rectilinear->GetXCoordinates()), Values(rectilinear->GetYCoordinates()),
      Values(rectilinear->GetZCoordinates()) };
  }
  else if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    image->GetExtent(extent);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int index = extent[2 * axis]; index <= extent[2 * axis + 1]; ++index)
      {
        this->Axes[axis].push_back(image->GetOrigin()[axis] + index * image->GetSpacing()[axis]);
      }
    }
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    structured->GetExtent(extent);
    this->Points = structured->GetPoints();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->First[axis] = extent[2 * axis];
    this->Size[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  this->CornerSize = this->Size;
}

void LonLatLevelGrid::TakeCellCentres()
{
  this->OnPoints = this->OnCells;
  this->OnCells = nullptr;
  UnwrapLongitudes(this->Axes[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& edges = this->Axes[axis];
    if (this->Size[axis] < 2)
    {
      continue; // flat along this axis: its cells lie at its only point
    }
    --this->Size[axis];
    for (size_t i = 0; i + 1 < edges.size(); ++i)
    {
      edges[i] = 0.5 * (edges[i] + edges[i + 1]);
    }
    edges.resize(edges.empty() ? 0 : edges.size() - 1);
  }
}

std::string LonLatLevelGrid::CheckAxes()
{
  UnwrapLongitudes(this->Axes[0]);
  for (double& latitude : this->Axes[1])
  {
    latitude = SnapLatitude(latitude);
    if (!(std::abs(latitude) <= 90.0))
    {
      return LatitudeMessage(latitude);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (const size_t fault = FirstFault(this->Axes[axis]))
    {
      return MonotoneMessage(axis, fault);
    }
  }
  return std::string();
}

std::string LonLatLevelGrid::CheckPoints()
{
  bool unitSphere = this->Points->GetNumberOfPoints() > 8;
  for (vtkIdType id = 0; id < this->Points->GetNumberOfPoints(); ++id)
  {
    double x[3];
    this->Points->GetPoint(id, x);
    if (!std::isfinite(x[0] + x[1] + x[2]))
    {
      return "Point " + std::to_string(id) +
        " of the structured grid has a coordinate that is not a number.";
    }
    const double radius = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    unitSphere = unitSphere && std::abs(radius - 1.0) < 1e-5;
    // Corners of cells around the poles may lie half a cell beyond them.
    const double largest = this->AtCellCentres ? 100.0 : 90.0;
    if (!(std::abs(SnapLatitude(x[1])) <= largest))
    {
      return LatitudeMessage(x[1]);
    }
  }
  if (unitSphere)
  {
    return "The points of the structured grid lie on a unit sphere, not on longitudes and latitudes; with "
           "the NetCDF CF reader switch 'Spherical Coordinates' off.";
  }
  this->UnwrapRows();
  return std::string();
}

// Down the first column, then along each row, so that neighbours never jump.
void LonLatLevelGrid::UnwrapRows()
{
  this->ReferenceLongitudes.resize(static_cast<size_t>(this->Size[0]) * this->Size[1]);
  std::vector<double> column(this->Size[1]);
  for (int j = 0; j < this->Size[1]; ++j)
  {
    column[j] = this->Coordinates({ 0, j, 0 })[0];
  }
  UnwrapLongitudes(column);
  std::vector<double> row(this->Size[0]);
  for (int j = 0; j < this->Size[1]; ++j)
  {
    row[0] = column[j];
    for (int i = 1; i < this->Size[0]; ++i)
    {
      row[i] = this->Coordinates({ i, j, 0 })[0];
    }
    UnwrapLongitudes(row);
    std::copy(row.begin(), row.end(),
      this->ReferenceLongitudes.begin() + static_cast<size_t>(j) * this->Size[0]);
  }
}

std::array<double, 3> LonLatLevelGrid::Corner(const std::array<int, 3>& index) const
{
  const vtkIdType id = index[0] +
    static_cast<vtkIdType>(this->CornerSize[0]) *
      (index[1] + static_cast<vtkIdType>(this->CornerSize[1]) * index[2]);
  std::array<double, 3> x;
  this->Points->GetPoint(id, x.data());
  return x;
}

std::array<double, 3> LonLatLevelGrid::Coordinates(const std::array<int, 3>& index) const
{
  if (!this->Points)
  {
    return { this->Axes[0][index[0]], this->Axes[1][index[1]], this->Axes[2][index[2]] };
  }
  std::array<double, 3> x = this->Corner(index);
  if (this->AtCellCentres)
  {
    const double reference = x[0];
    std::array<double, 3> sum = { 0.0, 0.0, 0.0 };
    for (int corner = 0; corner < 8; ++corner)
    {
      std::array<int, 3> at;
      for (int axis = 0; axis < 3; ++axis)
      {
        at[axis] = std::min(index[axis] + ((corner >> axis) & 1), this->CornerSize[axis] - 1);
      }
      const std::array<double, 3> y = this->Corner(at);
      sum[0] += std::remainder(y[0] - reference, 360.0);
      sum[1] += y[1];
      sum[2] += y[2];
    }
    x = { reference + sum[0] / 8.0, sum[1] / 8.0, sum[2] / 8.0 };
  }
  x[1] = std::max(-90.0, std::min(90.0, SnapLatitude(x[1])));
  return x;
}

double LonLatLevelGrid::UnwrappedLongitude(const std::array<int, 3>& index) const
{
  const double longitude = this->Coordinates(index)[0];
  if (!this->Points)
  {
    return longitude;
  }
  const double reference =
    this->ReferenceLongitudes[index[0] + static_cast<size_t>(this->Size[0]) * index[1]];
  return reference + std::remainder(longitude - reference, 360.0);
}

std::vector<double> LonLatLevelGrid::MiddleRow() const
{
  std::vector<double> row(this->Size[0]);
  for (int i = 0; i < this->Size[0]; ++i)
  {
    row[i] = this->UnwrappedLongitude({ i, this->Size[1] / 2, 0 });
  }
  return row;
}

bool LonLatLevelGrid::IsPoleRow(int j, int k) const
{
  const int columns = this->Points ? this->Size[0] : 1;
  for (int i = 0; i < columns; ++i)
  {
    if (std::abs(this->Coordinates({ i, j, k })[1]) != 90.0)
    {
      return false;
    }
  }
  return true;
}

bool LonLatLevelGrid::RowLatitude(int j, double& latitude) const
{
  latitude = this->Coordinates({ 0, j, 0 })[1];
  const int columns = this->Points ? this->Size[0] : 1;
  for (int i = 1; i < columns; ++i)
  {
    if (std::abs(this->Coordinates({ i, j, 0 })[1] - latitude) > LATITUDE_TOLERANCE)
    {
      return false;
    }
  }
  return true;
}

vtkDataArray* LonLatLevelGrid::Array(const std::string& name) const
{
  vtkDataArray* array = name.empty() ? nullptr : this->OnPoints->GetArray(name.c_str());
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

std::string LonLatLevelGrid::ArrayNames() const
{
  return NamesOfArrays(this->OnPoints);
}

bool DataAreOnCells(vtkDataSet* grid, const std::vector<std::string>& names)
{
  bool onCells = false;
  for (const std::string& name : names)
  {
    if (grid->GetPointData()->HasArray(name.c_str()))
    {
      return false;
    }
    onCells = onCells || grid->GetCellData()->HasArray(name.c_str());
  }
  return onCells ||
    (grid->GetPointData()->GetNumberOfArrays() == 0 &&
      grid->GetCellData()->GetNumberOfArrays() > 0);
}
}
