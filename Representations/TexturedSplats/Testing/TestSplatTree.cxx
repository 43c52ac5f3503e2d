// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The hierarchy of splats against sums over its leaves: means, errors, mass and emission of every cut, tolerance, budget. */
#include "SplatClasses.h"
#include "SplatCut.h"
#include "SplatMatrix.h"
#include "SplatSamples.h"
#include "SplatTree.h"
#include "TestRandom.h"
#include "ThreadScope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace nephoscope;
using nephoscope_test::Random;

namespace
{
struct Scene
{
  SplatSamples Samples;
  SplatClasses Classes;
};

// Splats of a lattice of cells of 0.5 x 1 x 2, some of them left out; or of particles, if `dimensions` are of none.
Scene makeScene(Random& random, std::array<int, 3> n, bool lattice, double left = 0.2)
{
  Scene scene;
  scene.Samples.Jacobians = { { { { { 0.5f, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 2 } } } } };
  std::copy_n(lattice ? n.data() : std::array<int, 3>{}.data(), 3, scene.Samples.Dimensions);
  const int count = n[0] * n[1] * n[2];
  for (int id = 0; id < count; ++id)
  {
    const int index[3] = { id % n[0], id / n[0] % n[1], id / n[0] / n[1] };
    const double jitter = lattice ? 0.0 : 0.4;
    scene.Samples.Positions.push_back({ { float(0.5 * (index[0] + jitter * random.Normal())),
      float(index[1] + jitter * random.Normal()), float(2 * (index[2] + jitter * random.Normal())) } });
    scene.Samples.Ids.push_back(id);
    if (random.Uniform() >= left)
    {
      scene.Classes.Samples.push_back(id);
      scene.Classes.Colors.push_back({ { float(random.Uniform()), float(random.Uniform()),
        float(random.Uniform()), float(random.Uniform(0.1, 2)) } });
    }
  }
  return scene;
}

SplatTree treeOf(const Scene& scene)
{
  SplatTree tree;
  tree.Build(scene.Samples, scene.Classes, {});
  return tree;
}

std::vector<std::int32_t> leavesBelow(const SplatTree& tree, std::int32_t splat)
{
  if (tree.IsLeaf(splat))
  {
    return { splat };
  }
  std::vector<std::int32_t> leaves;
  const SplatTreeNode& node = tree.Node(splat);
  for (const std::int32_t* c = tree.BeginChildren(node); c != tree.EndChildren(node); ++c)
  {
    const auto more = leavesBelow(tree, *c);
    leaves.insert(leaves.end(), more.begin(), more.end());
  }
  return leaves;
}

double volumeOf(const SplatSamples::Jacobian& j)
{
  SplatMatrix m;
  for (std::size_t c = 0; c < 3; ++c)
  {
    m[c] = { { j[c][0], j[c][1], j[c][2] } };
  }
  return std::abs(Determinant(m));
}

// Red emission and extinction, times volume.
std::array<double, 2> massOf(const Scene& scene, const SplatTree& tree, const std::vector<std::int32_t>& splats)
{
  std::array<double, 2> sum{};
  for (const std::int32_t s : splats)
  {
    const bool leaf = tree.IsLeaf(s);
    const auto& color = leaf ? scene.Classes.Colors[std::size_t(s)] : tree.Node(s).Color;
    const double mass = color[3] * (leaf ? 1.0 : volumeOf(tree.Node(s).Jacobian));
    sum[0] += color[0] * mass;
    sum[1] += mass;
  }
  return sum;
}

SplatCutView sideView()
{
  return { { { 40, 30, 50, 1 } }, 1e-6 };
}
}

TEST(SplatTree, NodesOfALatticeAreMeansOfTheirBlocks)
{
  Random random(31);
  for (const std::array<int, 3> n : { std::array<int, 3>{ { 8, 8, 8 } }, { { 5, 3, 7 } }, { { 9, 1, 1 } }, { { 1, 6, 5 } } })
  {
    const Scene scene = makeScene(random, n, true);
    const SplatTree tree = treeOf(scene);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < tree.Nodes().size(); ++i)
    {
      const SplatTreeNode& node = tree.Nodes()[i];
      const auto leaves = leavesBelow(tree, static_cast<std::int32_t>(tree.Leaves() + i));
      // The block: the least one of 2^l samples to a side that holds the leaves, within the grid.
      int level = 0, first[3], size[3];
      for (bool one = false; !one; ++level)
      {
        one = true;
        for (int c = 0; c < 3; ++c)
        {
          const auto at = [&](std::int32_t leaf) {
            const int id = scene.Classes.Samples[std::size_t(leaf)];
            return c == 0 ? id % n[0] : c == 1 ? id / n[0] % n[1] : id / n[0] / n[1];
          };
          first[c] = at(leaves[0]) >> level << level;
          size[c] = std::min(1 << level, n[std::size_t(c)] - first[c]);
          for (const std::int32_t leaf : leaves)
          {
            one = one && at(leaf) >> level == at(leaves[0]) >> level;
          }
        }
      }
      const double block = size[0] * size[1] * size[2];
      double mean = 0, square = 0, most = 0, least = leaves.size() < block ? 0.0 : 1e9;
      for (const std::int32_t leaf : leaves)
      {
        const double a = scene.Classes.Colors[std::size_t(leaf)][3];
        mean += a / block;
        square += a * a / block;
        most = std::max(most, a);
        least = std::min(least, a);
      }
      EXPECT_NEAR(node.Color[3], mean, 1e-5);
      EXPECT_GE(node.GreatestError, std::max(most - mean, mean - least) - 1e-5);
      EXPECT_LE(node.GreatestError, 2.01); // emission deviates by no more than extinction can
      EXPECT_GE(node.RootMeanSquareError, std::sqrt(square - mean * mean) - 1e-5);
      const double edges[3] = { 0.5, 1, 2 };
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(node.Jacobian[c][c], edges[c] * size[c], 1e-5);
        EXPECT_NEAR(node.Position[c], edges[c] * (first[c] + 0.5 * (size[c] - 1)), 1e-4);
      }
      ++checked;
    }
    EXPECT_GT(checked, 1u);
  }
}

