// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Planet.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"

namespace nephoscope
{
namespace
{
double FieldValue(vtkDataSet* data, const char* name, double otherwise)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : otherwise;
}
}

Planet FindPlanet(vtkDataSet* data, const Vector3& up)
{
  const bool isGlobe = FieldValue(data, "GlobeGridProjection", 1) == 0;
  return { isGlobe ? FieldValue(data, "PlanetRadius", 0) : 0.0, up };
}

double RadiusOfMap(vtkDataSet* data)
{
  return FieldValue(data, "GlobeGridProjection", 0) == 1 ? FieldValue(data, "PlanetRadius", 0)
                                                         : 0.0;
}

Vector3 Planet::UpAt(const Vector3& place) const
{
  const double length = Norm(place);
  return this->Radius > 0 && length > 0
    ? Vector3{ { place[0] / length, place[1] / length, place[2] / length } }
    : this->Up;
}

std::array<Vector3, 3> Planet::Horizon() const
{
  const double c = this->Up[2], v[2] = { -this->Up[1], this->Up[0] }; // z x up
  if (c <= -1)
  {
    return { { { { 1, 0, 0 } }, { { 0, -1, 0 } }, this->Up } };
  }
  const double f = 1 / (1 + c);
  return { { { { c + f * v[0] * v[0], f * v[0] * v[1], -v[1] } },
    { { f * v[0] * v[1], c + f * v[1] * v[1], v[0] } }, this->Up } };
}

Vector3 Planet::FromHorizon(const Vector3& c) const
{
  const std::array<Vector3, 3> horizon = this->Horizon();
  return c[0] * horizon[0] + c[1] * horizon[1] + c[2] * horizon[2];
}
}
