// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceMesh.h"

#include "FaceNeighbors.h"

#include <utility>

#include <algorithm>

namespace nephoscope
{
namespace
{
std::array<std::int32_t, 3> OutwardFace(
  const CellGeometry& geometry, const Tetrahedron& t, int face)
{
  std::array<std::int32_t, 3> points;
  for (int k = 0; k < 3; ++k)
  {
    points[k] = t[tetrahedronFaces[face][k]];
  }
  const Vector3 inside = geometry.Position(t[face]);
  const double side = PlaneSide(geometry.Position(points[0]), geometry.Position(points[1]),
    geometry.Position(points[2]), { { inside[0], inside[1], inside[2], 1.0 } });
  if (side > 0)
  {
    std::swap(points[1], points[2]);
  }
  return points;
}

std::array<std::int32_t, 3> PointsOf(
  const Tetrahedron& t, std::array<std::int32_t, 3> face, const FaceNeighbors& neighbors)
{
  const std::vector<std::int32_t>& places = neighbors.GetPlaces();
  for (std::int32_t& point : face)
  {
    const auto same = std::find_if(t.begin(), t.end(),
      [&](std::int32_t p) { return places[std::size_t(p)] == places[std::size_t(point)]; });
    point = same == t.end() ? point : *same;
  }
  return face;
}
}

void FaceMesh::Build(const CellGeometry& geometry)
{
  FaceNeighbors neighbors;
  neighbors.Connect(geometry);
  const std::size_t n = geometry.Tetrahedra.size();
  this->Faces.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (int face = 0; face < 4; ++face)
    {
      const std::int32_t neighbor = neighbors.Get(i, face);
      const std::int32_t self = static_cast<std::int32_t>(i);
      if (neighbor < self && neighbor >= 0)
      {
        continue; // the neighbour has listed it
      }
      const auto points = OutwardFace(geometry, geometry.Tetrahedra[i], face);
      this->Faces.push_back({ points, self, neighbor,
        neighbor < 0
          ? points
          : PointsOf(geometry.Tetrahedra[static_cast<std::size_t>(neighbor)], points, neighbors) });
    }
  }
}

} // namespace nephoscope
