// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is seen of the cells at a pixel.
#include "vtkCellCompositingMapper.h"

#include "CellCompositingInternals.h"
#include "CellPick.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
using nephoscope::CellGeometry;
using nephoscope::PickRay;
using nephoscope::Vector3;

vtkVolume* VolumeOf(vtkRenderer* renderer, vtkAbstractVolumeMapper* mapper)
{
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
    if (volume && volume->GetMapper() == mapper)
    {
      return volume;
    }
  }
  return nullptr;
}

Vector3 PickedWorld(vtkRenderer* renderer, double x, double y, double depth)
{
  double p[4];
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(p);
  return { { p[0] / p[3], p[1] / p[3], p[2] / p[3] } };
}

Vector3 PlaceOn(const Vector3& from, const Vector3& to, double parameter)
{
  Vector3 p;
  for (std::size_t k = 0; k < 3; ++k)
  {
    p[k] = from[k] + parameter * (to[k] - from[k]);
  }
  return p;
}

/** Cuts off what lies behind the clipping planes. */
void ClipPickRay(vtkPlaneCollection* planes, const Vector3& from, const Vector3& to, PickRay& ray)
{
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const double a = plane->EvaluateFunction(from[0], from[1], from[2]),
                 b = plane->EvaluateFunction(to[0], to[1], to[2]);
    if (a < 0 && b < 0)
    {
      ray.End = ray.Begin;
    }
    else if (a < 0)
    {
      ray.Begin = std::max(ray.Begin, a / (a - b));
    }
    else if (b < 0)
    {
      ray.End = std::min(ray.End, a / (a - b));
    }
  }
}

Vector3 ToPickedModel(vtkMatrix4x4* worldToModel, const Vector3& world, const double center[3])
{
  const double in[4] = { world[0], world[1], world[2], 1.0 };
  double out[4];
  worldToModel->MultiplyPoint(in, out);
  return { { out[0] / out[3] - center[0], out[1] / out[3] - center[1],
    out[2] / out[3] - center[2] } };
}

/** The field of VTK's cell, in numbers of the geometry; `valueAt`: of a point. */
template <typename Value>
double FieldOfPickedCell(vtkDataSet* data, const CellGeometry& geometry, vtkGenericCell* cell,
  std::int64_t number, Vector3 place, Value valueAt)
{
  data->GetCell(number, cell);
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  double pcoords[3], distance, closest[3];
  int part;
  for (std::size_t k = 0; k < 3; ++k)
  {
    place[k] += geometry.Center[k];
  }
  cell->EvaluatePosition(place.data(), closest, part, pcoords, distance, weights.data());
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    sum += weights[k] * valueAt(static_cast<std::size_t>(cell->GetPointId(static_cast<int>(k))));
  }
  return sum;
}

// Those that are drawn.
void AddSurfaces(const nephoscope::ContourScene& contours, nephoscope::PickMedium& medium)
{
  for (const nephoscope::ContourScene::Contour& contour : contours.Contours)
  {
    const double opacity = std::min(double(contour.Color[3]), 1.0);
    if (opacity > 0)
    {
      medium.Surfaces.push_back({ double(contour.Value), opacity });
    }
  }
  medium.Contoured = contours.OfColor ? nullptr : &contours.Scalars;
}
}

void vtkCellCompositingMapper::SetPickOpacity(double opacity)
{
  this->PickOpacity =
    std::min(std::max(opacity, 0.001), 0.999); // no picture changes: not Modified()
}

bool vtkCellCompositingMapper::Pick(vtkRenderer* renderer, double x, double y)
{
  this->PickedCell = this->PickedPoint = -1;
  vtkVolume* volume = renderer ? VolumeOf(renderer, this) : nullptr;
  vtkDataSet* data = this->GetDataSetInput();
  const nephoscope::CellScene& scene = this->Internals->Scene;
  const CellGeometry& geometry = scene.GetGeometry();
  if (!volume || !data || !renderer->GetRenderWindow() || !this->Internals->View ||
    !this->Internals->Scene.RefreshGeometry(data))
  {
    vtkErrorMacro("Nothing can be picked: add the volume to this renderer, and render first.");
    return false;
  }
  const int pixel[2] = { int(std::floor(x)), int(std::floor(y)) };
  if (!renderer->IsInViewport(pixel[0], pixel[1]))
  {
    return false;
  }
  const double centerX = pixel[0] + 0.5, centerY = pixel[1] + 0.5;
  const Vector3 from = PickedWorld(renderer, centerX, centerY, 0),
                to = PickedWorld(renderer, centerX, centerY, renderer->GetZ(pixel[0], pixel[1]));
  vtkNew<vtkMatrix4x4> worldToModel;
  vtkMatrix4x4::Invert(volume->GetMatrix(), worldToModel);
  const Vector3 start = ToPickedModel(worldToModel, from, geometry.Center),
                end = ToPickedModel(worldToModel, to, geometry.Center);
  PickRay ray{ start, { { end[0] - start[0], end[1] - start[1], end[2] - start[2] } } };
  ClipPickRay(this->GetClippingPlanes(), from, to, ray);
  const double length = std::hypot(std::hypot(to[0] - from[0], to[1] - from[1]), to[2] - from[2]);
  nephoscope::PickMedium medium{ scene.GetOpacityFunctions(), scene.GetTablesOfTetrahedra(),
    length * this->OpacityScale / volume->GetProperty()->GetScalarOpacityUnitDistance() };
  AddSurfaces(scene.GetContours(), medium);
  vtkNew<vtkGenericCell> cell;
  if (this->IsTrilinear() && this->MayCrossWholeCells() &&
    (!geometry.Hexahedra.empty() || !geometry.Grid.IsEmpty()))
  {
    medium.Scalar = [&](std::int64_t number, double parameter) {
      return FieldOfPickedCell(data, geometry, cell, number, PlaceOn(start, end, parameter),
        [&](std::size_t point) { return geometry.Points[point].Scalar; });
    };
    medium.OpacityScalar = [&](std::int64_t number, double parameter) {
      return FieldOfPickedCell(data, geometry, cell, number, PlaceOn(start, end, parameter),
        [&](std::size_t point) { return geometry.OpacityScalars[point]; });
    };
  }
  const nephoscope::PickedCell picked =
    nephoscope::PickCell(geometry, medium, ray, -std::log1p(-this->PickOpacity));
  if (picked.Tetrahedron < 0)
  {
    return false;
  }
  this->PickedCell = nephoscope::CellOfTetrahedron(geometry, picked.Tetrahedron);
  this->PickedPoint = picked.Point;
  this->PickedScalar =
    geometry.ScalarRange[0] + picked.Scalar * (geometry.ScalarRange[1] - geometry.ScalarRange[0]);
  const Vector3 place = PlaceOn(from, to, picked.Parameter);
  std::copy(place.begin(), place.end(), this->PickPosition);
  return true;
}
