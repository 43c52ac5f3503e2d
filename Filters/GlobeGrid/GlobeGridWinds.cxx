// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Pass 3 of GlobeGridBuilder: the winds as vectors.
#include "GlobeGridBuilder.h"

#include "GlobeGridRows.h"
#include "MissingValue.h"
#include "PoleRows.h"

#include "vtkFloatArray.h"

#include <cmath>

namespace nephoscope
{
namespace
{
// Kelvin. Outside, a temperature is in other units or missing, and the standard atmosphere takes
// its place.
constexpr double COLDEST = 100.0;
constexpr double HOTTEST = 400.0;
}

void GlobeGridBuilder::AddWinds(const int extent[6], vtkStructuredGrid* output)
{
  auto winds = NewPointArray<vtkFloatArray>(output, "Wind", 3);
  auto velocities = NewPointArray<vtkFloatArray>(output, "DisplayVelocity", 3);
  ForEachRow(extent, [&](const OutputRow& row) {
    Vector3 poleWind = { 0.0, 0.0, 0.0 };
    const int inputRow = this->Order_.InputPoint(0, row.j, row.k)[1];
    const int inputLevel = this->Order_.InputPoint(0, row.j, row.k)[2];
    const bool added = this->Order_.AddedPole(row.j) != 0;
    const bool atPole = added || this->Grid.IsPoleRow(inputRow, inputLevel);
    const bool poleFound = atPole && this->PoleWind(row.j, row.k, poleWind);
    bool poleMissing = false;
    const double poleHeight = added ? this->RingHeight(row.j, row.k, poleMissing) : 0.0;
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      const vtkIdType id = row.firstId + i - extent[0];
      const std::array<int, 3> input = this->Order_.InputPoint(i, row.j, row.k);
      const std::array<double, 3> x = this->CoordinatesOf({ i, row.j, row.k });
      const geodesy::Basis basis = BasisAt(x);
      Vector3 wind = poleWind;
      const bool found = atPole ? poleFound : this->WindOf(input, basis, wind);
      if (!found)
      {
        wind = { 0.0, 0.0, 0.0 };
        this->Hidden[id] |= WIND_MISSING;
      }
      bool missing = false;
      const double height =
        added ? poleHeight : this->HeightOf(this->Grid.Id(input), x[2], missing);
      if (added)
      {
        this->WritePoleWind(output, id, wind, basis);
      }
      Vector3 velocity;
      if (this->Settings.OnMap)
      {
        wind = { Dot(wind, basis.east), Dot(wind, basis.north), Dot(wind, basis.up) };
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
  const std::array<int, 3>& input, const geodesy::Basis& basis, Vector3& wind) const
{
  const vtkIdType id = this->Grid.Id(input);
  double u = this->U->GetComponent(id, 0);
  double v = this->V->GetComponent(id, 0);
  const double level = this->Grid.Coordinates(input)[2];
  bool missing = false;
  const double height = this->HeightOf(id, level, missing);
  double w = 0.0;
  if (IsMissing(u) || IsMissing(v) || !this->UpwardWind(id, level, height, w))
  {
    return false;
  }
  if (this->WindsAlongGrid)
  {
    this->TurnFromGrid(input, u, v);
  }
  wind = geodesy::Combine(basis, u, v, w);
  return true;
}

// From components along the rows (eastwards) and across them (northwards) to east and north: by the
// direction from the western to the eastern neighbour. At a pole there is no such direction, and
// nothing turns.
void GlobeGridBuilder::TurnFromGrid(const std::array<int, 3>& input, double& u, double& v) const
{
  std::array<int, 3> west = input;
  std::array<int, 3> east = input;
  const int last = this->Grid.Dimensions()[0] - 1;
  (this->Order_.Reversed[0] ? east : west)[0] = std::max(input[0] - 1, 0);
  (this->Order_.Reversed[0] ? west : east)[0] = std::min(input[0] + 1, last);
  const std::array<double, 3> a = this->Grid.Coordinates(west);
  const std::array<double, 3> b = this->Grid.Coordinates(east);
  const double latitude = this->Grid.Coordinates(input)[1] * geodesy::RADIANS_PER_DEGREE;
  const double eastwards = std::remainder(b[0] - a[0], 360.0) * std::cos(latitude);
  const double northwards = b[1] - a[1];
  const double length = std::hypot(eastwards, northwards);
  if (length > 0.0 && std::cos(latitude) > 1e-6)
  {
    const double along = u;
    u = (along * eastwards - v * northwards) / length;
    v = (along * northwards + v * eastwards) / length;
  }
}

// The carried horizontal wind arrays at a point of an added pole: the wind there, seen from its
// meridian.
void GlobeGridBuilder::WritePoleWind(
  vtkStructuredGrid* output, vtkIdType id, const Vector3& wind, const geodesy::Basis& basis) const
{
  const Vector3* const directions[2] = { &basis.east, &basis.north };
  const std::string* const names[2] = { &this->Settings.Eastward, &this->Settings.Northward };
  for (int c = 0; c < 2; ++c)
  {
    if (auto* carried = output->GetPointData()->GetArray(names[c]->c_str()))
    {
      carried->SetComponent(id, 0, Dot(wind, *directions[c]));
    }
  }
}

bool GlobeGridBuilder::UpwardWind(vtkIdType id, double level, double height, double& w) const
{
  w = this->W ? this->W->GetComponent(id, 0) : 0.0;
  if (IsMissing(w) || !this->W || !this->Settings.VerticalIsOmega)
  {
    return !IsMissing(w);
  }
  double temperature =
    this->Temperatures ? this->Temperatures->GetComponent(id, 0) : atmosphere::Temperature(height);
  if (!(temperature >= COLDEST && temperature <= HOTTEST))
  {
    ++this->DoubtfulTemperatures;
    temperature = atmosphere::Temperature(height);
  }
  w = atmosphere::UpwardWindFromOmega(w, this->PressureOf(level, height), temperature);
  return !IsMissing(w);
}

// All points of a row at a pole are one point: it has the Cartesian mean of their winds. To an
// added pole those of the last ring are first moved along their meridians.
bool GlobeGridBuilder::PoleWind(int j, int k, Vector3& wind) const
{
  const int columns = DistinctColumns(this->Order_);
  int found = 0;
  Vector3 sum = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < columns; ++i)
  {
    const std::array<int, 3> input = this->Order_.InputPoint(i, j, k);
    Vector3 one;
    if (this->WindOf(input, BasisAt(this->CoordinatesOf({ i, j, k })), one))
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
