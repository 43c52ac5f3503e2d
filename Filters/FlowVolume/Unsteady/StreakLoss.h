// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which of the unsteady smoke that has ended met an obstacle inside the data, and which has left
// them. Plain C++17.
#ifndef nephoscope_StreakLoss_h
#define nephoscope_StreakLoss_h

#include "StreakMesh.h"

#include <algorithm>
#include <map>

namespace nephoscope
{
// Smoke that ended, at the points of it that have left the data.
class StreakLoss
{
public:
  // A tetrahedron or a prism with a corner outside, or without volume.
  template <typename Points>
  void Add(const StreakMesh& smoke, const Points& points, double mass)
  {
    const auto isOutside = [&](PointId id) { return !smoke.Inside[static_cast<std::size_t>(id)]; };
    this->Mass += mass;
    const auto count = std::count_if(points.begin(), points.end(), isOutside);
    for (const PointId id : points)
    {
      if (isOutside(id))
      {
        this->Masses[id] += mass / static_cast<double>(count);
      }
    }
  }

  double Total() const { return this->Mass; }

  // The mass that ended at obstacles. Straight ahead of it there are data again, within the length
  // `farthest`; ahead of smoke that has left the data through their outer boundary there are none.
  // `step`: s between two layers.
  double AtObstacles(
    const StreakMesh& smoke, const VelocityField& field, double step, double farthest) const;

private:
  double Mass = 0.0;
  std::map<PointId, double> Masses; // by point
};
}

#endif
