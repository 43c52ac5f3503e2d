// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What very many splats cost. Plain C++17.
#ifndef nephoscope_SplatCost_h
#define nephoscope_SplatCost_h

#include <iomanip>
#include <sstream>
#include <string>

namespace nephoscope
{
constexpr long long manySplats = 4000000;
// At most, while the first picture is made: Documentation/textured-splats.md, "Growth".
constexpr double bytesOfSplat = 250;

// Memory and time of all samples as splats, and what to do about it; empty where there are not
// many.
inline std::string TellSplatCost(long long samples)
{
  if (samples < manySplats)
  {
    return std::string();
  }
  std::ostringstream text;
  text
    << std::fixed << std::setprecision(1) << static_cast<double>(samples) / 1e6
    << " million splats take about " << static_cast<double>(samples) * bytesOfSplat / 1e9
    << " GB of memory, and without a graphics card many seconds for each picture. For less time set ErrorTolerance to 0.3, so that blocks of "
       "samples are drawn as one splat each; for less memory draw every second sample.";
  return text.str();
}
}

#endif
