// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is seen of the cells at a pixel.
#include "vtkCellCompositingMapper.h"

#include "AreaPick.h"
#include "CellCompositingInternals.h"

#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
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

/** Between pixels of a renderer's window and the world; unlike the renderer, for several threads.
 */
class PickedView
{
public:
  explicit PickedView(vtkRenderer* renderer)
  {
    this->ToView->DeepCopy(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      renderer->GetTiledAspectRatio(), 0, 1));
    vtkMatrix4x4::Invert(this->ToView, this->ToWorld);
    double places[2][3];
    for (int i = 0; i < 2; ++i)
    {
      renderer->SetDisplayPoint(i, i, 0);
      renderer->DisplayToView();
      renderer->GetViewPoint(places[i]);
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      this->Origin[axis] = places[0][axis];
      this->Step[axis] = places[1][axis] - places[0][axis];
    }
  }

  Vector3 World(double x, double y, double depth) const
  {
    const double in[4] = { this->Origin[0] + x * this->Step[0], this->Origin[1] + y * this->Step[1],
      depth, 1 };
    double p[4];
    this->ToWorld->MultiplyPoint(in, p);
    return { { p[0] / p[3], p[1] / p[3], p[2] / p[3] } };
  }

  double Depth(const Vector3& world) const
  {
    const double in[4] = { world[0], world[1], world[2], 1 };
    double p[4];
    this->ToView->MultiplyPoint(in, p);
    return p[2] / p[3];
  }

  /** Rows that give pixels, depth and the denominator of a place relative to the centre. */
  nephoscope::PickArea Project(vtkMatrix4x4* modelToWorld, const double center[3]) const
  {
    vtkNew<vtkMatrix4x4> all;
    vtkMatrix4x4::Multiply4x4(this->ToView, modelToWorld, all);
    const auto row = [&](int i) {
      nephoscope::Vector4 r = { { all->GetElement(i, 0), all->GetElement(i, 1),
        all->GetElement(i, 2), all->GetElement(i, 3) } };
      r[3] += r[0] * center[0] + r[1] * center[1] + r[2] * center[2];
      return r;
    };
    nephoscope::PickArea area;
    area.ToW = row(3);
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      area.ToPixels[axis] = row(static_cast<int>(axis));
      for (std::size_t k = 0; k < 4; ++k)
      {
        area.ToPixels[axis][k] =
          (area.ToPixels[axis][k] - this->Origin[axis] * area.ToW[k]) / this->Step[axis];
      }
    }
    const bool isParallel = area.ToW[0] == 0 && area.ToW[1] == 0 && area.ToW[2] == 0;
    area.ToDepth = isParallel ? row(2) : area.ToW;
    return area;
  }

private:
  vtkNew<vtkMatrix4x4> ToView, ToWorld;
  std::array<double, 2> Origin, Step;
};

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

/** The trilinear field of a cell of an evenly spaced grid, in numbers of the geometry. */
template <typename Value>
double FieldOfLatticeCell(
  const CellGeometry& geometry, std::int64_t number, const Vector3& place, Value valueAt)
{
  const std::array<int, 3> cell = geometry.Grid.CellIndex(number);
  double at[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double* row = &geometry.Lattice.ToNumbers[4 * axis];
    at[axis] = row[0] * place[0] + row[1] * place[1] + row[2] * place[2] + row[3] - cell[axis];
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int i[3] = { corner & 1, corner >> 1 & 1, corner >> 2 & 1 };
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= i[axis] ? at[axis] : 1 - at[axis];
    }
    sum += weight *
      valueAt(static_cast<std::size_t>(
        geometry.Grid.PointNumber(cell[0] + i[0], cell[1] + i[1], cell[2] + i[2])));
  }
  return sum;
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

/** From the near plane to a depth at a place in the picture, in the world. */
struct PickedLine
{
  Vector3 From, To;
};

/** What the rays of a picture have in common. */
class PickedRays
{
public:
  PickedRays(vtkRenderer* renderer, vtkVolume* volume, vtkPlaneCollection* planes,
    const CellGeometry& geometry)
    : View(renderer)
    , Planes(planes)
    , Geometry(geometry)
  {
    vtkMatrix4x4::Invert(volume->GetMatrix(), this->WorldToModel);
  }

  PickedLine Line(double x, double y, double depth) const
  {
    return { this->View.World(x, y, 0), this->View.World(x, y, depth) };
  }

  PickRay Ray(const PickedLine& line) const
  {
    const Vector3 start = ToPickedModel(this->WorldToModel, line.From, this->Geometry.Center),
                  end = ToPickedModel(this->WorldToModel, line.To, this->Geometry.Center);
    PickRay ray{ start, nephoscope::Difference(end, start) };
    ClipPickRay(this->Planes, line.From, line.To, ray);
    const Vector3 way = nephoscope::Difference(line.To, line.From);
    ray.Length = std::sqrt(nephoscope::Dot(way, way));
    return ray;
  }

  const PickedView View;

private:
  vtkNew<vtkMatrix4x4> WorldToModel;
  vtkPlaneCollection* Planes;
  const CellGeometry& Geometry;
};

