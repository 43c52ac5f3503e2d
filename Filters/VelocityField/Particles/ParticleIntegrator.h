// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Particles moved along a flow, in batches. Plain C++17.
#ifndef nephoscope_ParticleIntegrator_h
#define nephoscope_ParticleIntegrator_h

#include "AdaptiveIntegrator.h"
#include "RungeKuttaStages.h"
#include "RungeKuttaTables.h"

namespace nephoscope
{
// One object per thread. What becomes of a particle does not depend on the others, so particles may
// be divided among integrators at will.
class ParticleIntegrator
{
public:
  explicit ParticleIntegrator(const VelocityField& field)
    : Field(field)
    , Adaptive(field)
  {
  }

  // Moves the particles from `time` to `time + step`; a negative step goes back in time.
  void Advance(
    const Particles& particles, double time, double step, const IntegrationSettings& settings)
  {
    switch (settings.Method)
    {
      case IntegrationMethod::Euler:
        this->AdvanceBy<EulerMethod>(particles, time, step);
        break;
      case IntegrationMethod::RungeKutta4:
        this->AdvanceBy<RungeKutta4>(particles, time, step);
        break;
      default:
        this->Adaptive.Advance(particles, time, step, settings);
    }
  }

private:
  template <typename Table>
  void AdvanceBy(const Particles& particles, double time, double step)
  {
    constexpr int stages = Table::StageCount;
    this->Stages.Gather(particles, step, stages);
    const std::size_t count = this->Stages.Count();
    for (int s = 0; s < stages && count > 0; ++s)
    {
      this->Stages.SampleStage(
        this->Field, Table::Stages[s], s, time + Table::Fractions[s] * step, nullptr);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool inside = this->Stages.Found[i];
      this->Stages.Release(particles, i, inside, this->Stages.Moved(i, Table::Weights, stages));
    }
  }

  const VelocityField& Field;
  RungeKuttaStages Stages;
  AdaptiveIntegrator Adaptive;
};
}

#endif
