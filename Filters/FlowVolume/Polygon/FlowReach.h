// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How far smoke from a position would travel, by short traces of a steady flow.
#ifndef nephoscope_FlowReach_h
#define nephoscope_FlowReach_h

#include "VelocityField.h"

#include <vector>

namespace nephoscope
{
// For each place, 0 to 1: what part of `length` the flow goes from there before it leaves the data
// or stands still, within the time that it takes for the length at its first speed; times the
// extent of that path, as far as it is less than a quarter of `length` (a path may go round in a
// small circle). All positions are traced together.
std::vector<double> FlowReaches(
  const VelocityField& field, const std::vector<Vector3>& places, double length);
}

#endif
