// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One pass of the filter with weights 1 : 2 : 1 along one axis, as an exchange between neighbours.
// Plain C++17.
//
// Three passes, one along each axis, give the 3 x 3 x 3 filter of MaxCrawfisBecker1993, Sec. 4:
// weights 8 (centre), 4 (face), 2 (edge), 1 (corner), over 64. A wave of N points along an axis is
// multiplied by cos^2(pi/N).
//
// Written as an exchange the filter holds for unequal masses m, at ends and beside missing data
// too:
//
//     f += (k(m, a)(fa - f) + k(m, b)(fb - f))/m,   k(m, n) = min(m, n)/4
//
// - What one point gains its neighbour loses: sum m f stays, to rounding.
// - A constant stays exactly. No weight is negative (that of f is 1/2 or more): no value leaves the
//   range of its neighbours.
// - Equal masses: (fa + 2 f + fb)/4. An end has no neighbour outside, so its weights are 3 : 1.
//   Missing points have mass 0.
#ifndef nephoscope_SmoothingKernel_h
#define nephoscope_SmoothingKernel_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{
// What flows into a point of value f and mass m from a neighbour. Antisymmetric, bit by bit.
inline double Exchange(double f, double m, double neighbor, double neighborMass)
{
  const double shared = std::min(m, neighborMass);
  return shared > 0.0 ? 0.25 * shared * (neighbor - f) : 0.0;
}

// `strength`, 0 to 1: 1 is the filter 1 : 2 : 1, less is weaker.
inline double SmoothedValue(double f, double m, double before, double massBefore, double after,
  double massAfter, double strength = 1.0)
{
  if (!(m > 0.0))
  {
    return f;
  }
  return f + strength * (Exchange(f, m, before, massBefore) + Exchange(f, m, after, massAfter)) / m;
}

// Repeated passes that make a filter of `ratio` times the variance of one pass: so many, each so
// strong. Near a pole the step along the ring is short, and the ratio is (step across / step
// along)^2. Beyond (points of the ring)^2 passes the ring is a constant.
struct RepeatedPass
{
  int Count = 1;
  double Strength = 1.0;
};

inline RepeatedPass PassesFor(double ratio, int pointsOfRing)
{
  const double most = static_cast<double>(pointsOfRing) * pointsOfRing;
  if (!(ratio > 0.0))
  {
    return { 0, 0.0 };
  }
  const double bounded = std::min(ratio, most);
  const int count = std::max(1, static_cast<int>(std::ceil(bounded - 1e-9)));
  return { count, std::min(1.0, bounded / count) };
}
}

#endif
