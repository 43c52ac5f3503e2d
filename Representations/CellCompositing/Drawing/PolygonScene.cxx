// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonScene.h"

#include "CoincidentPoints.h"
#include "ContourScene.h"
#include "ContourSettings.h"
#include "TetrahedronNeighbors.h"
#include "TetrahedronRay.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
/** Replaces `value`; true when it was different. */
template <typename Value>
bool Replaces(Value& value, Value now)
{
  const bool changed = value != now;
  value = std::move(now);
  return changed;
}

}

void PolygonScene::Read(vtkDataSet* data, const ContourSettings& settings)
{
  if (Replaces(this->ReadKey, { data, data->GetMTime(), settings.Polygons }))
  {
    this->Polygons = CellPolygons::Read(data, settings.Polygons);
    ++this->ReadVersion;
  }
  const auto& triangles = this->Polygons.Triangles;
  this->Used = std::any_of(triangles.begin(), triangles.end(),
    [&](const CellPolygons::Triangle& t) { return settings.FindPolygon(t.Contour).Opacity > 0; });
}

void PolygonScene::FindFaces(
  const CellGeometry& geometry, std::int64_t geometryVersion, bool smooth)
{
  if (!Replaces(this->FacesKey, { geometryVersion, this->ReadVersion, smooth }))
  {
    return;
  }
  std::vector<std::int32_t> places = FindPlaces(geometry);
  this->Faces = this->Polygons.Match(geometry, places);
  const std::int64_t apart = this->Polygons.NumberApart;
  if (apart > 0) // they may have points of their own that differ by rounding
  {
    std::vector<std::int32_t> welded = places;
    WeldPlaces(geometry, welded);
    std::vector<CellPolygons::Face> faces = this->Polygons.Match(geometry, welded);
    this->Polygons.NumberApart < apart ? this->Faces.swap(faces)
                                       : void(this->Polygons.NumberApart = apart);
  }
  this->Normals = this->Polygons.Normals(geometry, places, smooth);
}

std::array<float, 4> PolygonScene::ColorOf(const CellPolygons::Triangle& triangle,
  const ScalarSelection& scalars, const ContourSettings& settings,
  vtkVolumeProperty* property) const
{
  const ContourSettings::Surface& look = settings.FindPolygon(triangle.Contour);
  std::array<float, 3> rgb = { { -1, -1, -1 } };
  if (look.Color[0] >= 0)
  {
    std::copy(look.Color.begin(), look.Color.end(), rgb.begin());
  }
  else if (scalars.OnCells) // its own value, not that of a cell beside it
  {
    rgb = FunctionColor(property, ScalarValue(scalars, triangle.Cell));
  }
  return { { rgb[0], rgb[1], rgb[2], static_cast<float>(look.Opacity) } };
}

std::vector<double> PolygonScene::DescribeLook(std::int64_t geometryVersion,
  const ScalarSelection& scalars, const ContourSettings& settings,
  vtkVolumeProperty* property) const
{
  if (!this->Used)
  {
    return {};
  }
  const bool ofCells = scalars.OnCells && scalars.Array;
  std::vector<double> key = { double(geometryVersion), double(this->ReadVersion),
    double(settings.SmoothNormals), ofCells ? double(scalars.Array->GetMTime()) : 0.0,
    ofCells ? double(ColorMTime(property)) : 0.0 };
  const auto add = [&key](double contour, const ContourSettings::Surface& look) {
    key.insert(key.end(), { contour, look.Opacity, look.Color[0], look.Color[1], look.Color[2] });
  };
  add(-1, settings.Polygon);
  for (const auto& look : settings.PolygonsOfContour)
  {
    add(look.first, look.second);
  }
  return key;
}

