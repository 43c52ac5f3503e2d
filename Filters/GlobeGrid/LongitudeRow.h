// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A row of longitudes: unwrapped, and judged regional, open round the globe, or closed. Plain
// C++17.
#ifndef nephoscope_LongitudeRow_h
#define nephoscope_LongitudeRow_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephoscope
{
enum class Coverage
{
  Regional, // never closed
  Open,     // one spacing is missing between the last column and the first
  Closed,   // the last column is the first one again
  Overlap   // more than one turn
};

// Takes whole turns off the jumps: 170, 175, -180, -175 becomes 170, 175, 180, 185.
inline void UnwrapLongitudes(std::vector<double>& degrees)
{
  for (size_t i = 1; i < degrees.size(); ++i)
  {
    degrees[i] = degrees[i - 1] + std::remainder(degrees[i] - degrees[i - 1], 360.0);
  }
}

// `degrees` unwrapped, in either order. The grid is global if the gap that is left is at most half
// again as wide as the widest spacing.
inline Coverage JudgeCoverage(const std::vector<double>& degrees)
{
  if (degrees.size() < 3)
  {
    return Coverage::Regional;
  }
  double widest = 0.0;
  for (size_t i = 1; i < degrees.size(); ++i)
  {
    widest = std::max(widest, std::abs(degrees[i] - degrees[i - 1]));
  }
  const double gap = 360.0 - std::abs(degrees.back() - degrees.front());
  const double tolerance = 0.01 * widest; // single-precision longitudes, rounded spacings
  if (std::abs(gap) <= tolerance)
  {
    return Coverage::Closed;
  }
  if (gap < 0.0)
  {
    return Coverage::Overlap;
  }
  return gap <= 1.5 * widest ? Coverage::Open : Coverage::Regional;
}
}

#endif
