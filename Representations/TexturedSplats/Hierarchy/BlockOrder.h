// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples of a lattice in the order of blocks, which are halved along one axis or more from level
// to level: the bits of three indices interleaved (Morton 1966), so that what lies in one block
// stands together and has equal codes above the bits of its level.
//
// Where cells are much longer along one axis than along another, two blocks make one, side by side
// along the edge that is the shortest at the time; elsewhere eight.
// Plain C++17.
#ifndef nephoscope_BlockOrder_h
#define nephoscope_BlockOrder_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{
class BlockOrder
{
public:
  using Index = std::array<std::uint32_t, 3>;
  static constexpr int mostBits = 21; // per axis that a code holds

  // Numbers of samples along the axes, at most 2^21, and lengths of a cell.
  BlockOrder(const Index& sizes, std::array<double, 3> edges)
  {
    std::array<int, 3> bits{}; // that are left
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::uint32_t last = sizes[axis] > 0 ? sizes[axis] - 1 : 0; last != 0; last >>= 1)
      {
        ++bits[axis];
      }
    }
    this->Ends.push_back(0);
    if (AreFlat(bits, edges))
    {
      this->AddPairs(bits, edges);
    }
    while (bits[0] + bits[1] + bits[2] > 0)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        if (bits[axis] > 0)
        {
          this->AddBit(axis, bits);
        }
      }
      this->Ends.push_back(static_cast<int>(this->Axes.size()));
    }
  }

  std::uint64_t CodeOf(Index index) const
  {
    std::uint64_t code = 0;
    for (std::size_t bit = 0; bit < this->Axes.size(); ++bit)
    {
      std::uint32_t& i = index[this->Axes[bit]];
      code |= static_cast<std::uint64_t>(i & 1u) << bit;
      i >>= 1;
    }
    return code;
  }

  // Level 0: samples; at the last one all are in one block.
  int GetNumberOfLevels() const { return static_cast<int>(this->Ends.size()); }
  std::uint64_t BlockOf(std::uint64_t code, int level) const
  {
    return code >> this->Ends[static_cast<std::size_t>(level)];
  }

private:
  static constexpr double flat = 2.0; // an edge over a shorter one

  static bool AreFlat(const std::array<int, 3>& bits, const std::array<double, 3>& edges)
  {
    double shortest = 0.0, longest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (bits[axis] > 0)
      {
        shortest = longest > 0.0 ? std::min(shortest, edges[axis]) : edges[axis];
        longest = std::max(longest, edges[axis]);
      }
    }
    return longest >= flat * shortest;
  }

  void AddPairs(std::array<int, 3>& bits, std::array<double, 3>& edges)
  {
    while (bits[0] + bits[1] + bits[2] > 0)
    {
      std::size_t shortest = 3;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        if (bits[axis] > 0 && (shortest == 3 || edges[axis] < edges[shortest]))
        {
          shortest = axis;
        }
      }
      this->AddBit(shortest, bits);
      edges[shortest] *= 2.0;
      this->Ends.push_back(static_cast<int>(this->Axes.size()));
    }
  }

  void AddBit(std::size_t axis, std::array<int, 3>& bits)
  {
    this->Axes.push_back(axis);
    --bits[axis];
  }

  std::vector<std::size_t> Axes; // of the bits of a code, from the lowest
  std::vector<int> Ends;         // of the bits that are the same in a block, by level
};
}

#endif
