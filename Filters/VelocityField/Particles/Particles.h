// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Particles, and how they are to be moved. Plain C++17.
#ifndef nephoscope_Particles_h
#define nephoscope_Particles_h

#include "VelocityField.h"

namespace nephoscope
{
// Particles that share a time. `Inside` is 0 from the moment a particle has left the field: it
// keeps the position it had before the step in which it left, and is not looked at again.
struct Particles
{
  Vector3* Positions = nullptr;
  CellHint* Hints = nullptr;
  unsigned char* Inside = nullptr;
  std::size_t Count = 0;
  // Adaptive only, optional: the sub-step to begin with, left for the next call; 0: begin with the
  // whole step.
  double* SubSteps = nullptr;
};

enum class IntegrationMethod
{
  Euler,        // one step of first order
  RungeKutta4,  // one step
  DormandPrince // of order 5, in sub-steps that keep the estimated error of each below the
                // tolerance
};

struct IntegrationSettings
{
  IntegrationMethod Method = IntegrationMethod::RungeKutta4;
  double Tolerance = 1e-6; // adaptive only: error of a sub-step, a length, greater than 0
  int MaximumSubSteps =
    1000;          // adaptive only: a particle that needs more in one step is taken as outside
  int Threads = 0; // of AdvanceParticles; 0: VTK's number
};
}

#endif
