// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Diffuse light in a structured grid: discrete ordinates (DirectionSweep.h) in turn with the
 * balance of light (LightBalance.h), which makes them converge in few iterations and conserve
 * energy (diffusion synthetic acceleration, AdamsLarsen2002).
 *
 * Directions are relative to the grid's own axes at each point, so that on a globe they are east,
 * north and up everywhere; the curvature over one free path is neglected. The forward peak is
 * removed beforehand (PhaseFunction.h). Light of one sun is 1. Plain C++17.
 */
#ifndef nephoscope_DiffuseLight_h
#define nephoscope_DiffuseLight_h

#include "DirectionSet.h"
#include "LightBalance.h"
#include "LightGrid.h"

#include <functional>
#include <vector>

namespace nephoscope
{
struct LightSettings
{
  AngleCounts Angles{ 0, 0 };
  int MostIterations = 20;
  double Tolerance = 2e-3; ///< mean change of the fluence, as a fraction of its mean
};

struct DiffuseLight
{
  DiffuseField Field;
  std::vector<float> Absorption; ///< of direct and diffuse light, per volume
  int Iterations = 0;
  double Change = 0; ///< of the last iteration
};

/** `progress` gets the share that is done, and says whether to go on. */
DiffuseLight FindDiffuseLight(const LightGrid& grid, const LightSettings& settings,
  const Parallel& parallel, const std::function<bool(double)>& progress);
}

#endif
