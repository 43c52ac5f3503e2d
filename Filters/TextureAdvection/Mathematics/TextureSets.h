// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The two sets of texture coordinates: when they are born, how old they are, how much they weigh
// (MaxCrawfisBecker1993 Sec. 5). Plain C++17.
#ifndef nephoscope_TextureSets_h
#define nephoscope_TextureSets_h

#include <cmath>

namespace nephoscope
{
constexpr int TEXTURE_SETS = 2;

// Times in seconds. Set 0 is born at Start and every Period before and after it, set 1 half a
// period later.
struct TextureSets
{
  double Start = 0.0;
  double Period = 86400.0;
  bool FromGrid = false; // at Start the air stands still before: coordinates of both sets start
                         // there, weights do not change

  // The birth of the set that is alive at a time; a time of birth, up to rounding, is of the new
  // life.
  double Birth(int set, double time) const
  {
    const double first = this->Start + (set == 0 ? 0.0 : 0.5 * this->Period);
    const double lives = std::floor((time - first) / this->Period + 1e-12);
    return std::fmin(first + this->Period * lives, time);
  }

  double Age(int set, double time) const { return time - this->Birth(set, time); }

  // When the coordinates of a set were those of the grid: at its birth, or at Start if that is
  // later and they start from the grid.
  double Origin(int set, double time) const
  {
    const double birth = this->Birth(set, time);
    return this->FromGrid ? std::fmax(birth, std::fmin(this->Start, time)) : birth;
  }

  int Older(double time) const { return this->Age(0, time) >= this->Age(1, time) ? 0 : 1; }

  // A triangle: 0 at birth and death, 1 in the middle of life. That of set 1 is what is left to 1,
  // so that the two add up to 1 exactly, and a set that is born at this very time weighs exactly 0.
  double Weight(int set, double time) const
  {
    if (set == 1)
    {
      return this->Age(1, time) == 0.0 ? 0.0 : 1.0 - this->Weight(0, time);
    }
    return this->Age(1, time) == 0.0 ? 1.0 : Triangle(this->Age(0, time) / this->Period);
  }

  // `life`: age over period.
  static double Triangle(double life) { return 1.0 - std::abs(2.0 * life - 1.0); }
};

// The ages between which a set's coordinates are interpolated, if they are computed at multiples of
// an interval only.
struct KeyAges
{
  double First;
  double Second;
  double Weight; // of the second
};

// `interval` 0: the age itself. The last key age of a life is its end, so that nothing is
// interpolated across a birth.
inline KeyAges KeyAgesAround(double age, double interval, double period)
{
  if (!(interval > 0.0))
  {
    return { age, age, 0.0 };
  }
  // A key that is reached up to rounding is that key.
  double index = std::floor(age / interval + 1e-9);
  const double first = index * interval;
  const double second = std::fmin(first + interval, period);
  if (age <= first || second <= first)
  {
    return { first, first, 0.0 };
  }
  return { first, second, (age - first) / (second - first) };
}
}

#endif
