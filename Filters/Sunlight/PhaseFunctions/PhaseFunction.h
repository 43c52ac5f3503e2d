// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Phase functions, normalized so that their mean over the sphere is 1, and the scaling that takes
// their forward peak away. Plain C++17.
#ifndef nephoscope_PhaseFunction_h
#define nephoscope_PhaseFunction_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{
// HenyeyGreenstein1941: `cosine` is that of the angle between the directions in which light goes
// before and after.
template <typename Real>
Real HenyeyGreenstein(Real asymmetry, Real cosine)
{
  const Real d = 1 + asymmetry * asymmetry - 2 * asymmetry * cosine;
  return (1 - asymmetry * asymmetry) / (d * std::sqrt(d));
}

struct ScaledMedium
{
  double Extinction, Albedo;
  double Asymmetry, Second; ///< Legendre coefficients of its phase function
};

/** That of a Henyey-Greenstein function, for light of a second moment 1. */
template <typename Number>
inline Number SecondMomentFactor(Number asymmetry)
{
  return 5 * asymmetry * asymmetry;
}

/** The Legendre polynomial P2. */
template <typename Number>
inline Number SecondLegendre(Number x)
{
  return (3 * x * x - 1) / 2;
}

/**
 * Without the share `forward` of the scattered light, which goes straight on and is taken as not
 * scattered (Wiscombe1977).
 */
inline ScaledMedium Scaled(double extinction, double albedo, double asymmetry, double forward)
{
  const double rest = 1 - forward;
  return { (1 - albedo * forward) * extinction, rest * albedo / (1 - albedo * forward),
    (asymmetry - forward) / rest, (asymmetry * asymmetry - forward) / rest };
}

/** JosephWiscombeWeinman1976: the share is g^2. */
inline ScaledMedium Scaled(double extinction, double albedo, double asymmetry)
{
  return Scaled(extinction, albedo, asymmetry, asymmetry * asymmetry);
}

/** The phase function of two Legendre coefficients, not below 0. */
inline float PhaseOfTwo(float first, float second, float cosine)
{
  return std::max(1 + 3 * first * cosine + 5 * second * SecondLegendre(cosine), 0.0f);
}

/**
 * The phase function for light that has been scattered into the forward peak before (README.md).
 * `forward` is the fraction in that peak. The result is the mean of two functions:
 * `smooth`, that of the scaled medium, and the one that makes double scattering exact. `once` and
 * `twice` are the phase functions of light scattered once and twice;
 * `smoothTwice` is that of two scatterings in the scaled medium.
 */
inline double AfterForwardScattering(
  double once, double twice, double smooth, double smoothTwice, double forward)
{
  const double rest = 1 - forward;
  const double exact = forward < 1e-6
    ? smooth
    : (twice - forward * once - rest * rest * smoothTwice) / (forward * rest);
  return 0.5 * (smooth + std::max(exact, 0.0));
}

/**
 * The same for a Henyey-Greenstein function. For light scattered twice, the asymmetry parameter is
 * squared.
 */
inline double AfterForwardScattering(double asymmetry, double cosine)
{
  const double forward = asymmetry * asymmetry, scaled = asymmetry / (1 + asymmetry);
  return AfterForwardScattering(HenyeyGreenstein(asymmetry, cosine),
    HenyeyGreenstein(forward, cosine), HenyeyGreenstein(scaled, cosine),
    HenyeyGreenstein(scaled * scaled, cosine), forward);
}
}

#endif
