// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeWinds.h"

#include <gtest/gtest.h>

#include <random>

using namespace nephoscope;

namespace
{
constexpr double PI = GlobeColumns::PI;

std::vector<double> Even(double from, double to, int count)
{
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(from + (to - from) * i / (count - 1));
  }
  return values;
}

// Columns and rows at uneven distances.
std::vector<double> Uneven(double from, double to, int count)
{
  std::vector<double> values = Even(0.0, 1.0, count);
  for (double& v : values)
  {
    v = from + (to - from) * (v + 0.05 * std::sin(2.0 * PI * v));
  }
  return values;
}

void RandomDirection(std::mt19937& random, double p[3])
{
  std::normal_distribution<double> any;
  for (int c = 0; c < 3; ++c)
  {
    p[c] = any(random);
  }
  Normalize(p);
}

// The point of the bilinear patch of a column, times the scale: the direction itself, if the column
// is right.
void PointOf(const GlobeColumns& columns, const ColumnPosition& column, double x[3])
{
  x[0] = x[1] = x[2] = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double east = corner % 2 ? column.East : 1.0 - column.East;
    const double north = corner / 2 ? column.North : 1.0 - column.North;
    const double longitude = columns.Longitude(column.Column + corner % 2);
    const int row = column.Row + corner / 2;
    const double w = column.Scale * east * north;
    x[0] += w * columns.CosineOfLatitude(row) * std::cos(longitude);
    x[1] += w * columns.CosineOfLatitude(row) * std::sin(longitude);
    x[2] += w * columns.SineOfLatitude(row);
  }
}

void CheckPlaces(const GlobeColumns& columns, bool withHints)
{
  std::mt19937 random(5);
  ColumnHint hint;
  for (int n = 0; n < 20000; ++n)
  {
    double p[3];
    RandomDirection(random, p);
    hint = withHints ? hint : ColumnHint{};
    const ColumnPosition column = columns.Find(p, hint);
    ASSERT_TRUE(column.Inside);
    double x[3];
    PointOf(columns, column, x);
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(x[c], p[c], 2e-13);
    }
  }
}
}

TEST(GlobeColumns, FindsWhereADirectionIs)
{
  for (const bool withHints : { false, true })
  {
    CheckPlaces(GlobeColumns(Even(0.0, 2.0 * PI, 37), Even(-0.5 * PI, 0.5 * PI, 19)), withHints);
    CheckPlaces(GlobeColumns(Uneven(-PI, PI, 41), Uneven(-0.5 * PI, 0.5 * PI, 23)), withHints);
    CheckPlaces(
      GlobeColumns(Even(0.3, 0.3 + 2.0 * PI, 321), Even(-0.5 * PI, 0.5 * PI, 162)), withHints);
  }
}

TEST(GlobeColumns, PolesAndColumns)
{
  const GlobeColumns columns(Even(0.0, 2.0 * PI, 37), Even(-0.5 * PI, 0.5 * PI, 19));
  for (const double z : { 1.0, -1.0 })
  {
    const double pole[3] = { 0.0, 0.0, z };
    ColumnHint hint;
    const ColumnPosition column = columns.Find(pole, hint);
    EXPECT_TRUE(column.Inside);
    EXPECT_EQ(column.North, z > 0.0 ? 1.0 : 0.0);
    EXPECT_NEAR(column.Scale, 1.0, 1e-15);
  }
  for (int i = 0; i < 36; ++i)
  {
    const double p[3] = { std::cos(i * PI / 18.0), std::sin(i * PI / 18.0), 0.0 };
    ColumnHint hint;
    const ColumnPosition found = columns.Find(p, hint);
    EXPECT_NEAR(std::remainder(found.Column + found.East - i, 36.0), 0.0, 1e-12);
  }
}

