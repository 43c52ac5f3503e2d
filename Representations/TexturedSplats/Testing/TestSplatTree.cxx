// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The hierarchy of splats against sums over its leaves: moments, mass and emission of every cut,
 * tolerance, budget, fading.
 */
#include "SplatClasses.h"
#include "SplatCut.h"
#include "SplatError.h"
#include "SplatKernel.h"
#include "SplatMatrix.h"
#include "SplatSamples.h"
#include "SplatTree.h"
#include "TestRandom.h"
#include "ThreadScope.h"

#include "OwnThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
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

// Splats of a lattice of cells of 0.5 x 1 x 2, some of them left out; or of particles, if
// `dimensions` are of none.
Scene MakeScene(Random& random, std::array<int, 3> n, bool lattice, double left = 0.2)
{
  Scene scene;
  scene.Samples.HaveOneShape = true;
  scene.Samples.Jacobians = { { { { { 0.5f, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 2 } } } } };
  std::copy_n(lattice ? n.data() : std::array<int, 3>{}.data(), 3, scene.Samples.Dimensions);
  const int count = n[0] * n[1] * n[2];
  std::vector<vtkIdType> ids;
  for (int id = 0; id < count; ++id)
  {
    const int index[3] = { id % n[0], id / n[0] % n[1], id / n[0] / n[1] };
    const double jitter = lattice ? 0.0 : 0.4;
    scene.Samples.Positions.push_back({ { float(0.5 * (index[0] + jitter * random.Normal())),
      float(index[1] + jitter * random.Normal()),
      float(2 * (index[2] + jitter * random.Normal())) } });
    ids.push_back(id);
    if (random.Uniform() >= left)
    {
      scene.Classes.Samples.push_back(id);
      scene.Classes.Colors.push_back({ { float(random.Uniform()), float(random.Uniform()),
        float(random.Uniform()), float(random.Uniform(0.1, 2)) } });
    }
  }
  scene.Samples.Ids = SampleIds(std::move(ids));
  return scene;
}

SplatTree TreeOf(const Scene& scene)
{
  SplatTree tree;
  tree.Build(scene.Samples, scene.Classes, {});
  return tree;
}

std::vector<std::int32_t> LeavesBelow(const SplatTree& tree, std::int32_t splat)
{
  if (tree.IsLeaf(splat))
  {
    return { splat };
  }
  std::vector<std::int32_t> leaves;
  const SplatTreeNode& node = tree.Node(splat);
  for (const std::int32_t* c = tree.BeginChildren(node); c != tree.EndChildren(node); ++c)
  {
    const auto more = LeavesBelow(tree, *c);
    leaves.insert(leaves.end(), more.begin(), more.end());
  }
  return leaves;
}

double VolumeOf(const SplatSamples::Jacobian& j)
{
  SplatMatrix m;
  for (std::size_t c = 0; c < 3; ++c)
  {
    m[c] = { { j[c][0], j[c][1], j[c][2] } };
  }
  return std::abs(Determinant(m));
}

// Red emission and extinction, times volume.
std::array<double, 2> MassOf(const Scene& scene, const SplatTree& tree, const SplatCut& cut)
{
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < cut.Splats.size(); ++i)
  {
    const std::int32_t s = cut.Splats[i];
    const bool leaf = tree.IsLeaf(s);
    const auto& color = leaf ? scene.Classes.Colors[std::size_t(s)] : tree.Node(s).Color;
    const double weight = cut.Weights.empty() ? 1.0 : cut.Weights[i];
    const double mass = weight * color[3] * (leaf ? 1.0 : VolumeOf(tree.Node(s).Jacobian));
    sum[0] += color[0] * mass;
    sum[1] += mass;
  }
  return sum;
}

std::vector<float> ErrorsOf(const Scene& scene, const SplatTree& tree, bool image)
{
  SplatErrorRule rule;
  rule.As = SplatErrorRule::Measure::RootMeanSquare;
  rule.OfImage = image;
  return FindSplatErrors(tree, scene.Samples, scene.Classes, rule, { { { 40, 30, 50, 1 } }, 1e-6 });
}
}

