// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonPlaces.h"

#include "FlowReach.h"
#include "GeneratingPolygon.h"
#include "SmokeGeometry.h"

#include "vtkMath.h"

#include <algorithm>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr Vector3 unitNormal = { { 0.0, 0.0, 1.0 } };
constexpr double roundingRoom = 1.0 + 1e-6;
}

std::vector<Vector3> Rim(const Candidate& candidate, double radius)
{
  double across[3], along[3];
  vtkMath::Perpendiculars(candidate.Velocity.data(), across, along, 0.0);
  std::vector<Vector3> rim;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = i * vtkMath::Pi() / 4.0;
    Vector3 x = candidate.Place;
    for (std::size_t k = 0; k < 3; ++k)
    {
      x[k] += radius * (std::cos(angle) * across[k] + std::sin(angle) * along[k]);
    }
    rim.push_back(x);
  }
  return rim;
}

std::vector<unsigned char> SampleAt(
  const DataSetField& field, const std::vector<Vector3>& places, std::vector<Vector3>& velocities)
{
  std::vector<unsigned char> inside(places.size());
  std::vector<CellHint> hints(places.size());
  velocities.resize(places.size());
  field.Sample(
    { places.size(), places.data(), 0.0, velocities.data(), inside.data(), hints.data() });
  return inside;
}

PolygonPoints::PolygonPoints(int sides)
{
  const RegularPolygon unit{ {}, 1.0, sides, unitNormal };
  const Vector3 u = Perpendicular(unitNormal), v = Cross(unitNormal, u);
  for (const Vector3& point : TriangulateRegularPolygon(unit, 0.0).Points)
  {
    this->Points.push_back({ { Dot(point, u), Dot(point, v) } });
  }
}

std::vector<bool> PolygonPoints::AreInside(
  const DataSetField& field, const std::vector<Candidate>& candidates) const
{
  std::vector<Vector3> places, velocities;
  for (const Candidate& c : candidates)
  {
    this->AddPlaces(c, places);
  }
  const auto inside = SampleAt(field, places, velocities);
  std::vector<bool> all;
  for (auto first = inside.begin(); first != inside.end(); first += this->Count())
  {
    all.push_back(
      std::all_of(first, first + this->Count(), [](unsigned char i) { return i != 0; }));
  }
  return all;
}

void PolygonPoints::AddPlaces(const Candidate& c, std::vector<Vector3>& places) const
{
  const Vector3 normal = Normalized(c.Velocity), u = Perpendicular(normal), v = Cross(normal, u);
  for (const auto& [a, b] : this->Points)
  {
    places.push_back(
      c.Place + (roundingRoom * c.Radius * a) * u + (roundingRoom * c.Radius * b) * v);
  }
}

std::vector<double> MeanReaches(
  const DataSetField& field, const std::vector<Candidate>& candidates, double length)
{
  std::vector<Vector3> places;
  for (const Candidate& c : candidates)
  {
    const std::vector<Vector3> rim = Rim(c, c.Radius);
    places.insert(places.end(), rim.begin(), rim.end());
    places.push_back(c.Place);
  }
  const std::vector<double> reaches = FlowReaches(field, places, length);
  const std::size_t each = places.size() / std::max<std::size_t>(1, candidates.size());
  std::vector<double> means;
  for (auto first = reaches.begin(); first != reaches.end();
       first += static_cast<std::ptrdiff_t>(each))
  {
    means.push_back(std::accumulate(first, first + static_cast<std::ptrdiff_t>(each), 0.0) /
      static_cast<double>(each));
  }
  return means;
}

void FindRoom(const DataSetField& field, double radius, std::vector<Candidate>& candidates)
{
  constexpr std::size_t corners = 8;
  for (Candidate& c : candidates)
  {
    c.Room = 0.0;
  }
  double before = 0.0;
  for (const double radii :
    { 1.0 / 64, 1.0 / 32, 1.0 / 16, 0.125, 0.25, 0.5, 1.0, 2.0, 3.0, mostRoom })
  {
    std::vector<Vector3> places, velocities;
    for (const Candidate& c : candidates)
    {
      const std::vector<Vector3> rim = Rim(c, roundingRoom * radii * radius);
      places.insert(places.end(), rim.begin(), rim.end());
    }
    const auto inside = SampleAt(field, places, velocities);
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      const auto first = inside.begin() + static_cast<std::ptrdiff_t>(i * corners);
      const bool free = std::all_of(first, first + static_cast<std::ptrdiff_t>(corners),
        [](unsigned char j) { return j != 0; });
      const bool soFar = candidates[i].Room >= before;
      candidates[i].Room = free && soFar ? radii / mostRoom : candidates[i].Room;
    }
    before = radii / mostRoom;
  }
}
}
