// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The holes at the poles of grids that have no row there: Gaussian grids, rows half a spacing off,
// cell centres.
#ifndef nephoscope_PoleRows_h
#define nephoscope_PoleRows_h

#include "GridOrder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

class vtkDataSetAttributes;

namespace nephoscope
{
class LonLatLevelGrid;

// True if a row at latitude `outer` (degrees) is the last before a pole: the next row towards the
// equator is at `next`, and one more spacing would reach the pole. The gap of a Gaussian grid is
// 0.77 of a spacing, that of rows half a spacing off is 0.5, and 1 if only the row at the pole is
// missing. A gap over 20 degrees is no hole.
inline bool IsLastRing(double outer, double next)
{
  const double gap = 90.0 - std::abs(outer);
  return outer * (outer - next) > 0.0 && gap > 0.0 &&
    gap <= std::min(1.05 * std::abs(outer - next), 20.0);
}

// The distinct columns of a grid round the globe: a closed one has its first column twice.
inline int DistinctColumns(const GridOrder& order)
{
  return order.Period > 0 ? order.Period : order.OutputDimensions[0];
}

// The mean of floating-point values, the lower median of others (codes, counts), which is one of
// them. `values` is not empty and is sorted for the median.
inline double RingValue(std::vector<double>& values, bool floating)
{
  if (!floating)
  {
    const auto middle = values.begin() + (values.size() - 1) / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

// Whether rows are missing at the south and at the north end of `grid`. `coverage` must be round
// the globe.
std::array<bool, 2> MissingPoles(const LonLatLevelGrid& grid);

// Gives the points of the added rows in the extent the mean of the last ring, missing values left
// out. Arrays of several components are taken as Cartesian.
void FillPoleRows(const LonLatLevelGrid& grid, const GridOrder& order, const int extent[6],
  vtkDataSetAttributes* output);
}

#endif
