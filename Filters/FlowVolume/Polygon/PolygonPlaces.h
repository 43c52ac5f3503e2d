// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Places at which a generating polygon may be, and what tells whether it fits there. All functions
// are collective: every rank calls them with the same places.
#ifndef nephoscope_PolygonPlaces_h
#define nephoscope_PolygonPlaces_h

#include "VelocityFields.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nephoscope
{
constexpr double mostRoom = 4.0; // radii of the polygon, across the flow

struct Candidate // a place for the polygon
{
  Vector3 Place{};
  Vector3 Velocity{};
  double Speed = 0.0;
  double Distance = 0.0; // squared, from the middle, in steps: equal ones differ by rounding
  double Radius = 0.0;   // that fits in
  double Room = 0.0;     // share of `mostRoom` radii that is free around it
  double Quality = 0.0;
};

// Rounded, and the same if it differs by rounding errors, as it does between numbers of ranks.
inline double Step(double value)
{
  return std::floor(value + 0.5 + 1e-7);
}

// The velocities at the places, and whether each is inside the data.
std::vector<unsigned char> SampleAt(
  const DataSetField& field, const std::vector<Vector3>& places, std::vector<Vector3>& velocities);

// Eight points on the rim of a disc across the flow.
std::vector<Vector3> Rim(const Candidate& candidate, double radius);

// The points of the triangles that vtkFlowVolume divides its regular polygon into.
class PolygonPoints
{
public:
  explicit PolygonPoints(int sides);

  // For each of the candidates, with its radius.
  std::vector<bool> AreInside(
    const DataSetField& field, const std::vector<Candidate>& candidates) const;

private:
  std::ptrdiff_t Count() const { return static_cast<std::ptrdiff_t>(this->Points.size()); }
  void AddPlaces(const Candidate& candidate, std::vector<Vector3>& places) const;

  std::vector<std::array<double, 2>> Points; // of a polygon of radius 1, in its plane
};

// How far smoke from the middle and the rim of each goes on average (FlowReach.h).
std::vector<double> MeanReaches(
  const DataSetField& field, const std::vector<Candidate>& candidates, double length);

// Sets Room: how far from the border of the data each is, across the flow. Smoke beside a wall
// sticks to it, or leaves the data.
void FindRoom(const DataSetField& field, double radius, std::vector<Candidate>& candidates);
}

#endif
