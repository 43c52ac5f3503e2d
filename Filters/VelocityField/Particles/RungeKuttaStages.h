// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The particles that are still moving, side by side, with the slopes at the stages of a Runge-Kutta
// step.
// Plain C++17.
#ifndef nephoscope_RungeKuttaStages_h
#define nephoscope_RungeKuttaStages_h

#include "Particles.h"

#include <vector>

namespace nephoscope
{
class RungeKuttaStages
{
public:
  std::size_t Count() const { return this->Active.size(); }

  // Takes the particles that are inside, each with the whole step.
  void Gather(const Particles& particles, double step, int stages)
  {
    this->Active.clear();
    for (std::size_t i = 0; i < particles.Count; ++i)
    {
      if (particles.Inside[i])
      {
        this->Active.push_back(i);
      }
    }
    const std::size_t count = this->Count();
    this->Starts.resize(count);
    this->Hints.resize(count);
    this->Probes.resize(count);
    this->StageFound.resize(count);
    this->Found.assign(count, 1);
    this->Steps.assign(count, step);
    this->Slopes.resize(static_cast<std::size_t>(stages));
    for (auto& slopes : this->Slopes)
    {
      slopes.resize(count);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Starts[i] = particles.Positions[this->Active[i]];
      this->Hints[i] = particles.Hints[this->Active[i]];
    }
  }

  // Start + Step * (weighted sum of the first `stages` slopes).
  Vector3 Moved(std::size_t i, const double* weights, int stages) const
  {
    const Vector3 sum = this->WeightedSlope(i, weights, stages);
    const Vector3& start = this->Starts[i];
    const double step = this->Steps[i];
    return { start[0] + step * sum[0], start[1] + step * sum[1], start[2] + step * sum[2] };
  }

  Vector3 WeightedSlope(std::size_t i, const double* weights, int stages) const
  {
    Vector3 sum{};
    for (int s = 0; s < stages; ++s)
    {
      const Vector3& slope = this->Slopes[static_cast<std::size_t>(s)][i];
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[c] += weights[s] * slope[c];
      }
    }
    return sum;
  }

  // `weights` is the row of the stage in the method's table; `times`, if not null, holds a time for
  // each.
  void SampleStage(
    const VelocityField& field, const double* weights, int stage, double time, const double* times)
  {
    const std::size_t count = this->Count();
    auto& slopes = this->Slopes[static_cast<std::size_t>(stage)];
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Probes[i] = this->Moved(i, weights, stage);
    }
    field.Sample({ count, this->Probes.data(), time, slopes.data(), this->StageFound.data(),
      this->Hints.data(), times });
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!this->StageFound[i])
      {
        this->Found[i] = 0;
        slopes[i] = Vector3{};
      }
    }
  }

  // Gives a particle back; it moves only if it has stayed inside.
  void Release(
    const Particles& particles, std::size_t i, bool inside, const Vector3& position) const
  {
    const std::size_t particle = this->Active[i];
    particles.Hints[particle] = this->Hints[i];
    particles.Inside[particle] = inside;
    if (inside)
    {
      particles.Positions[particle] = position;
    }
  }

  // To close the gaps that released particles have left; `to` is not after `from`.
  void Keep(std::size_t from, std::size_t to)
  {
    this->Active[to] = this->Active[from];
    this->Starts[to] = this->Starts[from];
    this->Hints[to] = this->Hints[from];
    this->Steps[to] = this->Steps[from];
    this->Slopes.front()[to] = this->Slopes.front()[from];
  }

  std::vector<std::size_t> Active; // index among the particles
  std::vector<Vector3> Starts;
  std::vector<double> Steps;
  std::vector<unsigned char> Found; // 0 if a stage since was outside
  std::vector<std::vector<Vector3>> Slopes;

private:
  std::vector<CellHint> Hints;
  std::vector<Vector3> Probes;
  std::vector<unsigned char> StageFound;
};
}

#endif
