// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Table of 1 - exp(-u), in which the opacity of an optical depth u may be looked up
 * (SteinBeckerMax1994).
 */
#ifndef nephoscope_OpacityTable_h
#define nephoscope_OpacityTable_h

#include <cmath>
#include <vector>

namespace nephoscope
{

/**
 * Default size of the table: its error is (16 / 1023)^2 / 8 = 3.1e-5 per cell, and 1.1e-7 beyond
 * its end.
 */
constexpr int opacityTableEntries = 1024;
constexpr double opacityTableEnd = 16;

/** 1 - exp(-u) at equal steps of u from 0 to `end`. */
inline std::vector<float> MakeOpacityTable(
  int entries = opacityTableEntries, double end = opacityTableEnd)
{
  std::vector<float> table;
  for (int i = 0; i < entries; ++i)
  {
    table.push_back(static_cast<float>(-std::expm1(-end * i / (entries - 1))));
  }
  return table;
}

} // namespace nephoscope

#endif
