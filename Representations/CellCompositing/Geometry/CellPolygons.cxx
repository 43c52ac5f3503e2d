// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellPolygons.h"

#include "TetrahedronSource.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace nephoscope
{
namespace
{
// The usual ones, which need not be looked at.
bool IsSolid(int type)
{
  return type >= VTK_TETRA && type <= VTK_HEXAGONAL_PRISM;
}

using TriangleCorners = std::array<std::int32_t, 3>;

TriangleCorners Sorted(TriangleCorners corners, const std::vector<std::int32_t>& places)
{
  for (std::int32_t& point : corners)
  {
    point = places[static_cast<std::size_t>(point)];
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

Vector3 AreaVector(const CellGeometry& geometry, const TriangleCorners& corners)
{
  const Vector3 a = geometry.Position(corners[0]);
  return Cross(
    Difference(geometry.Position(corners[1]), a), Difference(geometry.Position(corners[2]), a));
}

double Volume(const CellGeometry& geometry, std::int32_t tetrahedron)
{
  const std::array<Vector3, 4> p = geometry.Vertices(static_cast<std::size_t>(tetrahedron));
  return std::abs(
    Dot(Cross(Difference(p[1], p[0]), Difference(p[2], p[0])), Difference(p[3], p[0])));
}

void AddAlike(Vector3& sum, const Vector3& v)
{
  const double sign = Dot(sum, v) < 0 ? -1 : 1;
  sum = { { sum[0] + sign * v[0], sum[1] + sign * v[1], sum[2] + sign * v[2] } };
}
}

CellPolygons CellPolygons::Read(vtkDataSet* data, Which which)
{
  CellPolygons result;
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid)
  {
    return result;
  }
  TetrahedronSource source(data);
  vtkDataArray* contours = data->GetCellData()->GetArray("ContourIndex");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (IsSolid(grid->GetCellType(cell)) || source.IsHidden(cell))
    {
      continue;
    }
    const double contour = contours ? contours->GetComponent(cell, 0) : -1;
    const bool asked = which == Which::All || (which == Which::Contours && contour >= 0);
    const bool polygon = source.EmitTriangles([&](const std::array<vtkIdType, 3>& t) {
      if (asked)
      {
        result.Triangles.push_back(
          { { { std::int32_t(t[0]), std::int32_t(t[1]), std::int32_t(t[2]) } },
            static_cast<std::int32_t>(std::max(contour, 0.0)), cell });
      }
    });
    result.NumberOfPolygons += polygon;
    result.NumberOfOthers += polygon && which == Which::Contours && !asked;
  }
  return result;
}

std::vector<CellPolygons::Face> CellPolygons::Match(
  const CellGeometry& geometry, const std::vector<std::int32_t>& places)
{
  std::vector<std::pair<TriangleCorners, std::int32_t>> wanted;
  std::vector<std::uint8_t> touched(places.size(), 0);
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    wanted.emplace_back(Sorted(this->Triangles[i].Points, places), static_cast<std::int32_t>(i));
    for (const std::int32_t place : wanted.back().first)
    {
      touched[static_cast<std::size_t>(place)] = 1;
    }
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<Face> faces;
  std::vector<std::int32_t> found(wanted.size(), -1); // number of its face
  for (std::size_t t = 0; t < geometry.Tetrahedra.size() && !wanted.empty(); ++t)
  {
    const Tetrahedron& tetrahedron = geometry.Tetrahedra[t];
    for (int opposite = 0; opposite < 4; ++opposite)
    {
      TriangleCorners corners;
      for (std::size_t k = 0; k < 3; ++k)
      {
        corners[k] = tetrahedron[static_cast<std::size_t>(tetrahedronFaces[opposite][k])];
      }
      corners = Sorted(corners, places);
      if (!touched[std::size_t(corners[0])] || !touched[std::size_t(corners[1])] ||
        !touched[std::size_t(corners[2])])
      {
        continue;
      }
      const auto match =
        std::lower_bound(wanted.begin(), wanted.end(), std::make_pair(corners, std::int32_t(-1)));
      const std::size_t number = static_cast<std::size_t>(match - wanted.begin());
      if (match == wanted.end() || match->first != corners)
      {
        continue;
      }
      const Face face = { static_cast<std::int32_t>(t), opposite, match->second };
      if (found[number] < 0)
      {
        found[number] = static_cast<std::int32_t>(faces.size());
        faces.push_back(face);
      }
      else if (Volume(geometry, face.Tetrahedron) >
        Volume(geometry, faces[std::size_t(found[number])].Tetrahedron))
      {
        faces[std::size_t(found[number])] = face;
      }
    }
  }
  std::set<vtkIdType> apart;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const TriangleCorners& c = wanted[i].first;
    const bool repeated = c[0] == c[1] || c[1] == c[2] || (i > 0 && wanted[i - 1].first == c);
    if (found[i] < 0 && !repeated)
    {
      apart.insert(this->Triangles[static_cast<std::size_t>(wanted[i].second)].Cell);
    }
  }
  this->NumberApart = static_cast<std::int64_t>(apart.size());
  return faces;
}

std::vector<std::array<Vector3, 3>> CellPolygons::Normals(
  const CellGeometry& geometry, const std::vector<std::int32_t>& places, bool smooth) const
{
  const auto key = [&places](const Triangle& t, std::size_t k) {
    const std::uint64_t place =
      static_cast<std::uint32_t>(places[static_cast<std::size_t>(t.Points[k])]);
    return place << 32 | static_cast<std::uint32_t>(t.Contour);
  };
  std::unordered_map<std::uint64_t, Vector3> sums;
  for (const Triangle& t : this->Triangles)
  {
    for (std::size_t k = 0; k < 3 && smooth; ++k)
    {
      AddAlike(sums.emplace(key(t, k), Vector3{ { 0, 0, 0 } }).first->second,
        AreaVector(geometry, t.Points));
    }
  }
  std::vector<std::array<Vector3, 3>> normals;
  for (const Triangle& t : this->Triangles)
  {
    const Vector3 flat = AreaVector(geometry, t.Points);
    std::array<Vector3, 3> corners = { { flat, flat, flat } };
    for (std::size_t k = 0; k < 3 && smooth; ++k)
    {
      const Vector3& sum = sums[key(t, k)];
      const double length = std::sqrt(Dot(sum, sum)), sign = Dot(sum, flat) < 0 ? -1 : 1;
      const double size = sign * std::sqrt(Dot(flat, flat)) / length;
      corners[k] = length > 0 ? Vector3{ { size * sum[0], size * sum[1], size * sum[2] } } : flat;
    }
    normals.push_back(corners);
  }
  return normals;
}

} // namespace nephoscope
