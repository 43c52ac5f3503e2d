// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Places of an octree as one number (Morton 1966): the bits of three indices interleaved, so that what lies in one block of 2^l
// to a side stands together in their order, and has equal codes above bit 3 l. Plain C++17.
#ifndef nephoscope_MortonCode_h
#define nephoscope_MortonCode_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace nephoscope
{
using MortonIndex = std::array<std::uint32_t, 3>;
constexpr int mortonLevels = 21; // bits per axis that a code holds

inline std::uint64_t SpreadBits(std::uint32_t index)
{
  std::uint64_t v = index & 0x1fffff;
  v = (v | v << 32) & 0x001f00000000ffffull;
  v = (v | v << 16) & 0x001f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}

inline std::uint32_t GatherBits(std::uint64_t code)
{
  std::uint64_t v = code & 0x1249249249249249ull;
  v = (v | v >> 2) & 0x10c30c30c30c30c3ull;
  v = (v | v >> 4) & 0x100f00f00f00f00full;
  v = (v | v >> 8) & 0x001f0000ff0000ffull;
  v = (v | v >> 16) & 0x001f00000000ffffull;
  return static_cast<std::uint32_t>((v | v >> 32) & 0x1fffff);
}

inline std::uint64_t MortonCode(const MortonIndex& index)
{
  return SpreadBits(index[0]) | SpreadBits(index[1]) << 1 | SpreadBits(index[2]) << 2;
}

inline MortonIndex IndexOfMortonCode(std::uint64_t code)
{
  return { { GatherBits(code), GatherBits(code >> 1), GatherBits(code >> 2) } };
}

// The least level whose block holds both; 0 for equal codes.
inline int CommonLevel(std::uint64_t a, std::uint64_t b)
{
  int level = 0;
  for (std::uint64_t difference = a ^ b; difference != 0; difference >>= 3)
  {
    ++level;
  }
  return level;
}
}

#endif
