// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Phase functions, normalized so that their mean over the sphere is 1, and the scaling that takes their forward peak away. Plain C++17.
#ifndef nephoscope_PhaseFunction_h
#define nephoscope_PhaseFunction_h

#include <cmath>

namespace nephoscope
{
// HenyeyGreenstein1941: `cosine` is that of the angle between the directions in which light goes before and after.
template <typename Real>
Real henyeyGreenstein(Real asymmetry, Real cosine)
{
  const Real d = 1 + asymmetry * asymmetry - 2 * asymmetry * cosine;
  return (1 - asymmetry * asymmetry) / (d * std::sqrt(d));
}

// JosephWiscombeWeinman1976: the share g^2 of the scattered light goes straight on, and is taken as not scattered.
struct ScaledMedium
{
  double Extinction, Albedo, Asymmetry;
};

inline ScaledMedium scaled(double extinction, double albedo, double asymmetry)
{
  const double forward = asymmetry * asymmetry;
  return { (1 - albedo * forward) * extinction, (1 - forward) * albedo / (1 - albedo * forward),
    asymmetry / (1 + asymmetry) };
}
}

#endif