void PolygonScene::Update(const CellGeometry& geometry, std::int64_t geometryVersion,
  const ScalarSelection& scalars, const ContourSettings& settings, vtkVolumeProperty* property)
{
  if (!Replaces(this->LookKey, this->DescribeLook(geometryVersion, scalars, settings, property)))
  {
    return;
  }
  std::vector<std::array<std::int32_t, 4>> ofTetrahedra;
  std::vector<Surface> surfaces;
  if (this->Used)
  {
    this->FindFaces(geometry, geometryVersion, settings.SmoothNormals);
    ofTetrahedra.assign(geometry.Tetrahedra.size(), { { 0, 0, 0, 0 } });
    for (const CellPolygons::Face& face : this->Faces)
    {
      const std::size_t number = static_cast<std::size_t>(face.Triangle);
      const CellPolygons::Triangle& triangle = this->Polygons.Triangles[number];
      Surface surface;
      surface.Color = this->ColorOf(triangle, scalars, settings, property);
      if (surface.Color[3] <= 0)
      {
        continue;
      }
      const Tetrahedron& t = geometry.Tetrahedra[static_cast<std::size_t>(face.Tetrahedron)];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Vector3 x = geometry.Position(t[std::size_t(tetrahedronFaces[face.Opposite][k])]);
        const auto distance = [&](std::size_t corner) {
          const Vector3 d = Difference(geometry.Position(triangle.Points[corner]), x);
          return Dot(d, d);
        };
        const std::size_t nearest = distance(0) <= distance(1)
          ? (distance(0) <= distance(2) ? 0 : 2)
          : (distance(1) <= distance(2) ? 1 : 2);
        const Vector3& n = this->Normals[number][nearest];
        surface.Normals[k] = { { float(n[0]), float(n[1]), float(n[2]), 0.0f } };
      }
      surfaces.push_back(surface);
      ofTetrahedra[static_cast<std::size_t>(face.Tetrahedron)][static_cast<std::size_t>(
        face.Opposite)] = static_cast<std::int32_t>(surfaces.size());
    }
  }
  this->Surfaces.swap(surfaces);
  this->OfTetrahedra.swap(ofTetrahedra);
  ++this->Version;
}

void PolygonScene::ListForRays(const CellGeometry& geometry, const TetrahedronNeighbors& neighbors,
  std::vector<std::array<std::int32_t, 4>>& ofTetrahedra, std::vector<Surface>& surfaces) const
{
  using Corners = std::array<std::int32_t, 3>;
  ofTetrahedra.assign(this->OfTetrahedra.size(), { { 0, 0, 0, 0 } });
  const auto rankIn = [&](std::size_t tetrahedron, std::int32_t vertex) {
    const Tetrahedron& t = geometry.Tetrahedra[tetrahedron];
    return static_cast<std::size_t>(std::count_if(
      t.begin(), t.end(), [&](std::int32_t v) { return neighbors.Merged(v) < vertex; }));
  };
  // To the corners of a surface, whose normals have the order of `from`.
  const auto add = [&](Surface surface, const Corners& from, Corners to, std::size_t tetrahedron,
                     std::int32_t opposite) {
    std::sort(to.begin(), to.end());
    const auto normals = surface.Normals;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto distance = [&](std::int32_t corner) {
        const Vector3 d = Difference(geometry.Position(corner), geometry.Position(to[k]));
        return Dot(d, d);
      };
      const auto nearest = std::min_element(from.begin(), from.end(),
        [&](std::int32_t a, std::int32_t b) { return distance(a) < distance(b); });
      surface.Normals[k] = normals[static_cast<std::size_t>(nearest - from.begin())];
    }
    surfaces.push_back(surface);
    ofTetrahedra[tetrahedron][rankIn(tetrahedron, opposite)] =
      static_cast<std::int32_t>(surfaces.size());
  };
  surfaces.clear();
  for (std::size_t i = 0; i < this->OfTetrahedra.size(); ++i)
  {
    for (std::size_t face = 0; face < 4; ++face)
    {
      const std::int32_t number = this->OfTetrahedra[i][face];
      if (number == 0)
      {
        continue;
      }
      const Surface& surface = this->Surfaces[static_cast<std::size_t>(number) - 1];
      const Tetrahedron& t = geometry.Tetrahedra[i];
      Corners corners, merged;
      for (std::size_t k = 0; k < 3; ++k)
      {
        corners[k] = t[static_cast<std::size_t>(tetrahedronFaces[face][k])];
        merged[k] = neighbors.Merged(corners[k]);
      }
      const std::int32_t opposite = neighbors.Merged(t[face]);
      add(surface, corners, merged, i, opposite);
      const std::int32_t across = neighbors.Neighbors[4 * i + rankIn(i, opposite)];
      if (across != TetrahedronNeighbors::None)
      {
        const bool jumps = across < 0;
        const std::array<std::int32_t, 4> there = jumps
          ? neighbors.FaceAcross(across, static_cast<std::int32_t>(i))
          : std::array<std::int32_t, 4>{ { merged[0], merged[1], merged[2], across } };
        const std::size_t neighbor = static_cast<std::size_t>(there[3]);
        add(surface, corners, { { there[0], there[1], there[2] } }, neighbor,
          neighbors.VertexSums[neighbor] ^ there[0] ^ there[1] ^ there[2]);
      }
    }
  }
}

} // namespace nephoscope
