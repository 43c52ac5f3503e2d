// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObstacleLoss.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr int positionsAhead = 32; // of each corner
constexpr double nearest = 4.0;    // steps ahead, so that a bent path does not count

struct Samples
{
  std::vector<Vector3> Velocities;
  std::vector<unsigned char> Inside;

  Samples(const VelocityField& field, double time, const std::vector<Vector3>& positions)
    : Velocities(positions.size())
    , Inside(positions.size(), 0)
  {
    std::vector<CellHint> hints(positions.size());
    field.Sample({ positions.size(), positions.data(), time, this->Velocities.data(),
      this->Inside.data(), hints.data() });
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const Vector3& v = this->Velocities[i];
      this->Inside[i] = this->Inside[i] && std::isfinite(v[0] + v[1] + v[2]);
    }
  }
};

// The way of a step from the corners, the mean of those that have a velocity. A small part of a
// triangle that spans an obstacle has none: the triangle faces downstream.
std::vector<Vector3> WaysOf(
  const VelocityField& field, double time, const std::vector<EndedSmoke>& ended)
{
  std::vector<Vector3> corners;
  for (const EndedSmoke& smoke : ended)
  {
    corners.insert(corners.end(), smoke.Corners.begin(), smoke.Corners.end());
  }
  const Samples at(field, time, corners);
  std::vector<Vector3> ways(ended.size(), Vector3{});
  for (std::size_t e = 0; e < ended.size(); ++e)
  {
    double count = 0.0;
    for (std::size_t c = 3 * e; c < 3 * e + 3; ++c)
    {
      ways[e] = at.Inside[c] ? ways[e] + at.Velocities[c] : ways[e];
      count += at.Inside[c] ? 1.0 : 0.0;
    }
    const auto& p = ended[e].Corners;
    ways[e] = count > 0.0 ? (ended[e].Step / count) * ways[e] : Cross(p[1] - p[0], p[2] - p[0]);
  }
  return ways;
}
}

double MassAtObstacles(
  const VelocityField& field, double time, double farthest, const std::vector<EndedSmoke>& ended)
{
  const std::vector<Vector3> ways = WaysOf(field, time, ended);
  std::vector<Vector3> ahead;
  std::vector<std::size_t> owners;
  for (std::size_t e = 0; e < ended.size(); ++e)
  {
    const double length = Norm(ways[e]);
    const double first = std::min(nearest * length, farthest);
    for (std::size_t c = 0; c < 3 && length > 0.0; ++c)
    {
      for (int i = 0; i < positionsAhead && ended[e].Leaves[c]; ++i)
      {
        const double along = first + (farthest - first) * i / (positionsAhead - 1);
        ahead.push_back(ended[e].Corners[c] + (along / length) * ways[e]);
        owners.push_back(e);
      }
    }
  }
  const Samples there(field, time, ahead);
  std::vector<double> masses(ended.size(), 0.0);
  for (std::size_t e = 0; e < ended.size(); ++e)
  {
    masses[e] = ended[e].AtObstacle ? ended[e].Mass : 0.0;
  }
  for (std::size_t i = 0; i < ahead.size(); ++i)
  {
    masses[owners[i]] = there.Inside[i] ? ended[owners[i]].Mass : masses[owners[i]];
  }
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}
}