TEST(SplatTree, NodesHaveTheMomentsOfWhatLiesBelow)
{
  Random random(31);
  for (const bool lattice : { true, false })
  {
    const Scene scene = MakeScene(random, { { 9, 5, 7 } }, lattice);
    const SplatTree tree = TreeOf(scene);
    for (std::size_t i = 0; i < tree.Nodes().size(); ++i)
    {
      const SplatTreeNode& node = tree.Nodes()[i];
      double mass = 0, mean[3] = {}, second[3][3] = {};
      const double edges[3] = { 0.5, 1, 2 };
      for (const std::int32_t leaf :
        LeavesBelow(tree, static_cast<std::int32_t>(tree.Leaves() + i)))
      {
        const double a = scene.Classes.Colors[std::size_t(leaf)][3];
        const auto& p =
          scene.Samples.Positions[std::size_t(scene.Classes.Samples[std::size_t(leaf)])];
        mass += a;
        for (std::size_t c = 0; c < 3; ++c)
        {
          mean[c] += a * p[c];
          second[c][c] += a * cubic_kernel::variance * edges[c] * edges[c];
          for (std::size_t d = 0; d < 3; ++d)
          {
            second[c][d] += a * p[c] * p[d];
          }
        }
      }
      EXPECT_NEAR(node.Color[3] * VolumeOf(node.Jacobian), mass, 2e-5 * mass);
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(node.Position[c], mean[c] / mass, 1e-4);
        for (std::size_t d = 0; d < 3; ++d)
        {
          double found = 0;
          for (const auto& column : node.Jacobian)
          {
            found += cubic_kernel::variance * column[c] * column[d];
          }
          EXPECT_NEAR(found, second[c][d] / mass - mean[c] * mean[d] / mass / mass, 1e-3);
        }
      }
      EXPECT_GE(node.GreatestError, node.RootMeanSquareError);
      EXPECT_GT(node.RootMeanSquareError, 0);
    }
  }
}

TEST(SplatTree, FlatCellsArePutTogetherAlongTheirShortEdges)
{
  Random random(37);
  const Scene scene = MakeScene(random, { { 16, 1, 4 } }, true, 0.0); // cells of 0.5 x 1 x 2
  const SplatTree tree = TreeOf(scene);
  const SplatTreeNode& first = tree.Nodes()[0];
  EXPECT_EQ(tree.EndChildren(first) - tree.BeginChildren(first), 2);
  EXPECT_GT(first.Jacobian[0][0], 0.6);
  EXPECT_NEAR(first.Jacobian[2][2], 2, 1e-5);
}

