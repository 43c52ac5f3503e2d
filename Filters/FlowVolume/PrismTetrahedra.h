// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A prism divided into three tetrahedra that fit its neighbours: every side is cut from its vertex of smallest
// rank, which both prisms beside it know. Ranks are hashed ids: with plain ids, which grow downstream, all
// sides would be cut the same way and the volume of a sheared tube would be wrong to first order. Plain C++17.
#ifndef nephoscope_PrismTetrahedra_h
#define nephoscope_PrismTetrahedra_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace nephoscope
{
using PointId = std::int64_t;
using PrismPoints = std::array<PointId,
  6>; // bottom 0 1 2, counter-clockwise seen from the top; 3 above 0, 4 above 1, 5 above 2
using TetrahedronPoints = std::array<PointId, 4>;

// Ranks of all ids are different (the finalizer of SplitMix64 is a bijection: SteeleLeaFlood2014) and the same on every machine.
inline std::uint64_t Rank(PointId id)
{
  auto x = static_cast<std::uint64_t>(id) + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// The six rotations that bring each vertex to the front and keep the orientation.
inline PrismPoints SmallestRankFirst(const PrismPoints& prism)
{
  static constexpr int rotations[6][6] = { { 0, 1, 2, 3, 4, 5 }, { 1, 2, 0, 4, 5, 3 },
    { 2, 0, 1, 5, 3, 4 }, { 3, 5, 4, 0, 2, 1 }, { 4, 3, 5, 1, 0, 2 }, { 5, 4, 3, 2, 1, 0 } };
  std::array<std::uint64_t, 6> ranks;
  std::transform(prism.begin(), prism.end(), ranks.begin(), Rank);
  const auto first = std::min_element(ranks.begin(), ranks.end()) - ranks.begin();
  PrismPoints rotated;
  for (std::size_t i = 0; i < 6; ++i)
  {
    rotated[i] = prism[static_cast<std::size_t>(rotations[first][i])];
  }
  return rotated;
}

inline std::array<TetrahedronPoints, 3> PrismTetrahedra(const PrismPoints& prism)
{
  const PrismPoints w = SmallestRankFirst(prism);
  if (std::min(Rank(w[1]), Rank(w[5])) < std::min(Rank(w[2]), Rank(w[4])))
  {
    return { { { w[0], w[1], w[2], w[5] }, { w[0], w[1], w[5], w[4] },
      { w[0], w[4], w[5], w[3] } } };
  }
  return { { { w[0], w[1], w[2], w[4] }, { w[0], w[4], w[2], w[5] }, { w[0], w[4], w[5], w[3] } } };
}
}

#endif
