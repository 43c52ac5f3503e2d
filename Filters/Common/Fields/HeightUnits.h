// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The units of a height array: from the file, otherwise from a comparison with the standard
// atmosphere. Plain C++17.
#ifndef nephoscope_HeightUnits_h
#define nephoscope_HeightUnits_h

#include "LowerCase.h"
#include "StandardAtmosphere.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace nephoscope
{
enum class HeightUnits
{
  Automatic,
  Metre,
  Kilometre,
  Geopotential, // m2 s-2
  Decametre     // by the units of the file only
};

inline double MetresPer(HeightUnits units)
{
  switch (units)
  {
    case HeightUnits::Kilometre:
      return 1000.0;
    case HeightUnits::Geopotential:
      return 1.0 / atmosphere::GRAVITY;
    case HeightUnits::Decametre:
      return 10.0;
    default:
      return 1.0;
  }
}

// A file's word for a unit without blanks, dots, stars and carets, in small letters: "m**2 s**-2"
// is "m2s-2".
inline std::string PlainUnits(std::string text)
{
  text.erase(std::remove_if(text.begin(), text.end(),
               [](unsigned char c) { return std::isspace(c) || c == '*' || c == '^' || c == '.'; }),
    text.end());
  return LowerCase(text);
}

// `text` from PlainUnits. Automatic if the file gives no known unit.
inline HeightUnits HeightUnitsOf(const std::string& text)
{
  for (const char* word : { "m2s-2", "m2/s2", "s-2m2", "jkg-1", "j/kg" })
  {
    if (text == word)
    {
      return HeightUnits::Geopotential;
    }
  }
  for (const char* word : { "m", "gpm", "metre", "metres", "meter", "meters" })
  {
    if (text == word)
    {
      return HeightUnits::Metre;
    }
  }
  if (text == "dam" || text == "gpdam")
  {
    return HeightUnits::Decametre;
  }
  return text == "km" || text == "gpkm" ? HeightUnits::Kilometre : HeightUnits::Automatic;
}

// True if heights that are `ratio` times those of the standard atmosphere, on average, may be of
// this unit. Weather and terrain change them by less than a third, and the next unit is ten times
// larger.
inline bool RatioFits(double ratio, HeightUnits units)
{
  const double inMetres = ratio * MetresPer(units);
  return inMetres > 1.0 / 3.0 && inMetres < 3.0;
}

// The unit by that ratio. Automatic if none fits.
inline HeightUnits GuessHeightUnits(double ratio)
{
  for (const HeightUnits units : { HeightUnits::Metre, HeightUnits::Geopotential,
         HeightUnits::Kilometre, HeightUnits::Decametre })
  {
    if (RatioFits(ratio, units))
    {
      return units;
    }
  }
  return HeightUnits::Automatic;
}
}

#endif
