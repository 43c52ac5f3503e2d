// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AdvanceParticles.h"

#include "OwnThreads.h"
#include "ParticleIntegrator.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// A batch and its scratch stay in the first-level cache; a job outweighs the cost of handing it to
// a thread.
constexpr std::size_t BATCH_SIZE = 64;
constexpr vtkIdType JOB_SIZE = 256;
// Starting threads takes about as long as a step of so many particles on a structured grid.
constexpr std::size_t SERIAL_COUNT = 256;

Particles Part(const Particles& all, std::size_t begin, std::size_t end)
{
  Particles part = all;
  part.Positions += begin;
  part.Hints += begin;
  part.Inside += begin;
  part.Count = end - begin;
  part.SubSteps += all.SubSteps ? begin : 0;
  return part;
}

void AdvanceInBatches(const VelocityField& field, const Particles& particles, double time,
  double step, const IntegrationSettings& settings)
{
  ParticleIntegrator integrator(field);
  for (std::size_t begin = 0; begin < particles.Count; begin += BATCH_SIZE)
  {
    const std::size_t end = std::min(begin + BATCH_SIZE, particles.Count);
    integrator.Advance(Part(particles, begin, end), time, step, settings);
  }
}
}

void AdvanceParticles(const VelocityField& field, const Particles& particles, double time,
  double step, const IntegrationSettings& settings)
{
  if (!field.IsLocal())
  {
    ParticleIntegrator(field).Advance(particles, time, step, settings);
    return;
  }
  if (particles.Count <= SERIAL_COUNT || settings.Threads == 1)
  {
    AdvanceInBatches(field, particles, time, step, settings);
    return;
  }
  const auto work = [&](vtkIdType begin, vtkIdType end) {
    const Particles part =
      Part(particles, static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
    AdvanceInBatches(field, part, time, step, settings);
  };
  WithThreads(
    [&]() { vtkSMPTools::For(0, static_cast<vtkIdType>(particles.Count), JOB_SIZE, work); },
    settings.Threads);
}
}
