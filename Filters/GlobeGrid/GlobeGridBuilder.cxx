// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeGridBuilder.h"

#include "ActiveField.h"
#include "CarryArrays.h"
#include "GlobeGridRows.h"
#include "HidePoints.h"
#include "MissingValue.h"
#include "PoleRows.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
bool GlobeGridBuilder::Build(
  const int extent[6], vtkStructuredGrid* output, const std::function<bool(double)>& keepGoing)
{
  int dimensions[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  output->SetDimensions(dimensions);
  this->PlacePoints(extent, output); // PASS 1
  if (!keepGoing(0.3))
  {
    return false;
  }
  CarryPointArrays(this->Grid, this->Order_, extent, output->GetPointData()); // PASS 2
  FillPoleRows(this->Grid, this->Order_, extent, output->GetPointData());
  CarryCellArrays(this->Grid, this->Order_, extent, output->GetCellData());
  ChooseActiveScalars(output->GetPointData()); // of those that are carried
  output->GetPointData()->AddArray(this->HeightArray);
  if (!keepGoing(0.6))
  {
    return false;
  }
  if (this->U)
  {
    this->AddWinds(extent, output); // PASS 3
  }
  if (!keepGoing(0.9))
  {
    return false;
  }
  this->AddMask(extent, output); // PASS 4
  return true;
}

void GlobeGridBuilder::PlacePoints(const int extent[6], vtkStructuredGrid* output)
{
  const vtkIdType count = vtkStructuredData::GetNumberOfPoints(const_cast<int*>(extent));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  auto* positions = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
  this->HeightArray = vtkSmartPointer<vtkFloatArray>::New();
  this->HeightArray->SetName("Height");
  this->HeightArray->SetNumberOfTuples(count);
  float* heights = this->HeightArray->GetPointer(0);
  this->Hidden.assign(count, 0);
  ForEachRow(extent, [&](const OutputRow& row) {
    const bool added = this->Order_.AddedPole(row.j) != 0;
    bool ringMissing = false;
    const double ringHeight = added ? this->RingHeight(row.j, row.k, ringMissing) : 0.0;
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      const vtkIdType id = row.firstId + i - extent[0];
      const std::array<int, 3> input = this->Order_.InputPoint(i, row.j, row.k);
      const std::array<double, 3> x = this->CoordinatesOf({ i, row.j, row.k });
      bool missing = ringMissing;
      const double height =
        added ? ringHeight : this->HeightOf(this->Grid.Id(input), x[2], missing);
      this->Hidden[id] = missing ? HEIGHT_MISSING : 0;
      heights[id] = static_cast<float>(height);
      const double longitude =
        this->Grid.UnwrappedLongitude(input) + this->Order_.LongitudeOffset(i);
      const Vector3 position = this->Settings.OnMap
        ? geodesy::MapPosition(this->Settings.Planet, longitude * geodesy::RADIANS_PER_DEGREE,
            x[1] * geodesy::RADIANS_PER_DEGREE, height)
        : geodesy::GlobePosition(this->Settings.Planet, BasisAt(x), height);
      std::copy(position.begin(), position.end(), positions + 3 * id);
    }
  });
  this->MissingHeights = CountWith(this->Hidden, HEIGHT_MISSING);
  output->SetPoints(points);
}

// Those of the input point, but the latitude of an added pole.
std::array<double, 3> GlobeGridBuilder::CoordinatesOf(const std::array<int, 3>& output) const
{
  std::array<double, 3> x =
    this->Grid.Coordinates(this->Order_.InputPoint(output[0], output[1], output[2]));
  if (const int pole = this->Order_.AddedPole(output[1]))
  {
    x[1] = 90.0 * pole;
  }
  return x;
}

// The height of an added pole: the mean of its ring's. Missing if all of those are.
double GlobeGridBuilder::RingHeight(int j, int k, bool& missing) const
{
  std::vector<double> found;
  double fallback = 0.0;
  for (int i = 0; i < DistinctColumns(this->Order_); ++i)
  {
    const std::array<int, 3> input = this->Order_.InputPoint(i, j, k);
    bool oneMissing = false;
    const double height =
      this->HeightOf(this->Grid.Id(input), this->Grid.Coordinates(input)[2], oneMissing);
    fallback = height;
    if (!oneMissing)
    {
      found.push_back(height);
    }
  }
  missing = found.empty();
  return missing ? fallback : RingValue(found, true);
}

