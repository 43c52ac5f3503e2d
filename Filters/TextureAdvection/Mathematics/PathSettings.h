// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How paths are integrated. Plain C++17.
#ifndef nephoscope_PathSettings_h
#define nephoscope_PathSettings_h

namespace nephoscope
{
enum class PathMethod
{
  Euler,       // as MaxCrawfisBecker1993
  RungeKutta4, // fixed steps
  Adaptive     // of order 5 with error control
};

struct PathSettings
{
  PathMethod Method = PathMethod::RungeKutta4;
  double TimeStep =
    3600.0; // seconds; steps are this long or shorter, so that they end at the times of the series
  double Tolerance = 1e-6; // adaptive: error of a sub-step, radians on a globe, else a length
  double LevelScale = 0.0; // adaptive, on a globe: radians per unit of the vertical coordinate
};
}

#endif
