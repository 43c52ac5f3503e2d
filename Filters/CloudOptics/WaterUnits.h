// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The units of a water array. Plain C++17.
#ifndef nephoscope_WaterUnits_h
#define nephoscope_WaterUnits_h

#include <initializer_list>
#include <string>

namespace nephoscope
{
enum class WaterUnits
{
  Automatic,
  MixingRatio,      // kg/kg
  MixingRatioGrams, // g/kg
  Content,          // kg/m3
  ContentGrams      // g/m3
};

inline bool IsMixingRatio(WaterUnits units)
{
  return units == WaterUnits::MixingRatio || units == WaterUnits::MixingRatioGrams;
}

inline double KilogramsPer(WaterUnits units)
{
  return units == WaterUnits::MixingRatioGrams || units == WaterUnits::ContentGrams ? 1e-3 : 1.0;
}

// `text` as PlainUnits makes it. Automatic: no known unit.
inline WaterUnits WaterUnitsOf(const std::string& text)
{
  const auto isOneOf = [&](std::initializer_list<const char*> words) {
    for (const char* word : words)
    {
      if (text == word)
      {
        return true;
      }
    }
    return false;
  };
  return isOneOf({ "kgkg-1", "kg/kg", "1", "kgkg**-1" }) ? WaterUnits::MixingRatio
    : isOneOf({ "gkg-1", "g/kg" })                       ? WaterUnits::MixingRatioGrams
    : isOneOf({ "kgm-3", "kg/m3" })                      ? WaterUnits::Content
    : isOneOf({ "gm-3", "g/m3" })                        ? WaterUnits::ContentGrams
                                                         : WaterUnits::Automatic;
}
}

#endif
