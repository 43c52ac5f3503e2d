// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// When layers of smoke are released beside the regular ones: where the smoke
// that leaves the polygon turns, a layer for a whole time step would cut its
// corners.
#ifndef nephoscope_LayerTimes_h
#define nephoscope_LayerTimes_h

#include "PolygonFlow.h"
#include "TurningPaths.h"

namespace nephoscope
{
struct LayerTimes
{
  double Regular = 0.0;  // s, of the last regular release
  double Part = 0.0;     // s, of a time step: layers are released at whole parts
                         // after Regular
  double Released = 0.0; // s, when the front was
  double Now = 0.0;
  double End = 0.0; // s, up to which the velocity is known
  double Rounding = 0.0;
};

// The latest time up to which the smoke between the polygon and its front turns
// by no more than an angle: End, if it does not turn before. Not the time at
// which the front was released.
double TimeOfNextLayer(const VelocityField& field, const PolygonMesh& polygon,
  const StreakMesh& smoke, const IntegrationSettings& integration, const LayerTimes& times,
  double angle);
}

#endif