TEST(GlobeColumns, BeyondTheBordersOfARegion)
{
  const GlobeColumns columns(Even(0.1, 0.9, 9), Even(0.2, 0.8, 7));
  EXPECT_FALSE(columns.IsClosed());
  const auto find = [&](double longitude, double latitude) {
    const double p[3] = { std::cos(latitude) * std::cos(longitude),
      std::cos(latitude) * std::sin(longitude), std::sin(latitude) };
    ColumnHint hint;
    return columns.Find(p, hint);
  };
  EXPECT_TRUE(find(0.5, 0.5).Inside);
  const ColumnPosition west = find(-0.5, 0.5);
  EXPECT_FALSE(west.Inside);
  EXPECT_EQ(west.Column + west.East, 0.0);
  EXPECT_NEAR(west.Row + west.North, 3.0, 1e-2);
  const ColumnPosition east = find(2.5, 0.5);
  EXPECT_EQ(east.Column + east.East, 8.0);
  EXPECT_NEAR(east.Row + east.North, 3.0, 1e-2);
  const ColumnPosition north = find(0.5, 1.3);
  EXPECT_FALSE(north.Inside);
  EXPECT_EQ(north.Row + north.North, 6.0);
  EXPECT_EQ(find(0.5, -1.0).Row + find(0.5, -1.0).North, 0.0);
}

namespace
{
// The rotation of the sphere about an axis on a grid, and levels that slope.
GlobeWinds Rotation(const GlobeColumns& columns, int levels, const double axis[3])
{
  GlobeWinds winds;
  for (int k = 0; k < levels; ++k)
  {
    for (int j = 0; j < columns.RowCount(); ++j)
    {
      for (int i = 0; i < columns.ColumnCount(); ++i)
      {
        const double longitude = columns.Longitude(i);
        const double p[3] = { columns.CosineOfLatitude(j) * std::cos(longitude),
          columns.CosineOfLatitude(j) * std::sin(longitude), columns.SineOfLatitude(j) };
        winds.Vectors.push_back({ static_cast<float>(axis[1] * p[2] - axis[2] * p[1]),
          static_cast<float>(axis[2] * p[0] - axis[0] * p[2]),
          static_cast<float>(axis[0] * p[1] - axis[1] * p[0]), static_cast<float>(k) });
        winds.Levels.push_back(static_cast<float>(100.0 * k + 10.0 * p[2]));
      }
    }
  }
  return winds;
}
}

TEST(GlobeWinds, ARotationIsInterpolatedWithoutError)
{
  const double axis[3] = { 0.6, -0.3, 0.5 };
  const GlobeColumns columns(Even(0.0, 2.0 * PI, 25), Even(-0.5 * PI, 0.5 * PI, 13)); // 15 degrees
  const GlobeWinds winds = Rotation(columns, 3, axis);
  const GlobeWindSampler sampler(columns, 3);
  std::mt19937 random(7);
  ColumnHint hint;
  std::int32_t levelHint = 0;
  for (int n = 0; n < 5000; ++n)
  {
    double p[3];
    RandomDirection(random, p);
    const auto foot = sampler.Locate(p, hint);
    const SphereRates rates = sampler.Sample(winds, foot, 57.0, levelHint);
    EXPECT_NEAR(rates.Direction[0], axis[1] * p[2] - axis[2] * p[1], 3e-7);
    EXPECT_NEAR(rates.Direction[1], axis[2] * p[0] - axis[0] * p[2], 3e-7);
    EXPECT_NEAR(rates.Direction[2], axis[0] * p[1] - axis[1] * p[0], 3e-7);
  }
}

TEST(GlobeWinds, LevelsAreFoundFromAnyHintAndHeldAtTheEnds)
{
  const double axis[3] = { 0.0, 0.0, 0.0 };
  const GlobeColumns columns(Even(0.0, 2.0 * PI, 25), Even(-0.5 * PI, 0.5 * PI, 13));
  const GlobeWinds winds = Rotation(columns, 5, axis);
  const GlobeWindSampler sampler(columns, 5);
  const double p[3] = { 1.0, 0.0, 0.0 };
  ColumnHint column;
  const auto foot = sampler.Locate(p, column);
  for (const std::int32_t first : { -7, 0, 2, 3, 99 })
  {
    for (const double level : { -50.0, 0.0, 120.0, 399.0, 400.0, 700.0 })
    {
      std::int32_t hint = first;
      const double above = sampler.FindLevel(winds.Levels, foot, level, hint);
      EXPECT_NEAR(hint + above, std::min(std::max(level / 100.0, 0.0), 4.0), 1e-6);
      EXPECT_NEAR(sampler.Sample(winds, foot, level, hint).Rise, hint + above, 1e-6);
    }
  }
  EXPECT_NEAR(sampler.ClampedLevel(winds, foot, -50.0), 0.0, 1e-5);
  EXPECT_NEAR(sampler.ClampedLevel(winds, foot, 700.0), 400.0, 1e-4);
}