/** With the fields of whole cells, if `data` are given; for one thread. */
nephoscope::PickMedium MakeMedium(
  const nephoscope::CellScene& scene, vtkDataSet* data, double extinctionScale)
{
  const CellGeometry& geometry = scene.GetGeometry();
  nephoscope::PickMedium medium{ scene.GetOpacityFunctions(), scene.GetTablesOfTetrahedra(),
    extinctionScale };
  AddSurfaces(scene.GetContours(), medium);
  if (data)
  {
    const auto cell = vtkSmartPointer<vtkGenericCell>::New();
    const auto field = [data, cell, &geometry](
                         std::int64_t number, const Vector3& place, const auto& valueAt) {
      return geometry.Lattice.Found
        ? FieldOfLatticeCell(geometry, number, place, valueAt)
        : FieldOfPickedCell(data, geometry, cell, number, place, valueAt);
    };
    medium.Scalar = [field, &geometry](std::int64_t number, const Vector3& place) {
      return field(number, place, [&](std::size_t point) { return geometry.Points[point].Scalar; });
    };
    medium.OpacityScalar = [field, &geometry](std::int64_t number, const Vector3& place) {
      return field(
        number, place, [&](std::size_t point) { return geometry.OpacityScalars[point]; });
    };
  }
  return medium;
}
}

void vtkCellCompositingMapper::SetPickOpacity(double opacity)
{
  this->PickOpacity =
    std::min(std::max(opacity, 0.001), 0.999); // no picture changes: not Modified()
}

// Whose fields are those of whole cells; null: they are linear in tetrahedra.
vtkDataSet* vtkCellCompositingMapper::GetPickedField()
{
  const CellGeometry& geometry = this->Internals->Scene.GetGeometry();
  const bool isTrilinear = this->IsTrilinear() && this->MayCrossWholeCells() &&
    (!geometry.Hexahedra.empty() || !geometry.Grid.IsEmpty());
  return isTrilinear ? this->GetDataSetInput() : nullptr;
}

double vtkCellCompositingMapper::GetPickedExtinctionScale(vtkVolume* volume) const
{
  return this->OpacityScale / volume->GetProperty()->GetScalarOpacityUnitDistance();
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
  const PickedRays rays(renderer, volume, this->GetClippingPlanes(), geometry);
  const PickedLine line =
    rays.Line(pixel[0] + 0.5, pixel[1] + 0.5, renderer->GetZ(pixel[0], pixel[1]));
  const nephoscope::PickedCell picked = nephoscope::PickCell(geometry,
    MakeMedium(scene, this->GetPickedField(), this->GetPickedExtinctionScale(volume)),
    rays.Ray(line), -std::log1p(-this->PickOpacity));
  if (picked.Tetrahedron < 0)
  {
    return false;
  }
  this->PickedCell = nephoscope::CellOfTetrahedron(geometry, picked.Tetrahedron);
  this->PickedPoint = picked.Point;
  this->PickedScalar =
    geometry.ScalarRange[0] + picked.Scalar * (geometry.ScalarRange[1] - geometry.ScalarRange[0]);
  const Vector3 place = PlaceOn(line.From, line.To, picked.Parameter);
  std::copy(place.begin(), place.end(), this->PickPosition);
  return true;
}

// The same at each pixel, as if nothing opaque were there: the depth test finds what is in front.
void vtkCellCompositingMapper::PickArea(
  vtkRenderer* renderer, vtkVolume* volume, const unsigned int corners[4])
{
  nephoscope::SelectedPixels& selected = this->Internals->Selected;
  selected = nephoscope::SelectedPixels();
  const int *origin = renderer->GetOrigin(), *size = renderer->GetSize();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const int first = std::max(static_cast<int>(corners[axis]), origin[axis]);
    const int last = std::min(static_cast<int>(corners[axis + 2]), origin[axis] + size[axis] - 1);
    selected.First[axis] = first;
    selected.Size[axis] = std::max(last - first + 1, 0);
  }
  vtkDataSet* data = this->GetDataSetInput();
  if (selected.IsEmpty() || !data || !this->Internals->Scene.RefreshGeometry(data))
  {
    selected.Size = { { 0, 0 } };
    return;
  }
  const nephoscope::CellScene& scene = this->Internals->Scene;
  const CellGeometry& geometry = scene.GetGeometry();
  const PickedRays rays(renderer, volume, this->GetClippingPlanes(), geometry);
  nephoscope::PickArea area = rays.View.Project(volume->GetMatrix(), geometry.Center);
  selected.ChooseWidth();
  area.Size = selected.Squares();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      area.ToPixels[axis][k] =
        (area.ToPixels[axis][k] - selected.First[axis] * area.ToW[k]) / selected.Width;
    }
  }
  const auto lineOf = [&](int column, int row) {
    return rays.Line(selected.Center(0, column), selected.Center(1, row), 1);
  };
  area.Ray = [&](int column, int row) { return rays.Ray(lineOf(column, row)); };
  vtkDataSet* field = this->GetPickedField();
  if (field)
  {
    vtkNew<vtkGenericCell> first;
    field->GetCell(0, first); // makes what threads share
  }
  const double scale = this->GetPickedExtinctionScale(volume);
  const std::vector<nephoscope::PickedCell> picked = nephoscope::PickCells(
    geometry, [&]() { return MakeMedium(scene, field, scale); }, area,
    -std::log1p(-this->PickOpacity));
  selected.Pixels.resize(picked.size());
  for (std::size_t i = 0; i < picked.size(); ++i)
  {
    if (picked[i].Tetrahedron >= 0)
    {
      const auto column = static_cast<int>(i % static_cast<std::size_t>(area.Size[0])),
                 row = static_cast<int>(i / static_cast<std::size_t>(area.Size[0]));
      const PickedLine line = lineOf(column, row);
      selected.Pixels[i] = { nephoscope::CellOfTetrahedron(geometry, picked[i].Tetrahedron),
        picked[i].Point, rays.View.Depth(PlaceOn(line.From, line.To, picked[i].Parameter)) };
    }
  }
}
