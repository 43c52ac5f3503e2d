// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A colour for streaks that can be told from the medium around them. Plain C++17.
#ifndef nephoscope_ContrastingColor_h
#define nephoscope_ContrastingColor_h

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace nephoscope
{
using StreakColor = std::array<double, 3>; // red, green and blue, 0 to 1

// Distance in RGB to the nearest of other colours; infinite without any.
inline double DistanceToNearest(const StreakColor& color, const std::vector<StreakColor>& others)
{
  double least = std::numeric_limits<double>::infinity();
  for (const StreakColor& other : others)
  {
    least =
      std::min(least, std::hypot(color[0] - other[0], color[1] - other[1], color[2] - other[2]));
  }
  return least;
}

inline StreakColor FarthestFrom(
  const std::vector<StreakColor>& others, const std::vector<StreakColor>& choices)
{
  return *std::max_element(
    choices.begin(), choices.end(), [&](const StreakColor& a, const StreakColor& b) {
      return DistanceToNearest(a, others) < DistanceToNearest(b, others);
    });
}

inline StreakColor MeanColor(const std::vector<StreakColor>& colors)
{
  StreakColor mean{};
  for (const StreakColor& color : colors)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      mean[c] += color[c] / static_cast<double>(colors.size());
    }
  }
  return mean;
}

// Those of the choices that are far enough from all backgrounds; all, if none is.
inline std::vector<StreakColor> ReadableOn(
  const std::vector<StreakColor>& backgrounds, std::vector<StreakColor> choices)
{
  constexpr double readable = 0.7; // thin streaks: black on ParaView's blue-grey is nearer
  const auto isDim = [&](const StreakColor& choice) {
    return DistanceToNearest(choice, backgrounds) < readable;
  };
  if (!std::all_of(choices.begin(), choices.end(), isDim))
  {
    choices.erase(std::remove_if(choices.begin(), choices.end(), isDim), choices.end());
  }
  return choices;
}

// Black, white or orange: the one that contrasts best with the backgrounds (two at the ends of a
// gradient) and the mean of `medium`, its colours. If the medium has that colour somewhere, the one
// farthest from all its colours; if this is near one of them too, also green, magenta, cyan and
// yellow are candidates.
// Colours that cannot be read on a background are no candidates.
inline StreakColor ContrastingColor(
  const std::vector<StreakColor>& backgrounds, const std::vector<StreakColor>& medium)
{
  constexpr double near = 0.35; // a colour from which streaks are hardly told
  const std::vector<StreakColor> all = { { { 0, 0, 0 } }, { { 1, 1, 1 } },
    { { 1, 69.0 / 255.0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 1 } }, { { 0, 1, 1 } },
    { { 1, 1, 0 } } };
  const std::vector<StreakColor> usual = ReadableOn(backgrounds, { all[0], all[1], all[2] });
  const std::vector<StreakColor> louder = ReadableOn(backgrounds, all);
  std::vector<StreakColor> everywhere = medium, together = backgrounds;
  everywhere.insert(everywhere.end(), backgrounds.begin(), backgrounds.end());
  together.push_back(MeanColor(medium));
  for (const StreakColor& choice :
    { FarthestFrom(together, usual), FarthestFrom(everywhere, usual) })
  {
    if (DistanceToNearest(choice, everywhere) >= near)
    {
      return choice;
    }
  }
  return FarthestFrom(everywhere, louder);
}
}

#endif
