// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackwardPaths.h"

#include <gtest/gtest.h>

using namespace nephoscope;

namespace
{
std::vector<PathStep> StepsOf(
  const TimeSeries& series, double start, const std::vector<double>& stops, double step)
{
  std::vector<PathStep> steps;
  std::vector<std::size_t> arrivals;
  const bool done = FollowBack(
    series, start, stops, step,
    [&](const PathStep& s) {
      steps.push_back(s);
      return true;
    },
    [&](std::size_t i) { arrivals.push_back(i); });
  EXPECT_TRUE(done);
  EXPECT_EQ(arrivals.size(), stops.size());
  return steps;
}
}

TEST(TimeSeries, FindsNeighbours)
{
  const TimeSeries series({ 0.0, 10.0, 30.0 });
  EXPECT_EQ(series.Find(-5.0).Earlier, 0);
  EXPECT_EQ(series.Find(-5.0).Later, 0);
  EXPECT_EQ(series.Find(10.0).Earlier, 1);
  EXPECT_EQ(series.Find(10.0).Later, 1);
  EXPECT_EQ(series.Find(15.0).Earlier, 1);
  EXPECT_EQ(series.Find(15.0).Later, 2);
  EXPECT_EQ(series.Find(15.0).Fraction, 0.25);
  EXPECT_EQ(series.Find(99.0).Earlier, 2);
  EXPECT_EQ(series.Find(99.0).Later, 2);
}

TEST(BackwardPaths, StepsJoinAndStayWithinIntervals)
{
  const TimeSeries series({ 0.0, 10.0, 30.0, 31.0 });
  for (const double step : { 0.7, 3.0, 5.0, 10.0, 100.0 })
  {
    const auto steps = StepsOf(series, 45.5, { 29.5, -12.25 }, step);
    double now = 45.5;
    for (const PathStep& s : steps)
    {
      EXPECT_EQ(s.From, now);
      EXPECT_LT(s.To, s.From);
      EXPECT_LE(s.From - s.To, step * (1.0 + 1e-9));
      const double low = series.Time(s.Interval.Earlier);
      const double high = series.Time(s.Interval.Later);
      if (s.Interval.Earlier == s.Interval.Later)
      {
        EXPECT_TRUE(s.From <= 0.0 || s.To >= 31.0);
        EXPECT_EQ(s.FromFraction, 0.0);
      }
      else
      {
        EXPECT_GE(s.To, low);
        EXPECT_LE(s.From, high);
        EXPECT_NEAR(low + s.FromFraction * (high - low), s.From, 1e-12);
        EXPECT_NEAR(low + s.ToFraction * (high - low), s.To, 1e-12);
      }
      now = s.To;
    }
    EXPECT_EQ(now, -12.25);
  }
}

TEST(BackwardPaths, HourlyWindsHaveHourlySteps)
{
  std::vector<double> times;
  for (int h = 0; h <= 48; ++h)
  {
    times.push_back(3600.0 * h);
  }
  const auto steps = StepsOf(TimeSeries(times), 30 * 3600.0, { 24 * 3600.0, 12 * 3600.0 }, 3600.0);
  ASSERT_EQ(steps.size(), 18U);
  for (const PathStep& s : steps)
  {
    EXPECT_EQ(s.FromFraction, 1.0);
    EXPECT_EQ(s.ToFraction, 0.0);
  }
  EXPECT_EQ(StepsOf(TimeSeries(times), 30.25 * 3600.0, { 24 * 3600.0 }, 3600.0).size(), 7U);
}

TEST(BackwardPaths, ASteadyWindHasOneTime)
{
  const auto steps = StepsOf(TimeSeries({ 0.0 }), 7200.0, { -3600.0 }, 3600.0);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[1].To, 0.0);
}

TEST(BackwardPaths, StepsAnywhereDoNotDependOnTheStart)
{
  const TimeSeries series({ 0.0, 7.0, 11.0 });
  const auto early = StepsOf(series, 10.0, { 0.0 }, 1.9);
  const auto late = StepsOf(series, 10.7, { 0.0 }, 1.9);
  EXPECT_EQ(early.back().From, late.back().From);
  EXPECT_EQ(early[early.size() - 2].From, late[late.size() - 2].From);
}

TEST(BackwardPaths, CanBeStopped)
{
  int taken = 0;
  EXPECT_FALSE(FollowBack(
    TimeSeries({ 0.0 }), 10.0, { 0.0 }, 1.0, [&](const PathStep&) { return ++taken < 3; },
    [](std::size_t) { FAIL(); }));
  EXPECT_EQ(taken, 3);
}
