// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstFront.h"

#include <functional>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr double parallel = 1e-12; // flux through a triangle, of area times speed

class Flow
{
public:
  Flow(const VelocityField& field, double time)
    : Field(field)
    , Time(time)
  {
  }

  // At the points of the front that are new since the last call.
  void Sample(SmokeFront& front)
  {
    const std::size_t first = this->Inside.size(), count = front.Positions.size() - first;
    this->Velocities.resize(first + count);
    this->Inside.resize(first + count);
    this->Field.Sample({ count, front.Positions.data() + first, this->Time,
      this->Velocities.data() + first, this->Inside.data() + first, front.Hints.data() + first });
    for (std::size_t i = first; i < first + count; ++i)
    {
      this->Inside[i] = this->Inside[i] && IsFinite(this->Velocities[i]);
    }
  }

  bool IsInside(const FrontTriangle& t) const
  {
    return std::all_of(t.Points.begin(), t.Points.end(),
      [this](PointId p) { return this->Inside[static_cast<std::size_t>(p)] != 0; });
  }

  // The flux through the triangle: with sign, and how much of it goes the other way at some
  // corners.
  void Cross(const SmokeFront& front, const FrontTriangle& t, double& sum, double& against) const
  {
    const Vector3 area = AreaVector(front.Corner(t, 0), front.Corner(t, 1), front.Corner(t, 2));
    double forth = 0.0, back = 0.0;
    for (PointId point : t.Points)
    {
      const double flux = Dot(area, this->Velocities[static_cast<std::size_t>(point)]) / 3.0;
      (flux > 0.0 ? forth : back) += std::abs(flux);
    }
    sum = forth - back;
    against = std::min(forth, back);
  }

  bool IsParallel(const SmokeFront& front, const FrontTriangle& t) const
  {
    double sum, against, largest = 0.0;
    this->Cross(front, t, sum, against);
    const double area =
      Norm(AreaVector(front.Corner(t, 0), front.Corner(t, 1), front.Corner(t, 2)));
    for (PointId point : t.Points)
    {
      largest = std::max(largest, area * Norm(this->Velocities[static_cast<std::size_t>(point)]));
    }
    return against > parallel * largest || std::abs(sum) <= parallel * largest;
  }

  std::vector<Vector3> Velocities;
  std::vector<unsigned char> Inside;

private:
  const VelocityField& Field;
  double Time;
};

// Marks the edges to halve: of triangles that are too large, partly outside or crossed both ways.
std::size_t MarkFirstEdges(const SmokeFront& front, const Flow& flow, const EdgeLimits& limits,
  std::vector<unsigned char>& marks)
{
  const std::vector<unsigned char> none(front.Triangles.size(),
    0); // found in the first layer
  MarkEdges(front, front.Positions, flow.Inside, none, limits, marks);
  for (std::size_t t = 0; t < front.Triangles.size(); ++t)
  {
    const FrontTriangle& triangle = front.Triangles[t];
    if (flow.IsInside(triangle) && flow.IsParallel(front, triangle))
    {
      MarkTriangle(front, t, limits.Obstacle, marks);
    }
  }
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

std::size_t Remove(
  std::vector<FrontTriangle>& triangles, const std::function<bool(const FrontTriangle&)>& condition)
{
  const auto end = std::remove_if(triangles.begin(), triangles.end(), condition);
  const auto removed = static_cast<std::size_t>(triangles.end() - end);
  triangles.erase(end, triangles.end());
  return removed;
}
}

SmokeFront MakeFirstFront(const PolygonMesh& polygon)
{
  const std::size_t count = polygon.Points.size();
  std::vector<std::size_t> order(count), places(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&polygon](std::size_t a, std::size_t b) { return polygon.Points[a] < polygon.Points[b]; });
  SmokeFront front;
  for (std::size_t i = 0; i < count; ++i)
  {
    places[order[i]] = i;
    front.Positions.push_back(polygon.Points[order[i]]);
    front.Ids.push_back(static_cast<PointId>(i));
  }
  const auto valid = [count](PointId p) { return p >= 0 && static_cast<std::size_t>(p) < count; };
  for (const auto& t : polygon.Triangles)
  {
    if (!std::all_of(t.begin(), t.end(), valid))
    {
      continue;
    }
    FrontTriangle triangle;
    std::transform(t.begin(), t.end(), triangle.Points.begin(),
      [&places](PointId p) { return static_cast<PointId>(places[static_cast<std::size_t>(p)]); });
    auto& p = triangle.Points;
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    if (Norm(AreaVector(
          front.Corner(triangle, 0), front.Corner(triangle, 1), front.Corner(triangle, 2))) > 0.0)
    {
      front.Triangles.push_back(triangle);
    }
  }
  std::sort(front.Triangles.begin(), front.Triangles.end(),
    [](const FrontTriangle& a, const FrontTriangle& b) { return a.Points < b.Points; });
  front.Hints.resize(count);
  front.Directions.resize(count);
  return front;
}

Emission EmitFrom(SmokeFront& front, const VelocityField& field, double time,
  const EdgeLimits& limits, std::size_t maximumNumberOfTriangles)
{
  Emission emission;
  Flow flow(field, time);
  flow.Sample(front);
  front.BuildEdges();
  std::vector<unsigned char> marks;
  while (!emission.LimitReached && MarkFirstEdges(front, flow, limits, marks) > 0)
  {
    front.HalveEdges(marks, static_cast<PointId>(front.Positions.size()));
    flow.Sample(front);
    emission.LimitReached = front.Triangles.size() > maximumNumberOfTriangles;
  }
  if (emission.LimitReached)
  {
    front.Triangles.clear();
  }
  emission.Outside =
    Remove(front.Triangles, [&](const FrontTriangle& t) { return !flow.IsInside(t); }) > 0;
  emission.Parallel =
    Remove(front.Triangles, [&](const FrontTriangle& t) { return flow.IsParallel(front, t); });
  std::transform(
    flow.Velocities.begin(), flow.Velocities.end(), front.Directions.begin(), Normalized);
  for (FrontTriangle& triangle : front.Triangles)
  {
    double flux, against;
    flow.Cross(front, triangle, flux, against);
    triangle.Mass = std::abs(flux);
    emission.Flux += triangle.Mass;
    if (flux < 0.0)
    {
      std::swap(triangle.Points[1], triangle.Points[2]);
    }
  }
  front.Compact();
  front.BuildEdges();
  return emission;
}
}
