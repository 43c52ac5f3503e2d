// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Integrals along a column of points, bottom to top or top to bottom. Plain C++17.
#ifndef nephoscope_CloudColumn_h
#define nephoscope_CloudColumn_h

#include "StandardAtmosphere.h"

#include <cmath>
#include <vector>

namespace nephoscope
{
namespace column
{
// Optical depth from each point to the last one: trapezoids over lengths[i] between the points i
// and i + 1.
inline std::vector<double> OpticalDepthToEnd(
  const std::vector<double>& extinction, const std::vector<double>& lengths)
{
  std::vector<double> depth(extinction.size(), 0.0);
  for (std::size_t i = lengths.size(); i-- > 0;)
  {
    depth[i] = depth[i + 1] + 0.5 * (extinction[i] + extinction[i + 1]) * lengths[i];
  }
  return depth;
}

// Pressure in hydrostatic balance with the temperatures of the column, from that of the standard
// atmosphere at its lowest point. Without temperatures: the standard atmosphere.
inline std::vector<double> Pressures(
  const std::vector<double>& heights, const std::vector<double>& temperatures)
{
  std::vector<double> pressures(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const bool balanced = i > 0 && !temperatures.empty();
    const double mean = balanced ? 0.5 * (temperatures[i - 1] + temperatures[i]) : 0.0;
    pressures[i] = balanced && mean > 0 ? pressures[i - 1] *
        std::exp(-atmosphere::GRAVITY * (heights[i] - heights[i - 1]) /
          (atmosphere::DRY_AIR_CONSTANT * mean))
                                        : atmosphere::Pressure(heights[i]);
  }
  return pressures;
}
}
}

#endif
