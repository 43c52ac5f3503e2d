// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Means and errors of hierarchy nodes. */
#include "SplatKernel.h"
#include "SplatNode.h"
#include "SplatOpacity.h"

#include <gtest/gtest.h>

#include <vector>

using namespace nephoscope;

namespace
{
SplatNode Tree(std::vector<SplatNode> nodes)
{
  while (nodes.size() > 1)
  {
    std::vector<SplatNode> parents;
    for (std::size_t i = 0; i < nodes.size(); i += 2)
    {
      parents.push_back(i + 1 < nodes.size() ? Join(nodes[i], nodes[i + 1]) : nodes[i]);
    }
    nodes = parents;
  }
  return nodes[0];
}
}

TEST(SplatNode, ErrorsOfARamp)
{
  for (int level = 1; level <= 3; ++level)
  {
    const int length = 1 << level;
    std::vector<SplatNode> leaves;
    for (int i = 0; i < length; ++i)
    {
      leaves.push_back(SplatLeaf(i));
    }
    const SplatNode root = Tree(leaves);
    EXPECT_NEAR(root.RootMeanSquareError(), std::sqrt((length * length - 1) / 12.0), 1e-12);
    EXPECT_NEAR(root.LargestError(), 0.5 * (length - 1), 1e-12);
  }
}

TEST(SplatNode, MissingChildrenDoNotCount)
{
  const SplatNode joined = Join(Join(SplatLeaf(1), SplatNode()), Join(SplatLeaf(4), SplatLeaf(7)));
  EXPECT_EQ(joined.Count, 3.0);
  EXPECT_NEAR(joined.Mean, 4.0, 1e-15);
  EXPECT_NEAR(joined.Variance, 6.0, 1e-12);
  EXPECT_EQ(joined.Minimum, 1.0);
  EXPECT_EQ(joined.Maximum, 7.0);
}

TEST(SplatNode, CoarseSplatHasTheOpacityOfTheFineOnesItStandsFor)
{
  const double fine = SplatAlpha(0.3 * cubic_kernel::Footprint(0.0));
  const double coarse = SplatAlpha(0.3 * 2.0 * cubic_kernel::Footprint(0.0));
  EXPECT_NEAR(fine, 0.189401996350697, 1e-9);
  EXPECT_NEAR(coarse, 0.3429308764797646, 1e-9);
}
