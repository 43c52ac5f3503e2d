// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Particles moved along a flow by the classical Runge-Kutta method of fourth order. Plain C++17.
#ifndef nephoscope_ParticleIntegrator_h
#define nephoscope_ParticleIntegrator_h

#include "VelocityField.h"

#include <vector>

namespace nephoscope
{
// Particles that share a time. `Inside` is 0 from the moment a particle has left the field: it keeps its last position.
struct Particles
{
  Vector3* Positions = nullptr;
  CellHint* Hints = nullptr;
  unsigned char* Inside = nullptr;
  std::size_t Count = 0;
};

class ParticleIntegrator
{
public:
  explicit ParticleIntegrator(const VelocityField& field)
    : Field(field)
  {
  }

  // Moves the particles from `time` to `time + step`.
  void AdvanceRungeKutta4(const Particles& particles, double time, double step)
  {
    this->Resize(particles.Count);
    constexpr double fractions[4] = { 0.0, 0.5, 0.5, 1.0 };
    constexpr double weights[4] = { 1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0 };
    for (std::size_t i = 0; i < particles.Count; ++i)
    {
      this->Sum[i] = { 0.0, 0.0, 0.0 };
    }
    for (int stage = 0; stage < 4; ++stage)
    {
      this->MoveProbes(particles, fractions[stage] * step);
      this->Field.Sample({ particles.Count, this->Probes.data(), time + fractions[stage] * step,
        this->Velocities.data(), this->Found.data(), particles.Hints });
      this->Gather(particles, weights[stage]);
    }
    for (std::size_t i = 0; i < particles.Count; ++i)
    {
      for (int c = 0; particles.Inside[i] && c < 3; ++c)
      {
        particles.Positions[i][c] += step * this->Sum[i][c];
      }
    }
  }

private:
  void Resize(std::size_t count)
  {
    this->Probes.resize(count);
    this->Velocities.assign(count, Vector3{});
    this->Sum.resize(count);
    this->Found.resize(count);
  }

  void MoveProbes(const Particles& particles, double step)
  {
    for (std::size_t i = 0; i < particles.Count; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Probes[i][c] = particles.Positions[i][c] + step * this->Velocities[i][c];
      }
    }
  }

  void Gather(const Particles& particles, double weight)
  {
    for (std::size_t i = 0; i < particles.Count; ++i)
    {
      particles.Inside[i] = particles.Inside[i] && this->Found[i];
      for (int c = 0; this->Found[i] && c < 3; ++c)
      {
        this->Sum[i][c] += weight * this->Velocities[i][c];
      }
    }
  }

  const VelocityField& Field;
  std::vector<Vector3> Probes;
  std::vector<Vector3> Velocities;
  std::vector<Vector3> Sum;
  std::vector<unsigned char> Found;
};
}

#endif