double GlobeGridBuilder::HeightOf(vtkIdType id, double level, bool& missing) const
{
  if (this->Heights)
  {
    const double height = this->Heights->GetComponent(id, 0);
    missing = IsMissing(height);
    if (!missing)
    {
      return height * this->HeightScale;
    }
  }
  return LevelHeight(this->Units, level);
}

double GlobeGridBuilder::PressureOf(double level, double height) const
{
  return IsPressure(this->Units) ? LevelPressure(this->Units, level) : atmosphere::Pressure(height);
}

void GlobeGridBuilder::AddMask(const int extent[6], vtkStructuredGrid* output)
{
  if (this->Settings.MaskBelowGround)
  {
    auto below = NewPointArray<vtkUnsignedCharArray>(output, "BelowGround", 1);
    ForEachRow(extent, [&](const OutputRow& row) {
      const bool added = this->Order_.AddedPole(row.j) != 0; // one place, one answer
      const bool poleHidden = added && this->IsBelowGround({ 0, row.j, row.k });
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const vtkIdType id = row.firstId + i - extent[0];
        const bool hidden = added ? poleHidden : this->IsBelowGround({ i, row.j, row.k });
        below->SetValue(id, hidden ? 1 : 0);
        this->Hidden[id] |= hidden ? BELOW_GROUND : 0;
      }
    });
  }
  HidePoints(this->Hidden, output);
}

bool GlobeGridBuilder::IsBelowGround(const std::array<int, 3>& index) const
{
  const std::array<int, 3> input = this->Order_.InputPoint(index[0], index[1], index[2]);
  const double level = this->Grid.Coordinates(input)[2];
  bool missing = false;
  const double height = this->Order_.AddedPole(index[1]) != 0
    ? this->RingHeight(index[1], index[2], missing)
    : this->HeightOf(this->Grid.Id(input), level, missing);
  if (!this->SurfaceGrid)
  {
    const bool heightsAreOfTheAir = this->Heights || IsPressure(this->Units);
    return heightsAreOfTheAir && !missing && height < 0.0;
  }
  if (this->SurfacePressures)
  {
    const double surface = this->SurfaceValue(this->SurfacePressures, index);
    return !IsMissing(surface) &&
      LevelPressure(this->Units, level) > surface * this->SurfacePressureScale;
  }
  const double terrain = this->SurfaceValue(this->TerrainHeights, index);
  return !IsMissing(terrain) && height < terrain;
}

// At an added pole the mean of its ring's, not a number if all are missing.
double GlobeGridBuilder::SurfaceValue(vtkDataArray* values, const std::array<int, 3>& index) const
{
  const int level = std::min(index[2], this->SurfaceGrid->Dimensions()[2] - 1);
  const auto at = [&](int column) {
    return values->GetComponent(
      this->SurfaceGrid->Id(this->SurfaceOrder.InputPoint(column, index[1], level)), 0);
  };
  if (this->Order_.AddedPole(index[1]) == 0)
  {
    return at(index[0]);
  }
  std::vector<double> ring;
  for (int column = 0; column < DistinctColumns(this->SurfaceOrder); ++column)
  {
    if (!IsMissing(at(column)))
    {
      ring.push_back(at(column));
    }
  }
  return ring.empty() ? std::nan("") : RingValue(ring, true);
}

std::vector<std::string> GlobeGridBuilder::Warnings() const
{
  std::vector<std::string> warnings = this->Notes;
  if (this->MissingHeights > 0)
  {
    warnings.push_back(std::to_string(this->MissingHeights) + " values of the height array '" +
      this->Settings.Height +
      "' are missing (not a number, or a fill value). Those points take the height of their level and are "
      "hidden.");
  }
  if (this->MissingWinds > 0)
  {
    warnings.push_back("The wind is missing (not a number, or a fill value) at " +
      std::to_string(this->MissingWinds) + " points. There Wind is 0 and the points are hidden.");
  }
  if (this->DoubtfulTemperatures > 0)
  {
    warnings.push_back(std::to_string(this->DoubtfulTemperatures) +
      " values of the temperature array '" + this->Settings.Temperature +
      "' are missing or outside 100 to 400 K; the standard atmosphere takes their place. The array must "
      "be in kelvin.");
  }
  return warnings;
}

}
