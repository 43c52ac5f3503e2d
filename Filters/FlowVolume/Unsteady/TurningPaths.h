// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Points of moving smoke whose paths turn are moved in shorter steps than the
// others.
#ifndef nephoscope_TurningPaths_h
#define nephoscope_TurningPaths_h

#include "Particles.h"
#include "StreakMesh.h"

namespace nephoscope
{
struct TurnLimits
{
  double Angle = 0.0; // radians that a path may turn in a step; 0: any
  int Halvings = 0;   // of a step, at most
};

// Whether the tangent of a curve turns by more than `angle` over a step: `way`
// is the one before, of a step of `before` seconds, or the tangent itself (0),
// and `chord` that of `step`. One of them may be zero, and says nothing.
bool TurnsTooMuch(
  const Vector3& way, double before, const Vector3& chord, double step, double angle);

// Moves all points by a step of time. Those whose path turns too much do it
// again in two parts, then in four and so on.
void AdvanceSmoke(const VelocityField& field, StreakMesh& smoke, double time, double step,
  const IntegrationSettings& integration, const TurnLimits& limits);
}

#endif