// The root of the integral of the square of what the splats differ from their node, on the screen
// of a parallel view along z, by a sum over pixels.
TEST(SplatTree, ErrorsAreThoseOfAPicture)
{
  Random random(38);
  for (const std::array<int, 3> n :
    { std::array<int, 3>{ { 2, 2, 2 } }, { { 1, 2, 2 } }, { { 2, 1, 1 } } })
  {
    const Scene scene = MakeScene(random, n, true, 0.0);
    const SplatTree tree = TreeOf(scene);
    const SplatCutView view{ { { 0, 0, 1, 0 } }, 1e-6 };
    const auto picture = [&](std::int32_t s, double x, double y, std::size_t channel) {
      const bool leaf = tree.IsLeaf(s);
      const auto& color = leaf ? scene.Classes.Colors[std::size_t(s)] : tree.Node(s).Color;
      const auto& p = leaf ? scene.Samples.Positions[std::size_t(s)] : tree.Node(s).Position;
      const auto& j = leaf ? scene.Samples.Jacobians[0] : tree.Node(s).Jacobian;
      double xx = 0, xy = 0, yy = 0;
      for (const auto& column : j)
      {
        xx += cubic_kernel::variance * column[0] * column[0];
        xy += cubic_kernel::variance * column[0] * column[1];
        yy += cubic_kernel::variance * column[1] * column[1];
      }
      x -= p[0];
      y -= p[1];
      const double determinant = xx * yy - xy * xy;
      const double mass = VolumeOf(j) * color[3] * (channel < 3 ? color[channel] : 1);
      return mass * std::exp(-0.5 * (yy * x * x - 2 * xy * x * y + xx * y * y) / determinant) /
        (2 * 3.14159265358979 * std::sqrt(determinant));
    };
    // Every node is made of leaves and nodes, whose squares add up.
    std::vector<double> sums(tree.Nodes().size());
    const double step = 0.05;
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      const SplatTreeNode& node = tree.Nodes()[i];
      double own[4] = {};
      for (double x = -4; x < 5; x += step)
      {
        for (double y = -5; y < 6; y += step)
        {
          for (std::size_t c = 0; c < 4; ++c)
          {
            double difference = picture(static_cast<std::int32_t>(tree.Leaves() + i), x, y, c);
            for (const std::int32_t* k = tree.BeginChildren(node); k != tree.EndChildren(node); ++k)
            {
              difference -= picture(*k, x, y, c);
            }
            own[c] += step * step * difference * difference;
          }
        }
      }
      sums[i] = *std::max_element(own, own + 4);
      for (const std::int32_t* k = tree.BeginChildren(node); k != tree.EndChildren(node); ++k)
      {
        sums[i] += tree.IsLeaf(*k) ? 0 : sums[std::size_t(*k) - tree.Leaves()];
      }
    }
    SplatErrorRule rule;
    rule.Extinction = 3;
    const auto errors = FindSplatErrors(tree, scene.Samples, scene.Classes, rule, view);
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      EXPECT_NEAR(errors[i] * 1e-6, 3 * std::sqrt(sums[i]), 1e-4 + 1e-3 * std::sqrt(sums[i]));
    }
  }
}

TEST(SplatTree, SplatsOneBehindTheOtherMakeNoError)
{
  Random random(39);
  const Scene scene = MakeScene(random, { { 1, 1, 2 } }, true, 0.0);
  const SplatTree tree = TreeOf(scene);
  SplatErrorRule rule;
  rule.As = SplatErrorRule::Measure::RootMeanSquare;
  auto color = scene.Classes;
  color.Colors[1] = color.Colors[0];
  Scene same{ scene.Samples, color };
  const SplatTree alike = TreeOf(same);
  const auto errorFrom = [&](const SplatEye& eye) {
    return FindSplatErrors(alike, same.Samples, same.Classes, rule, { eye, 1e-6 })[0];
  };
  EXPECT_LT(errorFrom({ { 0, 0, 1, 0 } }), 1e-6);
  EXPECT_GT(errorFrom({ { 1, 0, 0, 0 } }), 0.01);
  EXPECT_EQ(errorFrom({ { 0, 0, 2, 1 } }), std::numeric_limits<float>::infinity());
}

// An actor that stretches: the errors are those of stretched data.
TEST(SplatTree, ErrorsAreThoseOfTheWorld)
{
  Random random(40);
  const SplatMatrix stretch{ { { { 0.7, 0, 0 } }, { { 0.2, 1.6, 0 } }, { { 0, -0.3, 1.1 } } } };
  const auto stretched = [&](const std::array<float, 3>& v) {
    const Vector3 w = Times(stretch, Vector3{ { v[0], v[1], v[2] } });
    return std::array<float, 3>{ { float(w[0]), float(w[1]), float(w[2]) } };
  };
  Scene scene = MakeScene(random, { { 1, 2, 1 } }, true, 0.0); // one node, whatever the shape
  const SplatTree tree = TreeOf(scene);
  Scene other = scene;
  for (auto& place : other.Samples.Positions)
  {
    place = stretched(place);
  }
  for (auto& column : other.Samples.Jacobians[0])
  {
    column = stretched(column);
  }
  const SplatTree otherTree = TreeOf(other);
  const Vector3 eye{ { 3, 7, 12 } };
  const Vector3 otherEye = Times(stretch, eye);
  for (const double place : { 0.0, 1.0 }) // at infinity or not
  {
    SplatErrorRule rule;
    for (const auto as : { SplatErrorRule::Measure::Greatest,
           SplatErrorRule::Measure::RootMeanSquare, SplatErrorRule::Measure::Picture })
    {
      rule.As = as;
      const float found = FindSplatErrors(tree, scene.Samples, scene.Classes, rule,
        { { { eye[0], eye[1], eye[2], place } }, 0.01, stretch })[0];
      const float expected = FindSplatErrors(otherTree, other.Samples, other.Classes, rule,
        { { { otherEye[0], otherEye[1], otherEye[2], place } }, 0.01 })[0];
      EXPECT_GT(expected, 0.01);
      EXPECT_NEAR(found / expected, 1.0, 1e-4);
    }
  }
}

