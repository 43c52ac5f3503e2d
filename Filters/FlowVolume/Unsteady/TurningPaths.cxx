// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TurningPaths.h"

#include "AdvanceParticles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nephoscope
{
namespace
{
// Some of the points of the smoke, on their way.
struct MovingPoints
{
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
  std::vector<unsigned char> Inside;
  std::vector<Vector3> Ways;
  std::vector<double> Steps;
  std::vector<unsigned char> Turns; // 1: too much, in one of the parts of the step

  MovingPoints(const StreakMesh& smoke, const std::vector<std::size_t>& which)
    : Turns(which.size(), 0)
  {
    for (const std::size_t p : which)
    {
      this->Positions.push_back(smoke.Positions[p]);
      this->Hints.push_back(smoke.Hints[p]);
      this->Inside.push_back(smoke.Inside[p]);
      this->Ways.push_back(smoke.Ways[p]);
      this->Steps.push_back(smoke.Steps[p]);
    }
  }

  void Advance(const VelocityField& field, double time, double step,
    const IntegrationSettings& integration, double angle)
  {
    const std::vector<Vector3> before = this->Positions;
    AdvanceParticles(field,
      { this->Positions.data(), this->Hints.data(), this->Inside.data(), this->Positions.size() },
      time, step, integration);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      const Vector3 chord = this->Positions[i] - before[i];
      if (this->Inside[i])
      {
        this->Turns[i] |= TurnsTooMuch(this->Ways[i], this->Steps[i], chord, step, angle);
        this->Ways[i] = chord;
        this->Steps[i] = step;
      }
    }
  }

  void Put(std::size_t i, StreakMesh& smoke, std::size_t p) const
  {
    smoke.Positions[p] = this->Positions[i];
    smoke.Hints[p] = this->Hints[i];
    smoke.Inside[p] = this->Inside[i];
    smoke.Ways[p] = this->Ways[i];
    smoke.Steps[p] = this->Steps[i];
  }
};
}

// The tangent turns by `angle` in a step, so two chords differ by that over
// (before + step) / 2.
bool TurnsTooMuch(
  const Vector3& way, double before, const Vector3& chord, double step, double angle)
{
  constexpr double halfTurn = 3.14159265358979323846;
  const double most = std::min(angle * (before + step) / (2.0 * step), halfTurn);
  return angle > 0.0 && Dot(way, chord) < std::cos(most) * Norm(way) * Norm(chord);
}

void AdvanceSmoke(const VelocityField& field, StreakMesh& smoke, double time, double step,
  const IntegrationSettings& integration, const TurnLimits& limits)
{
  std::vector<std::size_t> left(smoke.Positions.size());
  std::iota(left.begin(), left.end(), std::size_t{ 0 });
  const int most = limits.Angle > 0.0 ? limits.Halvings : 0;
  for (int halvings = 0; !left.empty(); ++halvings)
  {
    MovingPoints moving(smoke, left);
    const int parts = 1 << halvings;
    for (int part = 0; part < parts; ++part)
    {
      moving.Advance(field, time + step * part / parts, step / parts, integration, limits.Angle);
    }
    std::vector<std::size_t> again;
    for (std::size_t i = 0; i < left.size(); ++i)
    {
      if (moving.Turns[i] && halvings < most)
      {
        again.push_back(left[i]);
      }
      else
      {
        moving.Put(i, smoke, left[i]);
      }
    }
    left = std::move(again);
  }
}
}
