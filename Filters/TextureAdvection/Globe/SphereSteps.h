// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Steps of motion on the unit sphere, as Cartesian vectors: the same at the poles as anywhere,
// which steps in longitude and latitude are not. Plain C++17.
//
// A state is a direction and a vertical coordinate. `motion(state, fraction)` returns their rates
// at that fraction of the step; stages of a step are a little off the sphere, and the rate of the
// direction is then to be proportional to its length. At fraction 0 it may move the level, to hold
// it above the ground.
#ifndef nephoscope_SphereSteps_h
#define nephoscope_SphereSteps_h

#include "RungeKuttaTables.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
struct SphereRates
{
  double Direction[3];
  double Rise;
};

struct SphereState
{
  double Direction[3];
  double Level;
};

inline double LengthOf(const double v[3])
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

inline void Normalize(double v[3])
{
  const double length = LengthOf(v);
  for (int c = 0; c < 3 && length > 0.0; ++c)
  {
    v[c] /= length;
  }
}

// Along the great circle that the velocity points to.
template <typename Motion>
SphereState EulerStep(SphereState start, double step, const Motion& motion)
{
  const SphereRates rates = motion(start, 0.0);
  const double speed = LengthOf(rates.Direction);
  SphereState end = start;
  end.Level += step * rates.Rise;
  if (speed > 0.0)
  {
    const double angle = speed * step;
    for (int c = 0; c < 3; ++c)
    {
      end.Direction[c] =
        std::cos(angle) * start.Direction[c] + std::sin(angle) * rates.Direction[c] / speed;
    }
    Normalize(end.Direction);
  }
  return end;
}

// start + step * (weighted sum of the rates of `count` stages)
inline SphereState MovedBy(
  const SphereState& start, double step, const SphereRates* rates, const double* weights, int count)
{
  SphereState end = start;
  for (int s = 0; s < count; ++s)
  {
    const double fraction = step * weights[s];
    for (int c = 0; c < 3; ++c)
    {
      end.Direction[c] += fraction * rates[s].Direction[c];
    }
    end.Level += fraction * rates[s].Rise;
  }
  return end;
}

template <typename Motion>
SphereState RungeKutta4Step(SphereState start, double step, const Motion& motion)
{
  SphereRates rates[4];
  rates[0] = motion(start, 0.0);
  for (int s = 1; s < 4; ++s)
  {
    SphereState probe = MovedBy(start, step, rates, RungeKutta4::Stages[s], s);
    rates[s] = motion(probe, RungeKutta4::Fractions[s]);
  }
  SphereState end = MovedBy(start, step, rates, RungeKutta4::Weights, 4);
  Normalize(end.Direction);
  return end;
}

// DormandPrince1980 in sub-steps whose estimated error, an angle in radians, is at most
// `tolerance`; `levelScale` turns an error of the level into one. No sub-step goes further than
// `longestWay`, an angle too: the motion has kinks at the edges of cells, which the estimate does
// not see from afar.
template <typename Motion>
SphereState AdaptiveStep(SphereState start, double step, double tolerance, double levelScale,
  double longestWay, const Motion& motion)
{
  using Table = DormandPrince54;
  constexpr int mostSubSteps = 10000;
  SphereState now = start;
  double done = 0.0; // fraction of the step
  double wanted = 1.0;
  for (int n = 0; n < mostSubSteps && done < 1.0; ++n)
  {
    SphereRates rates[Table::StageCount];
    rates[0] = motion(now, done);
    const double way = LengthOf(rates[0].Direction) * std::abs(step);
    double fraction = std::min(wanted, way > longestWay ? longestWay / way : 1.0);
    fraction = fraction > 0.999 * (1.0 - done) ? 1.0 - done : fraction;
    SphereState end = now;
    for (int s = 1; s < Table::StageCount; ++s)
    {
      end = MovedBy(now, fraction * step, rates, Table::Stages[s], s);
      rates[s] = motion(end, done + Table::Fractions[s] * fraction);
    }
    const SphereState zero = { { 0.0, 0.0, 0.0 }, 0.0 };
    const SphereState errors =
      MovedBy(zero, fraction * step, rates, Table::Errors, Table::StageCount);
    const double error = std::hypot(LengthOf(errors.Direction), levelScale * errors.Level);
    const double factor =
      std::clamp(0.9 * std::pow(tolerance / std::max(error, 1e-300), 0.2), 0.2, 5.0);
    wanted = factor * fraction;
    if (error <= tolerance || n + 1 == mostSubSteps || fraction < 1e-6)
    {
      now = end; // the last stage is at the end of the sub-step
      Normalize(now.Direction);
      done = fraction >= 1.0 - done ? 1.0 : done + fraction;
    }
  }
  return now;
}
}

#endif
