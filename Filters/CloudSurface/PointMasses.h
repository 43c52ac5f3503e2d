// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume that belongs to each point of a grid.
#ifndef nephoscope_PointMasses_h
#define nephoscope_PointMasses_h

#include "DualCells.h"
#include "GridTopology.h"

#include <array>
#include <functional>
#include <vector>

namespace nephoscope
{
// Product of the three widths; 0 for points that repeat others.
std::vector<double> ProductMasses(
  const GridTopology& topology, const std::array<std::vector<double>, 3>& widths);

// Sum of the octants of all cells at a point. `position(at)` is asked for stored points and for
// those one beyond the end of a ring.
// An axis of one point has thickness 1.
std::vector<double> OctantMasses(
  const GridTopology& topology, const std::function<Vector3(const GridIndex&)>& position);
}

#endif
