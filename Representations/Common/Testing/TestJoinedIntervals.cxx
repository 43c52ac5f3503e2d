// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Joined intervals against the functions they replace: errors at dense places, and the fewest
// intervals that closed forms allow.
#include "JoinedIntervals.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
using Value = TransferFunctionTable::Value;
using Interval = TransferFunctionTable::Interval;

constexpr double colorTolerance = 1.0 / 510;
constexpr double opacityTolerance = 1.0 / 2500;

struct Table
{
  std::vector<double> Nodes;
  std::vector<Interval> Intervals;

  Value At(double x, std::size_t k) const
  {
    const Interval& interval = this->Intervals[k];
    const double t = (x - this->Nodes[k - 1]) / (this->Nodes[k] - this->Nodes[k - 1]);
    Value value;
    for (std::size_t c = 0; c < 4; ++c)
    {
      value[c] = static_cast<float>(interval.Low[c] * (1 - t) + interval.High[c] * t);
    }
    return value;
  }
  std::size_t Find(double x) const
  {
    return std::upper_bound(this->Nodes.begin(), this->Nodes.end(), x) - this->Nodes.begin();
  }
};

/** Values from inside each interval: `function` of the place and the number of the interval. */
Table Sample(
  const std::vector<double>& nodes, const std::function<Value(double, std::size_t)>& function)
{
  Table table = { nodes, {} };
  for (std::size_t k = 0; k <= nodes.size(); ++k)
  {
    const double low = nodes[k == 0 ? 0 : k - 1], high = nodes[std::min(k, nodes.size() - 1)];
    table.Intervals.push_back({ function(low, k), function(high, k) });
  }
  return table;
}

std::vector<double> Steps(std::size_t count)
{
  std::vector<double> nodes(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    nodes[i] = double(i) / double(count - 1);
  }
  return nodes;
}

Table Joined(Table table, double color = colorTolerance, double opacity = opacityTolerance)
{
  const Interval first = table.Intervals.front(), last = table.Intervals.back();
  const std::vector<double> nodes = table.Nodes;
  JoinIntervals(table.Nodes, table.Intervals, color, opacity);
  EXPECT_EQ(table.Intervals.size(), table.Nodes.size() + 1);
  EXPECT_EQ(table.Intervals.front().Low, first.Low);
  EXPECT_EQ(table.Intervals.back().High, last.High);
  EXPECT_EQ(table.Nodes.front(), nodes.front());
  EXPECT_EQ(table.Nodes.back(), nodes.back());
  EXPECT_TRUE(std::includes(nodes.begin(), nodes.end(), table.Nodes.begin(), table.Nodes.end()));
  return table;
}

/** The same function from right to left. */
Table Mirrored(const Table& table)
{
  Table result;
  for (auto node = table.Nodes.rbegin(); node != table.Nodes.rend(); ++node)
  {
    result.Nodes.push_back(-*node);
  }
  for (auto interval = table.Intervals.rbegin(); interval != table.Intervals.rend(); ++interval)
  {
    result.Intervals.push_back({ interval->High, interval->Low });
  }
  return result;
}

/** In every interval of `table`, at its ends and between, from inside. */
void ExpectWithin(const Table& joined, const Table& table)
{
  constexpr double rounding = 2e-7; // of floats up to 1
  for (std::size_t k = 1; k < table.Nodes.size(); ++k)
  {
    const double low = table.Nodes[k - 1], high = table.Nodes[k];
    const std::size_t j = joined.Find(0.5 * low + 0.5 * high);
    for (int i = 0; i <= 16; ++i)
    {
      const double x = low + (high - low) * i / 16;
      const Value exact = table.At(x, k), value = joined.At(x, j);
      for (std::size_t c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(value[c], exact[c], colorTolerance + rounding) << "at " << x;
      }
      ASSERT_NEAR(value[3], exact[3], opacityTolerance * exact[3] + rounding) << "at " << x;
    }
  }
}

Value Gray(double color, double opacity)
{
  const auto c = static_cast<float>(color);
  return { { c, c, c, static_cast<float>(opacity) } };
}

Value Waves(double x)
{
  return { { static_cast<float>(0.5 + 0.5 * std::sin(5 * x)),
    static_cast<float>(0.5 + 0.5 * std::cos(3 * x)), static_cast<float>(x * x), 0.5f } };
}

float Rounded(float value)
{
  return std::round(255 * value) / 255;
}
}

