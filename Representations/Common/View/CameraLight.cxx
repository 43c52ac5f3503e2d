// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraLight.h"

#include "CameraLightShader.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace nephoscope
{
namespace
{
vtkDataArray* ArrayOf(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  const bool fits =
    array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() >= tuples;
  return fits ? array : nullptr;
}
}

CameraLight::CameraLight(vtkDataSet* data, vtkDataArray* colors, bool onCells)
{
  vtkFieldData* arrays =
    onCells ? static_cast<vtkFieldData*>(data->GetCellData()) : data->GetPointData();
  if (!colors || !colors->GetName() || colors->GetName() != std::string("Sunlight") ||
    arrays->GetArray("Sunlight") != colors)
  {
    return;
  }
  const vtkIdType places = colors->GetNumberOfTuples();
  vtkDataArray* single = ArrayOf(arrays, "SingleScattering", 2, places);
  vtkDataArray* flux = ArrayOf(arrays, "DiffuseFlux", 3, places);
  vtkDataArray* phase = ArrayOf(data->GetFieldData(), "PhaseFunction", 2, 2);
  vtkDataArray* sun = ArrayOf(data->GetFieldData(), "SunDirection", 3, 1);
  if (!single || !flux || !phase || !sun)
  {
    return;
  }
  const double length =
    std::hypot(sun->GetComponent(0, 0), sun->GetComponent(0, 1), sun->GetComponent(0, 2));
  for (int c = 0; c < 3; ++c)
  {
    this->Sun[std::size_t(c)] = static_cast<float>(sun->GetComponent(0, c) / length);
  }
  this->OnCells = onCells;
  this->Single = single;
  this->Flux = flux;
  this->Phase = phase;
  this->Moment = ArrayOf(arrays, "DiffuseSecondMoment", 1, places);
  this->Times = { { single->GetMTime(), flux->GetMTime(), phase->GetMTime(),
    this->Moment ? this->Moment->GetMTime() : 0 } };
  vtkDataArray* up = ArrayOf(data->GetFieldData(), "Up", 3, 1);
  this->Ground = FindPlanet(data,
    up ? Vector3{ { up->GetComponent(0, 0), up->GetComponent(0, 1), up->GetComponent(0, 2) } }
       : Vector3{ { 0, 0, 1 } });
  if (this->Moment && this->Ground.Radius > 0)
  {
    this->Places.TakeReference(data->NewInstance());
    this->Places->CopyStructure(data);
  }
}

double CameraLight::Headroom() const
{
  double moments[2] = { 0, 0 };
  if (this->Moment)
  {
    this->Moment->GetRange(moments);
  }
  const double headroom = this->Flux->GetMaxNorm() + std::max(moments[1], -0.5 * moments[0]) +
    std::max(this->Phase->GetRange(0)[1] - 1, 0.0) * this->Single->GetRange(0)[1] +
    std::max(this->Phase->GetRange(1)[1] - 1, 0.0) * this->Single->GetRange(1)[1];
  return headroom < Brightest ? headroom : Brightest;
}

Vector3 CameraLight::UpAt(vtkIdType point) const
{
  if (!this->Places)
  {
    return this->Ground.Up;
  }
  Vector3 place;
  if (this->OnCells)
  {
    double bounds[6];
    this->Places->GetCellBounds(point, bounds);
    vtkBoundingBox(bounds).GetCenter(place.data());
  }
  else
  {
    this->Places->GetPoint(point, place.data());
  }
  return this->Ground.UpAt(place);
}

std::array<float, 4> CameraLight::SecondPart(vtkIdType point, double scale) const
{
  constexpr double smallest = 1e-30; // 0 has no sign
  const double single = std::max(scale * this->Single->GetComponent(point, 1), smallest),
               moment = this->Moment ? scale * this->Moment->GetComponent(point, 0) : 0;
  const Vector3 up = this->UpAt(point);
  const double root = std::sqrt(std::abs(moment));
  return { { static_cast<float>(moment < 0 ? -single : single), static_cast<float>(root * up[0]),
    static_cast<float>(root * up[1]), static_cast<float>(root * up[2]) } };
}

std::vector<std::array<float, 4>> CameraLight::Parts(double width) const
{
  std::vector<std::array<float, 4>> parts(
    2 * static_cast<std::size_t>(this->Flux->GetNumberOfTuples()));
  const double scale = 1 / width;
  for (std::size_t p = 0; p < parts.size() / 2; ++p)
  {
    const vtkIdType i = static_cast<vtkIdType>(p);
    for (int c = 0; c < 3; ++c)
    {
      parts[2 * p][std::size_t(c)] = static_cast<float>(scale * this->Flux->GetComponent(i, c));
    }
    parts[2 * p][3] = static_cast<float>(scale * this->Single->GetComponent(i, 0));
    parts[2 * p + 1] = this->SecondPart(i, scale);
  }
  return parts;
}

std::vector<std::array<float, 2>> CameraLight::Factors() const
{
  std::vector<std::array<float, 2>> factors(
    static_cast<std::size_t>(this->Phase->GetNumberOfTuples()));
  for (std::size_t i = 0; i < factors.size(); ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      factors[i][std::size_t(c)] =
        static_cast<float>(this->Phase->GetComponent(static_cast<vtkIdType>(i), c) - 1);
    }
  }
  return factors;
}

const char* CameraLight::ShaderText()
{
  return CameraLightShader;
}

bool CameraLight::operator==(const CameraLight& other) const
{
  return this->Single == other.Single && this->Flux == other.Flux && this->Phase == other.Phase &&
    this->Times == other.Times && this->Sun == other.Sun;
}

} // namespace nephoscope
