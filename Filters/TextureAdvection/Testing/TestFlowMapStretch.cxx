// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridStretch.h"

#include <gtest/gtest.h>

#include <random>

using namespace nephoscope;

TEST(FlowMapStretch, SingularValuesThatAreKnown)
{
  EXPECT_NEAR(LargestStretch({ { { 2, 0, 0 }, { 0, 3, 0 }, { 0, 0, 0.5 } } }), 3.0, 1e-14);
  EXPECT_NEAR(LargestStretch({ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }), 1.0, 1e-15);
  // A shear by g: (g + sqrt(g^2 + 4)) / 2.
  EXPECT_NEAR(LargestStretch({ { { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 1 } } }),
    0.5 * (1.0 + std::sqrt(5.0)), 1e-14);
  EXPECT_EQ(LargestStretch({ { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } } }), 0.0);
}

// The largest growth of any of many vectors comes near, and is never above.
TEST(FlowMapStretch, NoVectorGrowsMore)
{
  std::mt19937 random(11);
  std::normal_distribution<double> any;
  for (int n = 0; n < 50; ++n)
  {
    Matrix3 columns;
    for (auto& column : columns)
    {
      column = { any(random), any(random), any(random) };
    }
    const double largest = LargestStretch(columns);
    double found = 0.0;
    for (int m = 0; m < 20000; ++m)
    {
      const double v[3] = { any(random), any(random), any(random) };
      double image[3];
      for (std::size_t c = 0; c < 3; ++c)
      {
        image[c] = v[0] * columns[0][c] + v[1] * columns[1][c] + v[2] * columns[2][c];
      }
      found =
        std::max(found, std::hypot(image[0], image[1], image[2]) / std::hypot(v[0], v[1], v[2]));
    }
    EXPECT_LE(found, largest * (1.0 + 1e-12));
    EXPECT_GE(found, 0.99 * largest);
  }
}

TEST(FlowMapStretch, ExponentAndWeight)
{
  EXPECT_NEAR(LyapunovExponent(std::exp(3.0), 10.0), 0.3, 1e-15);
  EXPECT_EQ(LyapunovExponent(5.0, 0.0), 0.0);
  EXPECT_EQ(WeightLeft(4.0, 4.0), 0.5);
  EXPECT_GT(WeightLeft(1.0, 4.0), 0.99);
  EXPECT_LT(WeightLeft(20.0, 4.0), 0.01);
}

TEST(GridStretch, ALinearMapOnASkewedGrid)
{
  StretchGrid grid;
  grid.Points = { { 5, 4, 3 } };
  std::vector<std::array<double, 3>> from;
  std::vector<std::array<double, 3>> to;
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 5; ++i)
      {
        const double x = i + 0.5 * j - 0.2 * k;
        const double y = 2.0 * j + 0.3 * i;
        const double z = 0.1 * k + 0.02 * i;
        from.push_back({ x, y, z });
        to.push_back({ 3.0 * y, -0.5 * x, z + 7.0 });
      }
    }
  }
  const GridStretch stretch(grid, from, to);
  EXPECT_NEAR(stretch.At({ 0, 0, 0 }), 3.0, 1e-12);
  EXPECT_NEAR(stretch.At({ 2, 1, 1 }), 3.0, 1e-12);
  EXPECT_NEAR(stretch.At({ 4, 3, 2 }), 3.0, 1e-12);
}

TEST(GridStretch, FlatAndDegenerateGrids)
{
  StretchGrid grid;
  grid.Points = { { 3, 1, 1 } };
  const std::vector<std::array<double, 3>> line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  const std::vector<std::array<double, 3>> longer = { { 0, 0, 0 }, { 0, 4, 0 }, { 0, 8, 0 } };
  EXPECT_NEAR(GridStretch(grid, line, longer).At({ 1, 0, 0 }), 4.0, 1e-14);
  const std::vector<std::array<double, 3>> point(3, { 1, 1, 1 });
  EXPECT_EQ(GridStretch(grid, point, longer).At({ 1, 0, 0 }), 1.0);
}
