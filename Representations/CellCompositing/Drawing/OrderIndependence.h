// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a medium looks the same in whatever order its cells are composited.
 *
 * Cells of one source colour C with transmittances T1, T2, ... laid over each other give C (1 - T1
 * T2 ...) and alpha 1 - T1 T2 ..., and a product has no order (MaxCrawfisBecker1993, section 6:
 * smoke). It does not matter either whether the cells overlap in space: extinctions add up, and
 * transmittances multiply.
 */
#ifndef nephoscope_OrderIndependence_h
#define nephoscope_OrderIndependence_h

#include "TransferFunctionTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{

/** Collects colours, and says whether all of them are the same. */
class OneColor
{
public:
  /**
   * Colours that differ by less count as one: a sixteenth of an 8-bit step. VTK's colour spaces
   * leave as much between a colour and itself taken there and back.
   */
  static constexpr float Tolerance = 1.0f / 4096;

  void Add(const TransferFunctionTable::Value& color)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Low[c] = this->Empty ? color[c] : std::min(this->Low[c], color[c]);
      this->High[c] = this->Empty ? color[c] : std::max(this->High[c], color[c]);
      // False for what is not a number.
      this->Same =
        this->Same && color[c] - this->Low[c] <= Tolerance && this->High[c] - color[c] <= Tolerance;
    }
    this->Empty = false;
  }
  bool IsOne() const { return this->Same; }

private:
  std::array<float, 3> Low = {}, High = {};
  bool Empty = true, Same = true;
};

/**
 * Whether a table of colours, or of colours and opacities, has one colour for all scalars from low
 * to high that are not fully transparent. A table of colours alone is opaque throughout.
 */
inline bool IsOfOneColor(const TransferFunctionTable& table, float low, float high)
{
  OneColor colors;
  for (std::size_t k = table.FindInterval(low); k <= table.FindInterval(high); ++k)
  {
    const TransferFunctionTable::Interval& interval = table.Intervals[k];
    if (!(interval.Low[3] > 0) && !(interval.High[3] > 0))
    {
      continue;
    }
    // Where an interval reaches beyond low or high, only what lies between them counts.
    const bool first = k == table.FindInterval(low), last = k == table.FindInterval(high);
    colors.Add(first ? table.Evaluate(low) : interval.Low);
    colors.Add(last ? table.Evaluate(high) : interval.High);
  }
  return colors.IsOne();
}

} // namespace nephoscope

#endif
