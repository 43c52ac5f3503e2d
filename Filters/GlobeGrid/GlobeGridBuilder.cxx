// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeGridBuilder.h"

#include "CarryArrays.h"
#include "MissingValue.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// Kelvin. Outside, a temperature is in other units or missing, and the standard atmosphere takes its place.
constexpr double COLDEST = 100.0;
constexpr double HOTTEST = 400.0;

enum HiddenReason : unsigned char
{
  BELOW_GROUND = 1,
  HEIGHT_MISSING = 2,
  WIND_MISSING = 4
};

template <typename Array>
vtkSmartPointer<Array> NewPointArray(vtkStructuredGrid* output, const char* name, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  output->GetPointData()->AddArray(array);
  return array;
}

// The array of that name, carried from the input or new.
vtkUnsignedCharArray* GhostArray(vtkDataSetAttributes* data, vtkIdType count)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  if (auto* carried = vtkUnsignedCharArray::SafeDownCast(data->GetArray(name)))
  {
    return carried;
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(name);
  ghosts->SetNumberOfTuples(count);
  ghosts->FillValue(0);
  data->AddArray(ghosts);
  return ghosts; // held by data
}

// The up to eight cells that touch a point; `size` counts points, and a flat axis has one layer of cells.
void HideCellsAround(int i, int j, int k, const int size[3], vtkUnsignedCharArray* ghosts)
{
  const int at[3] = { i, j, k };
  int first[3], last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = std::max(size[axis] - 1, 1);
    first[axis] = std::max(at[axis] - 1, 0);
    last[axis] = std::min(at[axis], cells - 1);
  }
  const vtkIdType columns = std::max(size[0] - 1, 1);
  const vtkIdType rows = std::max(size[1] - 1, 1);
  for (int c = first[2]; c <= last[2]; ++c)
  {
    for (int b = first[1]; b <= last[1]; ++b)
    {
      for (int a = first[0]; a <= last[0]; ++a)
      {
        const vtkIdType cell = a + columns * (b + rows * c);
        ghosts->SetValue(cell, ghosts->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
      }
    }
  }
}

vtkIdType CountWith(const std::vector<unsigned char>& flags, unsigned char reason)
{
  return std::count_if(
    flags.begin(), flags.end(), [reason](unsigned char flag) { return (flag & reason) != 0; });
}

geodesy::Basis BasisAt(const std::array<double, 3>& coordinates)
{
  return geodesy::LocalBasis(
    geodesy::TurnFromDegrees(coordinates[0]), geodesy::TurnFromDegrees(coordinates[1]));
}
}

struct GlobeGridBuilder::Row
{
  int j;
  int k;
  vtkIdType firstId; // of the output
};

template <typename Function>
void GlobeGridBuilder::ForEachRow(const int extent[6], const Function& function) const
{
  const vtkIdType columns = extent[1] - extent[0] + 1;
  const vtkIdType rows = extent[3] - extent[2] + 1;
  const vtkIdType levels = extent[5] - extent[4] + 1;
  auto work = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end; ++r)
    {
      function(Row{ extent[2] + static_cast<int>(r % rows), extent[4] + static_cast<int>(r / rows),
        r * columns });
    }
  };
  vtkSMPTools::LocalScope(vtkSMPTools::Config(0, "STDThread", false),
    [&]() { vtkSMPTools::For(0, rows * levels, work); });
}

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
  this->ForEachRow(extent, [&](const Row& row) {
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
    this->ForEachRow(extent, [&](const Row& row) {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const vtkIdType id = row.firstId + i - extent[0];
        const bool hidden = this->IsBelowGround({ i, row.j, row.k });
        below->SetValue(id, hidden ? 1 : 0);
        this->Hidden[id] |= hidden ? BELOW_GROUND : 0;
      }
    });
  }
  this->HidePoints(output);
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

// Points, and the cells that touch them: some filters look at the one, some at the other.
void GlobeGridBuilder::HidePoints(vtkStructuredGrid* output) const
{
  if (std::all_of(this->Hidden.begin(), this->Hidden.end(), [](unsigned char h) { return h == 0; }))
  {
    return;
  }
  vtkUnsignedCharArray* pointGhosts = GhostArray(output->GetPointData(), output->GetNumberOfPoints());
  vtkUnsignedCharArray* cellGhosts = GhostArray(output->GetCellData(), output->GetNumberOfCells());
  int size[3];
  output->GetDimensions(size);
  vtkIdType id = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++id)
      {
        if (this->Hidden[id])
        {
          pointGhosts->SetValue(id, pointGhosts->GetValue(id) | vtkDataSetAttributes::HIDDENPOINT);
          HideCellsAround(i, j, k, size, cellGhosts);
        }
      }
    }
  }
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

