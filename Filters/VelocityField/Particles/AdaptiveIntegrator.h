// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Particles moved with an error that is kept below a tolerance. Every particle takes sub-steps of
// its own; a batch holds the next sub-step of all that have not arrived yet. Plain C++17.
#ifndef nephoscope_AdaptiveIntegrator_h
#define nephoscope_AdaptiveIntegrator_h

#include "RungeKuttaStages.h"
#include "RungeKuttaTables.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
class AdaptiveIntegrator
{
public:
  explicit AdaptiveIntegrator(const VelocityField& field)
    : Field(field)
  {
  }

  void Advance(
    const Particles& particles, double time, double step, const IntegrationSettings& settings)
  {
    this->WholeStep = step;
    this->Begin(particles, time);
    while (this->Stages.Count() > 0)
    {
      this->SampleSubSteps();
      this->Sort(particles, [&](std::size_t i) { return this->EndSubStep(i, settings); });
    }
  }

private:
  enum class Outcome
  {
    OnItsWay,
    Arrived,
    Left
  };

  void Begin(const Particles& particles, double time)
  {
    this->Stages.Gather(particles, this->WholeStep, DormandPrince54::StageCount);
    const std::size_t count = this->Stages.Count();
    this->Walks.assign(count, Walk{ time, this->WholeStep, this->WholeStep, 0 });
    this->StageTimes.resize(count);
    for (std::size_t i = 0; particles.SubSteps && i < count; ++i)
    {
      const double wanted = std::abs(particles.SubSteps[this->Stages.Active[i]]);
      if (wanted > 0.0 && wanted < std::abs(this->WholeStep))
      {
        this->Walks[i].Wanted = std::copysign(wanted, this->WholeStep);
      }
    }
    if (count > 0)
    {
      this->Stages.SampleStage(this->Field, DormandPrince54::Stages[0], 0, time, nullptr);
    }
    this->Sort(particles, [this](std::size_t i) {
      return !this->Stages.Found[i] ? Outcome::Left
        : this->WholeStep == 0.0    ? Outcome::Arrived
                                    : Outcome::OnItsWay;
    });
  }

  void SampleSubSteps()
  {
    const std::size_t count = this->Stages.Count();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Walk& walk = this->Walks[i];
      // Rather a step that is slightly longer than a tiny one at the end.
      const bool last = std::abs(walk.Wanted) > 0.999 * std::abs(walk.Remaining);
      this->Stages.Steps[i] = last ? walk.Remaining : walk.Wanted;
      this->Stages.Found[i] = 1;
    }
    for (int stage = 1; stage < DormandPrince54::StageCount; ++stage)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        this->StageTimes[i] =
          this->Walks[i].Time + DormandPrince54::Fractions[stage] * this->Stages.Steps[i];
      }
      this->Stages.SampleStage(this->Field, DormandPrince54::Stages[stage], stage,
        this->StageTimes.front(), this->StageTimes.data());
    }
  }

  Outcome EndSubStep(std::size_t i, const IntegrationSettings& settings)
  {
    Walk& walk = this->Walks[i];
    const double step = this->Stages.Steps[i];
    if (++walk.Count > settings.MaximumSubSteps)
    {
      return Outcome::Left;
    }
    if (!this->Stages.Found[i])
    {
      // Only the probe of a long step may have been outside: come nearer before giving up.
      walk.Wanted = 0.25 * step;
      return std::abs(step) > 1e-3 * std::abs(this->WholeStep) ? Outcome::OnItsWay : Outcome::Left;
    }
    const double error = this->ErrorOf(i);
    // HairerNorsettWanner1993 II.4: a safety factor, and no sudden change.
    const double factor =
      std::clamp(0.9 * std::pow(settings.Tolerance / std::max(error, 1e-300), 0.2), 0.2, 5.0);
    if (!(error <= settings.Tolerance))
    {
      walk.Wanted = std::min(factor, 0.9) * step;
      return Outcome::OnItsWay;
    }
    const bool last = step == walk.Remaining;
    const double next = factor * step;
    walk.Wanted = last && std::abs(next) < std::abs(walk.Wanted) ? walk.Wanted : next;
    walk.Time += step;
    walk.Remaining = last ? 0.0 : walk.Remaining - step;
    // The last stage is at the end of the sub-step.
    this->Stages.Starts[i] = this->Stages.Moved(i, DormandPrince54::Stages[6], 6);
    this->Stages.Slopes[0][i] = this->Stages.Slopes[6][i];
    return last ? Outcome::Arrived : Outcome::OnItsWay;
  }

  double ErrorOf(std::size_t i) const
  {
    const Vector3 error =
      this->Stages.WeightedSlope(i, DormandPrince54::Errors, DormandPrince54::StageCount);
    return std::abs(this->Stages.Steps[i]) *
      std::sqrt(error[0] * error[0] + error[1] * error[1] + error[2] * error[2]);
  }

  // Keeps the moving particles and returns the others.
  template <typename Judge>
  void Sort(const Particles& particles, const Judge& judge)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Stages.Count(); ++i)
    {
      const Outcome outcome = judge(i);
      if (outcome == Outcome::OnItsWay)
      {
        this->Stages.Keep(i, kept);
        this->Walks[kept++] = this->Walks[i];
        continue;
      }
      const std::size_t particle = this->Stages.Active[i];
      if (particles.SubSteps)
      {
        particles.SubSteps[particle] = std::abs(this->Walks[i].Wanted);
      }
      this->Stages.Release(particles, i, outcome == Outcome::Arrived, this->Stages.Starts[i]);
    }
    this->Stages.Active.resize(kept);
    this->Walks.resize(kept);
  }

  struct Walk
  {
    double Time;
    double Remaining;
    double Wanted; // sub-step
    int Count;
  };

  const VelocityField& Field;
  double WholeStep = 0.0;
  RungeKuttaStages Stages;
  std::vector<Walk> Walks;
  std::vector<double> StageTimes;
};
}

#endif
