// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The meaning of a level axis, and the height and pressure of its levels. Plain C++17.
#ifndef nephoscope_LevelAxis_h
#define nephoscope_LevelAxis_h

#include "StandardAtmosphere.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephoscope
{
enum class LevelUnits
{
  Automatic,
  Hectopascal,
  Pascal,
  Metre,
  Kilometre,
  Sigma, // or hybrid: from about 1 at the ground to 0; found by Automatic only
  Index  // numbers of levels, taken as metres; found by Automatic only
};

// How a height array, where there is one, runs along the level axis.
enum class HeightTrend
{
  Unknown,
  GrowsWithLevel,
  FallsWithLevel
};

// True for 0 or 1, 2, 3, ... in either order, with the sign of an axis that points down or without
// it.
inline bool AreIndices(const std::vector<double>& levels)
{
  const double first = std::min(std::abs(levels.front()), std::abs(levels.back()));
  if (levels.size() < 4 || !(first == 0.0 || first == 1.0))
  {
    return false;
  }
  for (size_t k = 1; k < levels.size(); ++k)
  {
    if (std::abs(levels[k] - levels[k - 1]) != 1.0)
    {
      return false;
    }
  }
  return true;
}

// True if the largest pressure of an axis is that of the air not far from the ground.
inline bool EndsNearGround(LevelUnits units, double largest)
{
  const double hectopascal = units == LevelUnits::Pascal ? 0.01 * largest : largest;
  return hectopascal >= 500.0 && hectopascal <= 1100.0;
}

// Pressure by its range; a negative axis is a pressure that the reader negated since it points
// down.
inline LevelUnits GuessLevelUnits(double lowest, double highest, HeightTrend trend)
{
  const bool negated = highest < 0.0;
  const double largest = negated ? -lowest : highest;
  const bool fallsAloft =
    negated ? trend != HeightTrend::FallsWithLevel : trend != HeightTrend::GrowsWithLevel;
  const bool positive = negated || lowest > 0.0;
  if (positive && fallsAloft)
  {
    const bool certain = negated || trend == HeightTrend::FallsWithLevel;
    if (certain && largest >= 0.9 && largest <= 1.1)
    {
      return LevelUnits::Sigma;
    }
    if ((largest >= 500.0 && largest <= 1100.0) || (certain && largest < 500.0))
    {
      return LevelUnits::Hectopascal;
    }
    if ((largest >= 50000.0 && largest <= 110000.0) || (certain && largest > 1100.0))
    {
      return LevelUnits::Pascal;
    }
  }
  return LevelUnits::Metre;
}

inline bool IsPressure(LevelUnits units)
{
  return units == LevelUnits::Hectopascal || units == LevelUnits::Pascal;
}

// Pascals; only where IsPressure(units).
inline double LevelPressure(LevelUnits units, double level)
{
  return std::abs(level) * (units == LevelUnits::Hectopascal ? 100.0 : 1.0);
}

// Metres. Pressures are held above 0.01 Pa (85 km), so that a top level of zero has a height. The
// pressure on a sigma or hybrid level depends on the place; here the ground is taken to be at the
// standard atmosphere's 1013.25 hPa.
inline double LevelHeight(LevelUnits units, double level)
{
  if (units == LevelUnits::Sigma)
  {
    return atmosphere::HeightFromPressure(std::max(std::abs(level) * 101325.0, 0.01));
  }
  if (IsPressure(units))
  {
    return atmosphere::HeightFromPressure(std::max(LevelPressure(units, level), 0.01));
  }
  return units == LevelUnits::Kilometre ? 1000.0 * level : level;
}
}

#endif