// PASS 3
void GlobeGridBuilder::AddWinds(const int extent[6], vtkStructuredGrid* output)
{
  auto winds = NewPointArray<vtkFloatArray>(output, "Wind", 3);
  auto velocities = NewPointArray<vtkFloatArray>(output, "DisplayVelocity", 3);
  this->ForEachRow(extent, [&](const Row& row) {
    geodesy::Vector poleWind = { 0.0, 0.0, 0.0 };
    const int inputRow = this->Order_.InputPoint(0, row.j, row.k)[1];
    const int inputLevel = this->Order_.InputPoint(0, row.j, row.k)[2];
    const bool atPole = this->Grid.IsPoleRow(inputRow, inputLevel);
    const bool poleFound = atPole && this->PoleWind(row.j, row.k, poleWind);
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      const vtkIdType id = row.firstId + i - extent[0];
      const std::array<int, 3> input = this->Order_.InputPoint(i, row.j, row.k);
      const std::array<double, 3> x = this->Grid.Coordinates(input);
      const geodesy::Basis basis = BasisAt(x);
      geodesy::Vector wind = poleWind;
      const bool found = atPole ? poleFound : this->WindOf(input, basis, wind);
      if (!found)
      {
        wind = { 0.0, 0.0, 0.0 };
        this->Hidden[id] |= WIND_MISSING;
      }
      bool missing = false;
      const double height = this->HeightOf(this->Grid.Id(input), x[2], missing);
      geodesy::Vector velocity;
      if (this->Settings.OnMap)
      {
        wind = { geodesy::Dot(wind, basis.east), geodesy::Dot(wind, basis.north),
          geodesy::Dot(wind, basis.up) };
        velocity = geodesy::MapDisplayVelocity(this->Settings.Planet,
          std::cos(x[1] * geodesy::RADIANS_PER_DEGREE), height, wind[0], wind[1], wind[2]);
      }
      else
      {
        velocity = geodesy::GlobeDisplayVelocity(this->Settings.Planet, basis, height, wind);
      }
      for (int c = 0; c < 3; ++c)
      {
        winds->SetTypedComponent(id, c, static_cast<float>(wind[c]));
        velocities->SetTypedComponent(id, c, static_cast<float>(velocity[c]));
      }
    }
  });
  this->MissingWinds = CountWith(this->Hidden, WIND_MISSING);
  output->GetPointData()->SetActiveVectors("DisplayVelocity");
}

// Cartesian on the globe; false if it is missing.
bool GlobeGridBuilder::WindOf(
  const std::array<int, 3>& input, const geodesy::Basis& basis, geodesy::Vector& wind) const
{
  const vtkIdType id = this->Grid.Id(input);
  const double u = this->U->GetComponent(id, 0);
  const double v = this->V->GetComponent(id, 0);
  const double level = this->Grid.Coordinates(input)[2];
  bool missing = false;
  const double height = this->HeightOf(id, level, missing);
  double w = 0.0;
  if (IsMissing(u) || IsMissing(v) || !this->UpwardWind(id, level, height, w))
  {
    return false;
  }
  wind = geodesy::Combine(basis, u, v, w);
  return true;
}

bool GlobeGridBuilder::UpwardWind(vtkIdType id, double level, double height, double& w) const
{
  w = this->W ? this->W->GetComponent(id, 0) : 0.0;
  if (IsMissing(w) || !this->W || !this->Settings.VerticalIsOmega)
  {
    return !IsMissing(w);
  }
  double temperature = this->Temperatures ? this->Temperatures->GetComponent(id, 0)
                                          : atmosphere::Temperature(height);
  if (!(temperature >= COLDEST && temperature <= HOTTEST))
  {
    ++this->DoubtfulTemperatures;
    temperature = atmosphere::Temperature(height);
  }
  w = atmosphere::UpwardWindFromOmega(w, this->PressureOf(level, height), temperature);
  return !IsMissing(w);
}

// All points of a row at a pole are one point: it has the Cartesian mean of their winds.
bool GlobeGridBuilder::PoleWind(int j, int k, geodesy::Vector& wind) const
{
  const int columns =
    this->Order_.Period > 0 ? this->Order_.Period : this->Order_.OutputDimensions[0];
  int found = 0;
  geodesy::Vector sum = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < columns; ++i)
  {
    const std::array<int, 3> input = this->Order_.InputPoint(i, j, k);
    geodesy::Vector one;
    if (this->WindOf(input, BasisAt(this->Grid.Coordinates(input)), one))
    {
      ++found;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += one[c];
      }
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    wind[c] = found ? sum[c] / found : 0.0;
  }
  return found > 0;
}
}