TEST(SplatTree, EveryCutKeepsMassAndEmissionAndHoldsEveryLeafOnce)
{
  Random random(32);
  for (const bool lattice : { true, false })
  {
    const Scene scene = makeScene(random, { { 11, 6, 9 } }, lattice);
    const SplatTree tree = treeOf(scene);
    std::vector<std::int32_t> all(tree.Leaves());
    std::size_t last = all.size() + 1;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      all[i] = static_cast<std::int32_t>(i);
    }
    const auto exact = massOf(scene, tree, all);
    for (const double tolerance : { 0.0, 0.3, 1.0, 2.0, 5.0, 1e6 })
    {
      for (const bool image : { true, false })
      {
        SplatCutRule rule;
        rule.Tolerance = tolerance;
        rule.OfImage = image;
        const auto cut = CutSplatTree(tree, rule, sideView());
        const auto mass = massOf(scene, tree, cut);
        EXPECT_NEAR(mass[0] / exact[0], 1, 1e-5);
        EXPECT_NEAR(mass[1] / exact[1], 1, 1e-5);
        std::vector<std::int32_t> held;
        for (const std::int32_t s : cut)
        {
          const auto below = leavesBelow(tree, s);
          held.insert(held.end(), below.begin(), below.end());
          EXPECT_TRUE(tree.IsLeaf(s) || SplatError(tree.Node(s), rule, sideView()) <= tolerance);
        }
        std::sort(held.begin(), held.end());
        EXPECT_EQ(held, all);
        if (image)
        {
          EXPECT_LE(cut.size(), last);
          last = cut.size();
        }
      }
    }
    EXPECT_EQ(last, 1u);
  }
}

TEST(SplatTree, BudgetIsKeptAndNearlyUsed)
{
  Random random(33);
  const Scene scene = makeScene(random, { { 16, 12, 10 } }, true);
  const SplatTree tree = treeOf(scene);
  for (const std::size_t most : { 1, 10, 100, 500 })
  {
    SplatCutRule rule;
    rule.MostSplats = most;
    double tolerance = 0;
    const auto cut = CutSplatTree(tree, rule, sideView(), &tolerance);
    EXPECT_LE(cut.size(), most);
    EXPECT_GE(cut.size() + 7, most);
    EXPECT_GT(tolerance, 0);
  }
}

TEST(SplatTree, AroundTheEyeOnlyLeavesAreDrawn)
{
  Random random(34);
  const Scene scene = makeScene(random, { { 8, 8, 8 } }, true, 0);
  const SplatTree tree = treeOf(scene);
  SplatCutRule rule;
  rule.Tolerance = 1e6;
  rule.KernelRadius = 1.556;
  const SplatCutView view{ { { 2, 4, 7, 1 } }, 1e-6 };
  const auto cut = CutSplatTree(tree, rule, view);
  EXPECT_GT(cut.size(), 50u);
  for (const std::int32_t s : cut)
  {
    EXPECT_TRUE(tree.IsLeaf(s) || std::isfinite(SplatError(tree.Node(s), rule, view)));
  }
}

TEST(SplatTree, TheSameForAnyNumberOfThreads)
{
  Random random(35);
  const Scene scene = makeScene(random, { { 40, 30, 20 } }, false);
  SplatTree trees[2];
  std::vector<std::int32_t> cuts[2];
  for (int i = 0; i < 2; ++i)
  {
    nephoscope_test::withThreads(i == 0 ? 1 : 4, [&]() {
      trees[i] = treeOf(scene);
      SplatCutRule rule;
      rule.MostSplats = 3000;
      cuts[i] = CutSplatTree(trees[i], rule, sideView());
    });
  }
  ASSERT_EQ(trees[0].Nodes().size(), trees[1].Nodes().size());
  EXPECT_EQ(std::memcmp(trees[0].Nodes().data(), trees[1].Nodes().data(),
              trees[0].Nodes().size() * sizeof(SplatTreeNode)), 0);
  EXPECT_EQ(cuts[0], cuts[1]);
}

TEST(SplatTree, OneAndNoSplat)
{
  Random random(36);
  const Scene one = makeScene(random, { { 1, 1, 1 } }, true, 0);
  EXPECT_EQ(CutSplatTree(treeOf(one), {}, sideView()), std::vector<std::int32_t>{ 0 });
  EXPECT_TRUE(treeOf(makeScene(random, { { 2, 2, 2 } }, true, 2)).IsEmpty());
}
