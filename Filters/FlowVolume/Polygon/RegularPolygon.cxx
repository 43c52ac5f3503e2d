// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Rings of points around the centre, as far apart as the points in a ring, joined by triangles.
#include "GeneratingPolygon.h"
#include "PolygonRefinement.h"

#include <limits>

namespace nephoscope
{
namespace
{
constexpr double pi = 3.14159265358979323846;

// The point at the share `turn` (0 to 1) of the outline of the regular polygon of radius 1.
std::array<double, 2> OutlinePoint(int sides, double turn)
{
  const double place = turn * sides;
  const double side = std::floor(place + 1e-9), share = std::max(place - side, 0.0);
  const double a = 2.0 * pi * side / sides, b = 2.0 * pi * (side + 1.0) / sides;
  return { { (1.0 - share) * std::cos(a) + share * std::cos(b),
    (1.0 - share) * std::sin(a) + share * std::sin(b) } };
}

// Joins ring to ring, always across to the ring that lags behind.
void JoinRings(PolygonMesh& mesh, PointId inner, int innerCount, PointId outer, int outerCount)
{
  int i = 0, o = 0;
  while (i < innerCount || o < outerCount)
  {
    const PointId a = inner + i % innerCount, b = outer + o % outerCount;
    const double nextInner = i < innerCount ? (i + 0.5) / innerCount : 2.0;
    const double nextOuter = o < outerCount ? (o + 0.5) / outerCount : 2.0;
    if (nextOuter <= nextInner)
    {
      mesh.Triangles.push_back({ { a, b, outer + ++o % outerCount } });
    }
    else
    {
      mesh.Triangles.push_back({ { a, b, inner + ++i % innerCount } });
    }
  }
}
}

PolygonMesh TriangulateRegularPolygon(const RegularPolygon& polygon, double maximumEdgeLength)
{
  PolygonMesh mesh;
  const int sides = std::max(polygon.Sides, 3);
  const Vector3 normal = Normalized(polygon.Normal);
  const double radius = polygon.Radius;
  const double length = maximumEdgeLength > 0.0 ? maximumEdgeLength : 0.5 * radius;
  const double ringCount = std::ceil(radius / length - 1e-9);
  // Areas and their products must be finite numbers.
  if (!(radius > 0.0) || !std::isfinite(radius * radius * radius * radius) ||
    !IsFinite(polygon.Center) || !IsFinite(normal) || !(Norm(normal) > 0.5) || !(ringCount < 300.0))
  {
    return mesh;
  }
  const Vector3 u = Perpendicular(normal), v = Cross(normal, u);
  const int rings = static_cast<int>(ringCount);
  const double side = 2.0 * radius * std::sin(pi / sides);
  const int outline = sides * static_cast<int>(std::ceil(side / length - 1e-9));
  mesh.Points.push_back(polygon.Center);
  PointId inner = 0;
  int innerCount = 1;
  for (int ring = 1; ring <= rings; ++ring)
  {
    const auto first = static_cast<PointId>(mesh.Points.size());
    const double share = static_cast<double>(ring) / rings;
    const int count = ring == rings
      ? outline
      : std::max(std::min(6 * ring, outline), static_cast<int>(std::ceil(outline * share)));
    for (int i = 0; i < count; ++i)
    {
      const auto p = OutlinePoint(sides, static_cast<double>(i) / count);
      mesh.Points.push_back(
        polygon.Center + (radius * share * p[0]) * u + (radius * share * p[1]) * v);
    }
    if (ring == 1)
    {
      for (int i = 0; i < count; ++i)
      {
        mesh.Triangles.push_back({ { 0, first + i, first + (i + 1) % count } });
      }
    }
    else
    {
      JoinRings(mesh, inner, innerCount, first, count);
    }
    inner = first;
    innerCount = count;
  }
  SwapToDelaunay(mesh, 0.0);
  HalveLongEdges(mesh, length, std::numeric_limits<std::size_t>::max());
  return mesh;
}
}
