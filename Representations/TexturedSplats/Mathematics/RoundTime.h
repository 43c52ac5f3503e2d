// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Times and lengths that are easy to read. Plain C++17.
#ifndef nephoscope_RoundTime_h
#define nephoscope_RoundTime_h

#include <cmath>

namespace nephoscope
{
// The greatest of 1, 2 and 5, times a power of ten, that is not above a positive number; 0 for
// others.
inline double RoundDown(double number)
{
  if (!(number > 0.0) || !std::isfinite(number))
  {
    return 0.0;
  }
  const double ten = std::pow(10.0, std::floor(std::log10(number) + 1e-9));
  const double digit = number / ten * (1.0 + 1e-9);
  return ten * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

// The same for seconds: whole parts of minutes, hours and days above one second.
inline double RoundDownTime(double seconds)
{
  constexpr double minute = 60.0, hour = 3600.0, day = 86400.0;
  constexpr double round[] = { 12 * hour, 6 * hour, 3 * hour, 2 * hour, hour, 30 * minute,
    20 * minute, 10 * minute, 5 * minute, 2 * minute, minute, 30.0, 20.0, 10.0 };
  if (seconds >= day)
  {
    return day * RoundDown(seconds / day);
  }
  for (const double time : round)
  {
    if (seconds >= time)
    {
      return time;
    }
  }
  return RoundDown(seconds);
}
}

#endif
