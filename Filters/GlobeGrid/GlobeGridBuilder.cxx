// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeGridBuilder.h"

#include "CarryArrays.h"
#include "GlobeGridRows.h"
#include "HidePoints.h"
#include "MissingValue.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

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
  CarryCellArrays(this->Grid, this->Order_, extent, output->GetCellData());
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
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      const vtkIdType id = row.firstId + i - extent[0];
      const std::array<int, 3> input = this->Order_.InputPoint(i, row.j, row.k);
      const std::array<double, 3> x = this->Grid.Coordinates(input);
      bool missing = false;
      const double height = this->HeightOf(this->Grid.Id(input), x[2], missing);
      this->Hidden[id] = missing ? HEIGHT_MISSING : 0;
      heights[id] = static_cast<float>(height);
      const double longitude =
        this->Grid.UnwrappedLongitude(input) + this->Order_.LongitudeOffset(i);
      const geodesy::Vector position = this->Settings.OnMap
        ? geodesy::MapPosition(this->Settings.Planet, longitude * geodesy::RADIANS_PER_DEGREE,
            x[1] * geodesy::RADIANS_PER_DEGREE, height)
        : geodesy::GlobePosition(this->Settings.Planet, BasisAt(x), height);
      std::copy(position.begin(), position.end(), positions + 3 * id);
    }
  });
  this->MissingHeights = CountWith(this->Hidden, HEIGHT_MISSING);
  output->SetPoints(points);
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
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const vtkIdType id = row.firstId + i - extent[0];
        const bool hidden = this->IsBelowGround({ i, row.j, row.k });
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
  const double height = this->HeightOf(this->Grid.Id(input), level, missing);
  if (!this->SurfaceGrid)
  {
    const bool heightsAreOfTheAir = this->Heights || IsPressure(this->Units);
    return heightsAreOfTheAir && !missing && height < 0.0;
  }
  const bool flat = this->SurfaceGrid->Dimensions()[2] == 1;
  const vtkIdType id = this->SurfaceGrid->Id(
    this->SurfaceOrder.InputPoint(index[0], index[1], flat ? 0 : index[2]));
  if (this->SurfacePressures)
  {
    const double surface = this->SurfacePressures->GetComponent(id, 0);
    return !IsMissing(surface) &&
      LevelPressure(this->Units, level) > surface * this->SurfacePressureScale;
  }
  const double terrain = this->TerrainHeights->GetComponent(id, 0);
  return !IsMissing(terrain) && height < terrain;
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
    warnings.push_back(std::to_string(this->DoubtfulTemperatures) + " values of the temperature array '" +
      this->Settings.Temperature +
      "' are missing or outside 100 to 400 K; the standard atmosphere takes their place. The array must "
      "be in kelvin.");
  }
  return warnings;
}

}