TEST(JoinedIntervals, StraightLinesAreOneInterval)
{
  const Table table =
    Sample(Steps(256), [](double x, std::size_t) { return Gray(0.2 + 0.6 * x, 0.9 - 0.8 * x); });
  const Table joined = Joined(table);
  ASSERT_EQ(joined.Nodes.size(), 2u);
  EXPECT_NEAR(joined.Intervals[1].Low[0], 0.2, 1e-6);
  EXPECT_NEAR(joined.Intervals[1].High[0], 0.8, 1e-6);
  EXPECT_NEAR(joined.Intervals[1].Low[3], 0.9, 1e-6);
  EXPECT_NEAR(joined.Intervals[1].High[3], 0.1, 1e-6);
}

TEST(JoinedIntervals, ErrorsAreWithinTheTolerance)
{
  Random random(71);
  for (int i = 0; i < 300; ++i)
  {
    std::vector<double> nodes = { random.Uniform(-5, 5) };
    const double bend = random.LogUniform(1e-5, 1), jump = random.LogUniform(1e-5, 1);
    for (int k = 0; k < 100; ++k)
    {
      nodes.push_back(nodes.back() + random.LogUniform(1e-6, 1));
    }
    Value value = Gray(random.Uniform(), random.Uniform());
    const Table table = Sample(nodes, [&](double, std::size_t) {
      for (std::size_t c = 0; c < 4; ++c)
      {
        const double change = (random.Integer(0, 5) ? bend : jump) * random.Uniform(-0.1, 0.1);
        value[c] = std::clamp(value[c] + static_cast<float>(change), 0.0f, 1.0f);
      }
      return value;
    });
    const Table joined = Joined(table);
    ExpectWithin(joined, table);
    EXPECT_EQ(Joined(Mirrored(table)).Nodes.size(), joined.Nodes.size()) << "case " << i;
  }
}

// A parabola y = a x^2 departs from its best line over a length L by a L^2 / 8 to either side.
TEST(JoinedIntervals, ParabolaHasAsFewIntervalsAsPossible)
{
  for (const double a : { 0.1, 0.45, 0.9 })
  {
    const Table table =
      Sample(Steps(2001), [=](double x, std::size_t) { return Gray(0.05 + a * x * x, 1); });
    const double longest = std::sqrt(8 * colorTolerance / a);
    const Table joined = Joined(table);
    EXPECT_NEAR(double(joined.Nodes.size() - 1), std::ceil(1 / longest), 0.1) << a;
    ExpectWithin(joined, table);
  }
}

TEST(JoinedIntervals, ColorsRoundedToBytesNeedFewIntervals)
{
  const Table smooth = Sample(Steps(256), [](double x, std::size_t) { return Waves(x); });
  const Table rounded = Sample(Steps(256), [](double x, std::size_t) {
    Value value = Waves(x);
    std::transform(value.begin(), value.begin() + 3, value.begin(), Rounded);
    return value;
  });
  const std::size_t few = Joined(smooth).Nodes.size();
  EXPECT_LT(few, 20u);
  EXPECT_LE(Joined(rounded).Nodes.size(), 2 * few);
  ExpectWithin(Joined(rounded), rounded);
}

TEST(JoinedIntervals, JumpsAndSpikesOfOpacityAreKept)
{
  std::vector<double> nodes = Steps(101);
  nodes.insert(nodes.begin() + 51, nodes[50] + 1e-9); // a spike in the interval above node 50
  const Table table = Sample(nodes, [](double x, std::size_t k) {
    const double opacity = k == 51 ? 0.9 : k <= 20 ? 0.2 : 0.3 + 0.1 * x;
    return Gray(0.5, opacity);
  });
  const Table joined = Joined(table);
  ASSERT_EQ(joined.Nodes.size(), 5u);
  EXPECT_EQ(joined.Nodes[1], nodes[20]) << "the jump above interval 20";
  EXPECT_NEAR(joined.Intervals[1].High[3], 0.2, 1e-7);
  EXPECT_NEAR(joined.Intervals[2].Low[3], 0.3 + 0.1 * nodes[20], 1e-6);
  EXPECT_EQ(joined.Nodes[2], nodes[50]);
  EXPECT_EQ(joined.Nodes[3], nodes[51]);
  EXPECT_EQ(joined.Intervals[3].Low[3], 0.9f);
  EXPECT_EQ(joined.Intervals[3].High[3], 0.9f);
}

