// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Winds in the units of a longitude-latitude-level grid. Plain C++17.
//
// The advection itself follows the position and the vertical coordinate of the air, and looks its level up; these are the
// equivalent rates of the indices, for grids that are to be followed in them, and for comparison.
#ifndef nephoscope_LevelMotion_h
#define nephoscope_LevelMotion_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{
constexpr double DEGREES_PER_RADIAN = 57.295779513082320877;
constexpr double SECONDS_PER_HOUR = 3600.0;

// Degrees of longitude an hour. u: eastward wind in m/s; radius in m. Infinite at the poles.
inline double LongitudeRate(double u, double radius, double cosineOfLatitude)
{
  return SECONDS_PER_HOUR * DEGREES_PER_RADIAN * u / (radius * cosineOfLatitude);
}

// Degrees of latitude an hour.
inline double LatitudeRate(double v, double radius)
{
  return SECONDS_PER_HOUR * DEGREES_PER_RADIAN * v / radius;
}

// Levels a second, for any vertical coordinate q that is known on the levels: q's rate following the air is
//   Dq/Dt = dq/dt|k + V . grad_k q + k' dq/dk,
// so k' = (Dq/Dt - dq/dt|k - V . grad_k q) / (dq/dk). With pressure, Dq/Dt is omega; with height, the upward wind. Only where
// the levels neither move nor slope is it Dq/Dt over dq/dk.
inline double LevelRate(
  double rateOfAir, double rateOnLevel, double windAlongGradientOnLevel, double perLevel)
{
  return (rateOfAir - rateOnLevel - windAlongGradientOnLevel) / perLevel;
}

// Hybrid levels: p = a + b ps. Rate and gradient on a level are b times those of the surface pressure.
inline double HybridLevelRate(
  double omega, double b, double surfaceRate, double windAlongSurfaceGradient, double perLevel)
{
  return LevelRate(omega, b * surfaceRate, b * windAlongSurfaceGradient, perLevel);
}

// Air does not leave through the ground or the top.
inline double HeldLevel(double level, int levels)
{
  return std::clamp(level, 0.0, static_cast<double>(std::max(levels - 1, 0)));
}
}

#endif
