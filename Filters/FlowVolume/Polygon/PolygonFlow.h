// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The flow through a generating polygon at one time. Plain C++17.
#ifndef nephoscope_PolygonFlow_h
#define nephoscope_PolygonFlow_h

#include "SmokeGeometry.h"
#include "SmokeMesh.h"

#include <algorithm>

namespace nephoscope
{
// Area times unit normal of triangle t.
inline Vector3 AreaVector(const PolygonMesh& polygon, std::size_t t)
{
  const auto corner = [&](std::size_t c) -> const Vector3& {
    return polygon.Points[static_cast<std::size_t>(polygon.Triangles[t][c])];
  };
  return AreaVector(corner(0), corner(1), corner(2));
}

// Velocities at the points of a polygon.
struct PolygonVelocities
{
  std::vector<Vector3> Values;
  std::vector<unsigned char> Inside;

  void Sample(const VelocityField& field, const PolygonMesh& polygon, double time)
  {
    const std::size_t count = polygon.Points.size();
    this->Values.assign(count, Vector3{});
    this->Inside.assign(count, 0);
    this->Hints.resize(count);
    field.Sample({ count, polygon.Points.data(), time, this->Values.data(), this->Inside.data(),
      this->Hints.data() });
  }

  bool IsInside(const PolygonMesh& polygon, std::size_t t) const
  {
    const auto& corners = polygon.Triangles[t];
    return std::all_of(corners.begin(), corners.end(),
      [this](PointId p) { return this->Inside[static_cast<std::size_t>(p)] != 0; });
  }

  // Volume per second through triangle t, exact where the velocity is linear; 0 where a corner is
  // outside.
  double Flux(const PolygonMesh& polygon, std::size_t t) const
  {
    if (!this->IsInside(polygon, t))
    {
      return 0.0;
    }
    Vector3 sum{};
    for (const PointId id : polygon.Triangles[t])
    {
      sum = sum + this->Values[static_cast<std::size_t>(id)];
    }
    return Dot(sum, AreaVector(polygon, t)) / 3.0;
  }

private:
  std::vector<CellHint> Hints;
};

// The messages about the flow at a polygon, and the basis of the automatic settings.
struct PolygonFlow
{
  PolygonFlow(const VelocityField& field, const PolygonMesh& polygon, double time)
  {
    PolygonVelocities velocities;
    velocities.Sample(field, polygon, time);
    for (std::size_t p = 0; p < polygon.Points.size(); ++p)
    {
      this->PointsInside += velocities.Inside[p];
      this->MeanSpeed += velocities.Inside[p] ? Norm(velocities.Values[p]) : 0.0;
    }
    this->MeanSpeed /= static_cast<double>(std::max<std::size_t>(1, this->PointsInside));
    for (std::size_t t = 0; t < polygon.Triangles.size(); ++t)
    {
      this->AddTriangle(polygon, t, velocities);
    }
  }

  // Rounding alone makes a little flux of a flow in the plane of the polygon.
  bool IsParallel() const
  {
    return this->AreaInside > 0.0 && this->Flux <= 1e-12 * this->MeanSpeed * this->AreaInside;
  }

  std::size_t PointsInside = 0;
  double MeanSpeed = 0.0; // over the points inside
  double Flux = 0.0;      // volume per second, whatever the side
  double Area = 0.0;
  double AreaInside = 0.0;  // of the triangles that are inside with all corners
  double LongestEdge = 0.0; // of its triangles
  Vector3 Normal{};         // mean, of unit length

private:
  void AddTriangle(const PolygonMesh& polygon, std::size_t t, const PolygonVelocities& velocities)
  {
    const Vector3 area = AreaVector(polygon, t);
    this->Area += Norm(area);
    this->AreaInside += velocities.IsInside(polygon, t) ? Norm(area) : 0.0;
    this->Flux += std::abs(velocities.Flux(polygon, t));
    this->NormalSum = this->NormalSum + area;
    this->Normal = Normalized(this->NormalSum);
    const auto& ends = polygon.Triangles[t];
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->LongestEdge = std::max(this->LongestEdge,
        Distance(polygon.Points[static_cast<std::size_t>(ends[c])],
          polygon.Points[static_cast<std::size_t>(ends[(c + 1) % 3])]));
    }
  }

  Vector3 NormalSum{};
};
}

#endif
