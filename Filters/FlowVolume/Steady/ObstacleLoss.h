// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which of the smoke that has ended met an obstacle inside the data, and which has left them. Plain
// C++17.
#ifndef nephoscope_ObstacleLoss_h
#define nephoscope_ObstacleLoss_h

#include "VelocityField.h"

#include <array>
#include <vector>

namespace nephoscope
{
// A triangle of the front that has ended.
struct EndedSmoke
{
  std::array<Vector3, 3>
    Corners; // before the step; a corner on a divided edge may lie in an obstacle
  std::array<bool, 3> Leaves = {}; // which of them the step leads out of the data
  bool AtObstacle = false;         // known to have met one
  double Step = 0.0;               // s
  double Mass = 0.0;               // that it would still have carried
};

// The mass of the smoke that ended at obstacles. Straight ahead of it, farther than the step could
// lead, there are data again, within the length `farthest`; ahead of smoke that has left the data
// through their outer boundary there are none.
double MassAtObstacles(
  const VelocityField& field, double time, double farthest, const std::vector<EndedSmoke>& ended);
}

#endif
