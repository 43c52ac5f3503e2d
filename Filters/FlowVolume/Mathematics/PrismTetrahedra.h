// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A prism divided into three tetrahedra that fit its neighbours: every side is cut from its vertex
// of smallest rank, which is the same for both adjacent prisms. Ranks are hashed ids: with plain
// ids, which grow downstream, all sides would be cut the same way and the volume of a sheared tube
// would be wrong to first order. Plain C++17.
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

// Ranks of all ids are different (the finalizer of SplitMix64 is a bijection: SteeleLeaFlood2014)
// and the same on every machine.
inline std::uint64_t Rank(PointId id)
{
  auto x = static_cast<std::uint64_t>(id) + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// The corners of a prism's three tetrahedra, as indices in PrismPoints.
using PrismPattern = std::array<std::array<std::uint8_t, 4>, 3>;

inline PrismPattern MakePrismPattern(const std::array<std::uint64_t, 6>& ranks)
{
  // The rotations that bring each vertex to the front and keep the orientation.
  static constexpr std::uint8_t rotations[6][6] = { { 0, 1, 2, 3, 4, 5 }, { 1, 2, 0, 4, 5, 3 },
    { 2, 0, 1, 5, 3, 4 }, { 3, 5, 4, 0, 2, 1 }, { 4, 3, 5, 1, 0, 2 }, { 5, 4, 3, 2, 1, 0 } };
  const auto first = std::min_element(ranks.begin(), ranks.end()) - ranks.begin();
  const auto& w = rotations[first];
  // Both sides at the first vertex are cut from it; the third one has a smallest vertex of its own.
  if (std::min(ranks[w[1]], ranks[w[5]]) < std::min(ranks[w[2]], ranks[w[4]]))
  {
    return { { { { w[0], w[1], w[2], w[5] } }, { { w[0], w[1], w[5], w[4] } },
      { { w[0], w[4], w[5], w[3] } } } };
  }
  return { { { { w[0], w[1], w[2], w[4] } }, { { w[0], w[4], w[2], w[5] } },
    { { w[0], w[4], w[5], w[3] } } } };
}

inline std::array<TetrahedronPoints, 3> PrismTetrahedra(const PrismPoints& prism)
{
  std::array<std::uint64_t, 6> ranks;
  std::transform(prism.begin(), prism.end(), ranks.begin(), Rank);
  std::array<TetrahedronPoints, 3> tetrahedra;
  const PrismPattern pattern = MakePrismPattern(ranks);
  for (std::size_t t = 0; t < 3; ++t)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      tetrahedra[t][i] = prism[pattern[t][i]];
    }
  }
  return tetrahedra;
}
}

#endif
