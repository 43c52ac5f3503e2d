// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Particles moved by as many threads as the field allows.
#ifndef nephoscope_AdvanceParticles_h
#define nephoscope_AdvanceParticles_h

#include "Particles.h"
#include "vtkNephoscopeFiltersVelocityFieldModule.h" // for export macro

namespace nephoscope
{
// Moves the particles from `time` to `time + step`. A local field is sampled by threads, in small
// batches; another one by this thread, with all particles in every batch. The result does not
// depend on the number of threads.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT void AdvanceParticles(const VelocityField& field,
  const Particles& particles, double time, double step, const IntegrationSettings& settings = {});
}

#endif
