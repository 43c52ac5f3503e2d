// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A number for every sample that is as good as random, and depends on nothing but its place: not on
// the order of the input, the frame, or the part of the data that a rank has, and not on rounding.
// Plain C++17.
#ifndef nephoscope_SplatSeed_h
#define nephoscope_SplatSeed_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace nephoscope
{
// The finalizer of splitmix64 (SteeleLeaFlood2014): every bit of the result depends on every bit of
// the argument.
inline std::uint64_t MixBits(std::uint64_t x)
{
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

inline std::uint64_t PlaceHash(const double place[3])
{
  std::uint64_t hash = 0x9e3779b97f4a7c15ull;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double coordinate = place[axis] + 0.0; // one zero
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash = MixBits(hash ^ bits) + 0x9e3779b97f4a7c15ull;
  }
  return MixBits(hash);
}

// The place to 36 bits of its greatest coordinate: ranks, compilers and ways to store a cell differ
// in the last of 53. Zero where it is zero but for rounding, compared with the size of a cell.
inline std::array<double, 3> RoundedPlace(const double place[3], double cell)
{
  const double greatest = std::max({ std::abs(place[0]), std::abs(place[1]), std::abs(place[2]) });
  if (!(greatest > 1e-9 * cell))
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  // The factor keeps numbers that data like, powers of two, away from where the step changes.
  const double step = std::ldexp(1.0, std::ilogb(1.37 * greatest) - 36);
  return { { step * std::round(place[0] / step), step * std::round(place[1] / step),
    step * std::round(place[2] / step) } };
}

// Two independent numbers, uniform in [0, 1): the phase that a pattern starts with, and a seed for
// what else differs.
struct SplatSeed
{
  float Phase = 0.0f;
  float Rest = 0.0f;
};

inline SplatSeed SeedOf(const double place[3], double cell = 0.0)
{
  const std::uint64_t hash = PlaceHash(RoundedPlace(place, cell).data());
  constexpr float step = 1.0f / 16777216.0f; // 24 bits are exact in a float
  return { static_cast<float>(hash >> 40) * step,
    static_cast<float>((hash >> 8) & 0xffffff) * step };
}
}

#endif
