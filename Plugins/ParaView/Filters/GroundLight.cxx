// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundLight.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
double LessThanHalfTurn(double angle)
{
  return std::remainder(angle, 2 * vtkMath::Pi());
}

struct Place
{
  double Longitude, Latitude;
};

// Into an array: VTK 9.6 has no other form for a structured grid.
std::array<int, 3> DimensionsOf(vtkStructuredGrid* grid)
{
  std::array<int, 3> dimensions;
  grid->GetDimensions(dimensions.data());
  return dimensions;
}

Place PlaceOf(vtkStructuredGrid* grid, int column, int row)
{
  double x[3];
  grid->GetPoint(static_cast<vtkIdType>(row) * DimensionsOf(grid)[0] + column, x);
  return { std::atan2(x[1], x[0]), std::asin(x[2] / vtkMath::Norm(x)) };
}
}

GroundLight::GroundLight(vtkStructuredGrid* lit)
  : Irradiance(lit->GetPointData()->GetArray("Irradiance"))
  , Columns(DimensionsOf(lit)[0])
  , Rows(DimensionsOf(lit)[1])
{
  const int middle = this->Rows / 2; // longitudes of a pole mean nothing
  const Place first = PlaceOf(lit, 0, middle);
  this->FirstLongitude = first.Longitude;
  this->LongitudeStep = LessThanHalfTurn(PlaceOf(lit, 1, middle).Longitude - first.Longitude);
  this->FirstLatitude = PlaceOf(lit, 0, 0).Latitude;
  this->LatitudeStep =
    (PlaceOf(lit, 0, this->Rows - 1).Latitude - this->FirstLatitude) / (this->Rows - 1);
}

double GroundLight::Value(int column, int row) const
{
  const vtkIdType point = static_cast<vtkIdType>(row) * this->Columns + column;
  return this->Irradiance->GetComponent(point, 0);
}

double GroundLight::At(double longitude, double latitude) const
{
  double turn = LessThanHalfTurn(longitude - this->FirstLongitude);
  turn += turn < 0 ? 2 * vtkMath::Pi() : 0; // the last column is the first one again
  const double x = std::clamp(turn / this->LongitudeStep, 0.0, this->Columns - 1.0);
  const double y =
    std::clamp((latitude - this->FirstLatitude) / this->LatitudeStep, 0.0, this->Rows - 1.0);
  const int i = std::min(static_cast<int>(x), this->Columns - 2);
  const int j = std::min(static_cast<int>(y), this->Rows - 2);
  const auto alongRow = [&](int row) {
    return this->Value(i, row) + (x - i) * (this->Value(i + 1, row) - this->Value(i, row));
  };
  return alongRow(j) + (y - j) * (alongRow(j + 1) - alongRow(j));
}

}