// Zero is exactly zero, however close to it the opacity is elsewhere.
TEST(JoinedIntervals, ClearPartsStayClear)
{
  for (const double scale : { 1.0, 1e-6, 1e-20 })
  {
    const auto opacity = [=](double x) { return scale * std::max({ 0.0, x - 0.6, 0.3 - x }); };
    const Table table =
      Sample(Steps(101), [=](double x, std::size_t) { return Gray(x, opacity(x)); });
    const Table joined = Joined(table);
    EXPECT_LE(joined.Nodes.size(), 8u);
    for (const double x : { 0.32, 0.45, 0.58 })
    {
      const Interval& interval = joined.Intervals[joined.Find(x)];
      EXPECT_EQ(interval.Low[3], 0.0f) << scale;
      EXPECT_EQ(interval.High[3], 0.0f) << scale;
    }
    for (const double x : { 0.1, 0.295, 0.605, 0.9 })
    {
      const double value = joined.At(x, joined.Find(x))[3];
      EXPECT_NEAR(value / opacity(x), 1, opacityTolerance + 1e-4) << scale << " at " << x;
    }
  }
}

TEST(JoinedIntervals, RandomFunctionsKeepTheirNodes)
{
  Random random(72);
  const Table table = Sample(Steps(200),
    [&](double, std::size_t) { return Gray(random.Uniform(), random.Uniform(0.1, 1)); });
  const Table joined = Joined(table);
  EXPECT_EQ(joined.Nodes, table.Nodes);
  for (std::size_t k = 0; k < table.Intervals.size(); ++k)
  {
    EXPECT_EQ(joined.Intervals[k].Low, table.Intervals[k].Low);
    EXPECT_EQ(joined.Intervals[k].High, table.Intervals[k].High);
  }
}

// Nodes added to a piecewise-linear function are all left out again, and no more.
TEST(JoinedIntervals, AddedNodesAreLeftOut)
{
  Random random(73);
  for (int i = 0; i < 50; ++i)
  {
    Table coarse;
    for (int k = 0; k < 10; ++k)
    {
      coarse.Nodes.push_back(k + random.Uniform(-0.3, 0.3));
    }
    double last = 0;
    std::vector<Value> values;
    for (int k = 0; k < 10; ++k)
    {
      last = last > 0.5 ? random.Uniform(0.1, 0.4) : random.Uniform(0.6, 0.9);
      values.push_back(Gray(last, last));
    }
    for (std::size_t k = 0; k <= 10; ++k)
    {
      coarse.Intervals.push_back(
        { values[k == 0 ? 0 : k - 1], values[std::min<std::size_t>(k, 9)] });
    }
    std::vector<double> nodes = coarse.Nodes;
    for (int k = 0; k < 100; ++k)
    {
      nodes.push_back(random.Uniform(coarse.Nodes.front(), coarse.Nodes.back()));
    }
    std::sort(nodes.begin(), nodes.end());
    const Table fine = Sample(nodes, [&](double x, std::size_t k) {
      if (k == 0 || k == nodes.size())
      {
        return k == 0 ? coarse.Intervals.front().Low : coarse.Intervals.back().High;
      }
      return coarse.At(x, coarse.Find(0.5 * nodes[k - 1] + 0.5 * nodes[k]));
    });
    const Table joined = Joined(fine, 1e-6, 1e-6);
    EXPECT_EQ(joined.Nodes, coarse.Nodes);
    EXPECT_EQ(Joined(joined, 1e-6, 1e-6).Nodes, coarse.Nodes);
  }
}

TEST(JoinedIntervals, RangesFarFromZeroAndHuge)
{
  for (const auto& [low, high] : { std::pair<double, double>(-1e12, -1e12 + 1), { 1e15, 1e15 + 64 },
         { -8e307, 8e307 }, { 0, 1e-300 } })
  {
    std::vector<double> nodes = { low };
    for (int i = 1; i <= 32; ++i)
    {
      nodes.push_back(low * (1 - i / 32.0) + high * (i / 32.0));
    }
    const Table table = Sample(nodes, [&](double x, std::size_t) {
      return Gray(0.5, 0.25 + 0.5 * (0.5 * x - 0.5 * low) / (0.5 * high - 0.5 * low));
    });
    EXPECT_EQ(Joined(table).Nodes.size(), 2u) << low;
  }
}

TEST(JoinedIntervals, FewNodes)
{
  const Table one = Sample({ 0.5 }, [](double x, std::size_t) { return Gray(x, x); });
  EXPECT_EQ(Joined(one).Nodes.size(), 1u);
  const Table two = Sample({ 0.5, 0.7 }, [](double x, std::size_t) { return Gray(x, x); });
  EXPECT_EQ(Joined(two).Nodes.size(), 2u);
}
