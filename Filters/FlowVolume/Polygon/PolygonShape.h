// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Size, position and direction of a generating polygon. Plain C++17.
#ifndef nephoscope_PolygonShape_h
#define nephoscope_PolygonShape_h

#include "SmokeGeometry.h"
#include "SmokeMesh.h"

#include <algorithm>

namespace nephoscope
{
inline Vector3 AreaVector(const PolygonMesh& mesh, const std::array<PointId, 3>& t)
{
  const auto& p = mesh.Points;
  return AreaVector(p[static_cast<std::size_t>(t[0])], p[static_cast<std::size_t>(t[1])],
    p[static_cast<std::size_t>(t[2])]);
}

inline double Area(const PolygonMesh& mesh)
{
  double area = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    area += Norm(AreaVector(mesh, t));
  }
  return area;
}

// The mean of the triangles' normals, weighted by area; zero if they cancel out.
inline Vector3 Normal(const PolygonMesh& mesh)
{
  Vector3 sum{};
  for (const auto& t : mesh.Triangles)
  {
    sum = sum + AreaVector(mesh, t);
  }
  return Normalized(sum);
}

// The centre of its area.
inline Vector3 Center(const PolygonMesh& mesh)
{
  const Vector3 origin = mesh.Points.empty() ? Vector3{} : mesh.Points[0];
  Vector3 sum{};
  double weight = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    const double area = Norm(AreaVector(mesh, t));
    for (PointId point : t)
    {
      sum = sum + (area / 3.0) * (mesh.Points[static_cast<std::size_t>(point)] - origin);
    }
    weight += area;
  }
  return weight > 0.0 ? origin + (1.0 / weight) * sum : origin;
}

inline double LongestEdge(const PolygonMesh& mesh)
{
  double longest = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      longest = std::max(longest,
        Distance(mesh.Points[static_cast<std::size_t>(t[i])],
          mesh.Points[static_cast<std::size_t>(t[(i + 1) % 3])]));
    }
  }
  return longest;
}

// The largest distance of any two points is between this and sqrt(3) times it.
inline double LongestExtent(const std::vector<Vector3>& points)
{
  double longest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    double low = points.empty() ? 0.0 : points[0][c], high = low;
    for (const Vector3& p : points)
    {
      low = std::min(low, p[c]);
      high = std::max(high, p[c]);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

// A direction at right angles to another one of unit length.
inline Vector3 Perpendicular(const Vector3& direction)
{
  std::size_t least = 0;
  for (std::size_t c = 1; c < 3; ++c)
  {
    least = std::abs(direction[c]) < std::abs(direction[least]) ? c : least;
  }
  Vector3 axis{};
  axis[least] = 1.0;
  return Normalized(Cross(direction, axis));
}

// Rotates the polygon about a point, by the smallest angle, until its normal is the direction.
// Nothing happens if the direction or the polygon's normal is zero or not finite.
inline void TurnNormalTo(PolygonMesh& mesh, const Vector3& center, const Vector3& direction)
{
  const Vector3 from = Normal(mesh), to = Normalized(direction);
  if (!(Norm(from) > 0.5) || !(Norm(to) > 0.5) || !IsFinite(to))
  {
    return;
  }
  const Vector3 normal = Cross(from, to);
  const double sine = Norm(normal), cosine = Dot(from, to);
  const Vector3 axis = sine > 1e-14 ? Normalized(normal) : Perpendicular(from);
  for (Vector3& point : mesh.Points)
  {
    // Rodrigues' rotation formula.
    const Vector3 arm = point - center;
    point =
      center + cosine * arm + sine * Cross(axis, arm) + ((1.0 - cosine) * Dot(axis, arm)) * axis;
  }
}
}

#endif
