// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Blocks of samples: nested boxes, halved along the short edges first where cells are flat. */
#include "BlockOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace nephoscope;

namespace
{
struct Box
{
  BlockOrder::Index First{ { 1000, 1000, 1000 } }, Last{};
  std::size_t Samples = 0;
};

std::map<std::uint64_t, Box> BoxesOf(
  const BlockOrder& order, const BlockOrder::Index& sizes, int level)
{
  std::map<std::uint64_t, Box> boxes;
  for (std::uint32_t z = 0; z < sizes[2]; ++z)
  {
    for (std::uint32_t y = 0; y < sizes[1]; ++y)
    {
      for (std::uint32_t x = 0; x < sizes[0]; ++x)
      {
        const BlockOrder::Index index{ { x, y, z } };
        Box& box = boxes[order.BlockOf(order.CodeOf(index), level)];
        ++box.Samples;
        for (std::size_t c = 0; c < 3; ++c)
        {
          box.First[c] = std::min(box.First[c], index[c]);
          box.Last[c] = std::max(box.Last[c], index[c]);
        }
      }
    }
  }
  return boxes;
}
}

TEST(BlockOrder, BlocksAreBoxesUpToTheWholeLattice)
{
  for (const std::array<double, 3> edges :
    { std::array<double, 3>{ { 1, 1, 1 } }, { { 5, 8, 1 } }, { { 1, 3, 1 } } })
  {
    const BlockOrder::Index sizes{ { 11, 6, 5 } };
    const BlockOrder order(sizes, edges);
    EXPECT_EQ(BoxesOf(order, sizes, 0).size(), 11u * 6 * 5);
    EXPECT_EQ(BoxesOf(order, sizes, order.GetNumberOfLevels() - 1).size(), 1u);
    for (int level = 0; level < order.GetNumberOfLevels(); ++level)
    {
      for (const auto& entry : BoxesOf(order, sizes, level))
      {
        const Box& box = entry.second;
        std::size_t volume = 1;
        for (std::size_t c = 0; c < 3; ++c)
        {
          volume *= box.Last[c] - box.First[c] + 1;
        }
        EXPECT_EQ(box.Samples, volume);
      }
    }
  }
}

TEST(BlockOrder, FlatCellsAreHalvedAlongTheirShortEdgesFirst)
{
  const BlockOrder::Index sizes{ { 16, 16, 16 } };
  const BlockOrder order(sizes, { { 5, 8, 1 } });
  const std::array<BlockOrder::Index, 6> expected{ { { { 1, 1, 2 } }, { { 1, 1, 4 } },
    { { 1, 1, 8 } }, { { 2, 1, 8 } }, { { 2, 2, 8 } }, { { 2, 2, 16 } } } };
  for (int level = 1; level < order.GetNumberOfLevels(); ++level)
  {
    const Box box = BoxesOf(order, sizes, level).begin()->second;
    for (std::size_t c = 0; c < 3 && level <= 6; ++c)
    {
      EXPECT_EQ(box.Last[c] - box.First[c] + 1, expected[std::size_t(level) - 1][c])
        << "level " << level;
    }
  }
}

TEST(BlockOrder, CubesMakeAnOctree)
{
  const BlockOrder::Index sizes{ { 8, 8, 8 } };
  const BlockOrder order(sizes, { { 1, 1.5, 1 } });
  EXPECT_EQ(order.GetNumberOfLevels(), 4);
  EXPECT_EQ(BoxesOf(order, sizes, 1).size(), 64u);
  EXPECT_EQ(BoxesOf(order, sizes, 2).size(), 8u);
}

TEST(BlockOrder, OneSample)
{
  const BlockOrder order({ { 1, 1, 1 } }, { { 1, 9, 1 } });
  EXPECT_EQ(order.GetNumberOfLevels(), 1);
  EXPECT_EQ(order.CodeOf({ { 0, 0, 0 } }), 0u);
}

TEST(BlockOrder, LargestIndicesHaveCodesOfTheirOwn)
{
  const std::uint32_t most = 1u << BlockOrder::mostBits;
  const BlockOrder order({ { most, most, most } }, { { 1, 1, 1 } });
  std::set<std::uint64_t> codes;
  for (const std::uint32_t i : { 0u, 1u, most / 2, most - 1 })
  {
    for (const std::uint32_t j : { 0u, most - 2, most - 1 })
    {
      codes.insert(order.CodeOf({ { i, j, i } }));
    }
  }
  EXPECT_EQ(codes.size(), 12u);
}
