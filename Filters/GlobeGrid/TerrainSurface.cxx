// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TerrainSurface.h"

#include "Vector3.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
struct Rows
{
  explicit Rows(vtkStructuredGrid* terrain)
    : Points(terrain->GetPoints())
  {
    int size[3];
    terrain->GetDimensions(size);
    this->Columns = size[0];
    this->Count = size[1];
  }

  vtkIdType Id(int i, int j) const { return i + static_cast<vtkIdType>(this->Columns) * j; }

  Vector3 Point(int i, int j) const
  {
    Vector3 x;
    this->Points->GetPoint(this->Id(i, j), x.data());
    return x;
  }

  // All points of the row are one.
  bool IsPole(int j) const
  {
    const Vector3 first = this->Point(0, j);
    const Vector3 middle = this->Point(this->Columns / 2, j);
    return this->Columns > 2 && Distance(first, middle) <= 1e-6 * Norm(first);
  }

  bool Closes(int j) const
  {
    const Vector3 first = this->Point(0, j);
    const Vector3 last = this->Point(this->Columns - 1, j);
    return this->Columns > 3 && Distance(first, last) <= 1e-6 * Norm(first);
  }

  vtkPoints* Points;
  int Columns;
  int Count;
};

vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

bool IsLand(vtkDataArray* land, double height, vtkIdType id)
{
  return land ? land->GetComponent(id, 0) >= 0.5 : height > 0.0;
}

Vector3 NormalAt(const Rows& rows, int i, int j, bool closes)
{
  const int last = rows.Columns - 1;
  const int before = i > 0 ? i - 1 : closes ? last - 1 : 0;
  const int after = i < last ? i + 1 : closes ? 1 : last;
  const Vector3 along = rows.Point(after, j) - rows.Point(before, j);
  const Vector3 across =
    rows.Point(i, std::min(j + 1, rows.Count - 1)) - rows.Point(i, std::max(j - 1, 0));
  return Normalized(Cross(along, across));
}

// Degrees.
void LongitudeLatitude(
  const Vector3& x, const TerrainPlace& place, double& longitude, double& latitude)
{
  longitude =
    vtkMath::DegreesFromRadians(place.OnGlobe ? std::atan2(x[1], x[0]) : x[0] / place.Radius);
  latitude = vtkMath::DegreesFromRadians(
    place.OnGlobe ? std::atan2(x[2], std::hypot(x[0], x[1])) : x[1] / place.Radius);
}
}

void FlattenSea(vtkStructuredGrid* terrain, vtkDataArray* land, const TerrainPlace& place)
{
  vtkDataArray* heights = terrain->GetPointData()->GetArray("Height");
  vtkPoints* points = terrain->GetPoints();
  for (vtkIdType id = 0; id < terrain->GetNumberOfPoints(); ++id)
  {
    if (IsLand(land, heights->GetComponent(id, 0), id))
    {
      continue;
    }
    Vector3 x;
    points->GetPoint(id, x.data());
    const double radius = Norm(x);
    x = place.OnGlobe ? Vector3{ x[0] * (place.Radius / radius), x[1] * (place.Radius / radius),
      x[2] * (place.Radius / radius) }
                      : Vector3{ x[0], x[1], 0.0 };
    points->SetPoint(id, x.data());
    heights->SetComponent(id, 0, 0.0);
  }
}

void AddTerrainScale(vtkStructuredGrid* terrain, vtkDataArray* land, double depth)
{
  vtkDataArray* heights = terrain->GetPointData()->GetArray("Height");
  const auto scale = MakeArray("Terrain", 1, terrain->GetNumberOfPoints());
  for (vtkIdType id = 0; id < terrain->GetNumberOfPoints(); ++id)
  {
    const double height = heights->GetComponent(id, 0);
    const double fraction = land ? std::max(0.0, land->GetComponent(id, 0)) : 0.0;
    scale->SetValue(id,
      static_cast<float>(
        IsLand(land, height, id) ? std::max(0.0, height) : -depth * (1.0 - 2.0 * fraction)));
  }
  terrain->GetPointData()->AddArray(scale);
  terrain->GetPointData()->SetActiveScalars(scale->GetName());
}

void AddTerrainNormals(vtkStructuredGrid* terrain, const TerrainPlace& place)
{
  const Rows rows(terrain);
  const auto normals = MakeArray("Normals", 3, terrain->GetNumberOfPoints());
  for (int j = 0; j < rows.Count; ++j)
  {
    const bool pole = place.OnGlobe && rows.IsPole(j);
    const int its = !pole ? j : j == 0 ? std::min(1, rows.Count - 1) : j - 1;
    const bool closes = place.OnGlobe && rows.Closes(its);
    Vector3 mean = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < rows.Columns; ++i)
    {
      const Vector3 normal = NormalAt(rows, i, its, closes);
      normals->SetTuple(rows.Id(i, j), normal.data());
      vtkMath::Add(mean.data(), normal.data(), mean.data());
    }
    vtkMath::Normalize(mean.data());
    for (int i = 0; pole && i < rows.Columns; ++i)
    {
      normals->SetTuple(rows.Id(i, j), mean.data());
    }
  }
  terrain->GetPointData()->AddArray(normals);
  terrain->GetPointData()->SetActiveNormals(normals->GetName());
}

void AddTerrainTextureCoordinates(vtkStructuredGrid* terrain, const TerrainPlace& place)
{
  const Rows rows(terrain);
  const auto coordinates = MakeArray("TextureCoordinates", 2, terrain->GetNumberOfPoints());
  for (int j = 0; j < rows.Count; ++j)
  {
    const bool pole = place.OnGlobe && rows.IsPole(j); // has every longitude
    const int its = !pole ? j : j == 0 ? std::min(1, rows.Count - 1) : j - 1;
    double before = 0.0;
    for (int i = 0; i < rows.Columns; ++i)
    {
      double longitude = 0.0;
      double latitude = 0.0;
      LongitudeLatitude(rows.Point(i, its), place, longitude, latitude);
      longitude += place.OnGlobe && i > 0 ? 360.0 * std::round((before - longitude) / 360.0) : 0.0;
      before = longitude;
      latitude = pole ? std::copysign(90.0, latitude) : latitude;
      coordinates->SetTuple2(rows.Id(i, j), longitude / 360.0 + 0.5, latitude / 180.0 + 0.5);
    }
  }
  terrain->GetPointData()->AddArray(coordinates);
  terrain->GetPointData()->SetActiveTCoords(coordinates->GetName());
}
}