TEST(SplatTree, EveryCutKeepsMassAndEmissionAndHoldsEveryLeafOnce)
{
  Random random(32);
  for (const bool lattice : { true, false })
  {
    const Scene scene = MakeScene(random, { { 11, 6, 9 } }, lattice);
    const SplatTree tree = TreeOf(scene);
    SplatCut all;
    for (std::size_t i = 0; i < tree.Leaves(); ++i)
    {
      all.Splats.push_back(static_cast<std::int32_t>(i));
    }
    const auto exact = MassOf(scene, tree, all);
    for (const bool image : { true, false })
    {
      const auto errors = ErrorsOf(scene, tree, image);
      for (const double blend : { 0.0, 0.4 })
      {
        std::size_t last = 2 * all.Splats.size();
        for (const double tolerance : { 0.0, 0.3, 1.0, 2.0, 5.0, 1e6 })
        {
          const auto cut = CutSplatTree(tree, errors, { tolerance, blend, 0 });
          const auto mass = MassOf(scene, tree, cut);
          EXPECT_NEAR(mass[0] / exact[0], 1, 1e-4);
          EXPECT_NEAR(mass[1] / exact[1], 1, 1e-4);
          EXPECT_LE(cut.Splats.size(), last);
          last = cut.Splats.size();
          std::vector<double> held(tree.Leaves(), 0.0); // with all their weight
          for (std::size_t i = 0; i < cut.Splats.size(); ++i)
          {
            for (const std::int32_t leaf : LeavesBelow(tree, cut.Splats[i]))
            {
              held[std::size_t(leaf)] += cut.Weights.empty() ? 1.0 : cut.Weights[i];
            }
            EXPECT_TRUE(tree.IsLeaf(cut.Splats[i]) ||
              errors[std::size_t(cut.Splats[i]) - tree.Leaves()] <= tolerance);
          }
          for (const double weight : held)
          {
            EXPECT_NEAR(weight, 1, 1e-5);
          }
        }
        EXPECT_EQ(last, 1u);
      }
    }
  }
}

TEST(SplatTree, LevelsFade)
{
  Random random(40);
  const Scene scene = MakeScene(random, { { 11, 6, 9 } }, true);
  const SplatTree tree = TreeOf(scene);
  const auto errors = ErrorsOf(scene, tree, true);
  std::vector<double> before;
  double greatest = 0;
  for (double tolerance = 1; tolerance < 4; tolerance *= 1.002)
  {
    const auto cut = CutSplatTree(tree, errors, { tolerance, 0.4, 0 });
    std::vector<double> weights(tree.Leaves() + tree.Nodes().size(), 0.0);
    for (std::size_t i = 0; i < cut.Splats.size(); ++i)
    {
      weights[std::size_t(cut.Splats[i])] = cut.Weights.empty() ? 1.0 : cut.Weights[i];
    }
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      greatest = std::max(greatest, std::abs(weights[i] - before[i]));
    }
    before = weights;
  }
  EXPECT_GT(greatest, 0);
  EXPECT_LT(greatest,
    0.02); // 0.002 of the tolerance times 1.5 / 0.4, for one level and those that it fades into
}

