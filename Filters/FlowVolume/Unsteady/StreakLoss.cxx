// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreakLoss.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr int positionsAhead = 32;
constexpr double nearest = 4.0; // steps ahead, so that a bent path does not count

// At the beginning or at the end of the time for which the field is given: velocities that are
// missing in one of two time steps are not the end of the data.
std::vector<unsigned char> InsideAtAnyTime(
  const VelocityField& field, const std::vector<Vector3>& positions)
{
  constexpr double ever = std::numeric_limits<double>::max();
  const std::size_t count = positions.size();
  std::vector<unsigned char> any(count, 0), inside(count, 0);
  for (const double time : { -ever, ever })
  {
    std::vector<Vector3> velocities(count);
    std::vector<CellHint> hints(count);
    field.Sample({ count, positions.data(), time, velocities.data(), inside.data(), hints.data() });
    std::transform(any.begin(), any.end(), inside.begin(), any.begin(), std::bit_or<>());
  }
  return any;
}
}

double StreakLoss::AtObstacles(
  const StreakMesh& smoke, const VelocityField& field, double step, double farthest) const
{
  std::vector<Vector3> ahead;
  std::vector<double> masses;
  for (const auto& ended : this->Masses)
  {
    const auto p = static_cast<std::size_t>(ended.first);
    const double length = Norm(smoke.Ways[p]); // where there is no velocity any more
    if (!(length > 0.0))
    {
      continue;
    }
    const double speed = smoke.Steps[p] > 0.0 ? length / smoke.Steps[p] : length;
    const double first = std::min(nearest * step * speed, farthest);
    for (int i = 0; i < positionsAhead; ++i)
    {
      const double along = first + (farthest - first) * i / (positionsAhead - 1);
      ahead.push_back(smoke.Positions[p] + (along / length) * smoke.Ways[p]);
    }
    masses.push_back(ended.second);
  }
  const std::vector<unsigned char> inside = InsideAtAnyTime(field, ahead);
  double sum = 0.0;
  for (std::size_t m = 0; m < masses.size(); ++m)
  {
    const auto begin = inside.begin() + static_cast<std::ptrdiff_t>(m) * positionsAhead;
    const bool met =
      std::any_of(begin, begin + positionsAhead, [](unsigned char is) { return is; });
    sum += met ? masses[m] : 0.0;
  }
  return sum;
}
}