TEST(SplatTree, BudgetIsKeptAndNearlyUsed)
{
  Random random(33);
  const Scene scene = MakeScene(random, { { 16, 12, 10 } }, true);
  const SplatTree tree = TreeOf(scene);
  const auto errors = ErrorsOf(scene, tree, true);
  for (const std::size_t most : { 1, 10, 100, 500 })
  {
    for (const double blend : { 0.0, 0.3 })
    {
      const auto cut = CutSplatTree(tree, errors, { 0, blend, most });
      EXPECT_LE(cut.Splats.size(), most);
      EXPECT_GE(cut.Splats.size() + 7 + (blend > 0 ? most / 4 : 0), most);
      EXPECT_GT(cut.Tolerance, 0);
    }
  }
}

TEST(SplatTree, AroundTheEyeOnlyLeavesAreDrawn)
{
  Random random(34);
  const Scene scene = MakeScene(random, { { 8, 8, 8 } }, true, 0);
  const SplatTree tree = TreeOf(scene);
  SplatErrorRule rule;
  rule.KernelRadius = 1.556;
  const auto errors =
    FindSplatErrors(tree, scene.Samples, scene.Classes, rule, { { { 2, 4, 7, 1 } }, 1e-6 });
  const auto cut = CutSplatTree(tree, errors, { 1e30, 0, 0 });
  EXPECT_GT(cut.Splats.size(), 50u);
  for (const std::int32_t s : cut.Splats)
  {
    EXPECT_TRUE(tree.IsLeaf(s) || std::isfinite(errors[std::size_t(s) - tree.Leaves()]));
  }
}

TEST(SplatTree, TheSameForAnyNumberOfThreads)
{
  Random random(35);
  const Scene scene = MakeScene(random, { { 40, 30, 20 } }, false);
  SplatTree trees[2];
  std::vector<std::int32_t> cuts[2];
  for (int i = 0; i < 2; ++i)
  {
    nephoscope_test::WithThreads(i == 0 ? 1 : 4, [&]() {
      trees[i] = TreeOf(scene);
      cuts[i] = CutSplatTree(trees[i], ErrorsOf(scene, trees[i], true), { 0, 0, 3000 }).Splats;
    });
  }
  ASSERT_EQ(trees[0].Nodes().size(), trees[1].Nodes().size());
  EXPECT_EQ(std::memcmp(trees[0].Nodes().data(), trees[1].Nodes().data(),
              trees[0].Nodes().size() * sizeof(SplatTreeNode)),
    0);
  EXPECT_EQ(cuts[0], cuts[1]);
}

// The error of a node costs the square of the number of its children.
TEST(SplatTree, NodesAreSmallWhereManySamplesAreInOnePlace)
{
  Random random(29);
  Scene scene = MakeScene(random, { { 40, 25, 20 } }, false, 0.0);
  for (std::size_t i = 0; i + 10 < scene.Samples.Positions.size(); ++i)
  {
    scene.Samples.Positions[i] = { { 3, 4, 5 } };
  }
  const SplatTree tree = TreeOf(scene);
  for (std::size_t n = 0; n < tree.Nodes().size(); ++n)
  {
    const SplatTreeNode& node = tree.Nodes()[n];
    ASSERT_LE(tree.EndChildren(node) - tree.BeginChildren(node), 8);
  }
  EXPECT_EQ(LeavesBelow(tree, tree.Root()).size(), scene.Classes.Samples.size());
}

TEST(SplatTree, OneAndNoSplat)
{
  Random random(36);
  const Scene one = MakeScene(random, { { 1, 1, 1 } }, true, 0);
  EXPECT_EQ(CutSplatTree(TreeOf(one), {}, {}).Splats, std::vector<std::int32_t>{ 0 });
  EXPECT_TRUE(TreeOf(MakeScene(random, { { 2, 2, 2 } }, true, 2)).IsEmpty());
}
