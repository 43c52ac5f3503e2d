// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Textures of vector splats: coverage of segments, motion and mean of streaks. */
#include "VectorTexture.h"

#include <gtest/gtest.h>

using namespace nephoscope;

TEST(LineSegment, CoverageIntegratesToItsArea)
{
  const LineSegment segment{ 3.0, 0.7, 0.5 };
  EXPECT_NEAR(SegmentCoverage(segment, 0.0, 0.0), 0.514679405, 1e-9);
  double sum = 0.0;
  const double h = 0.02;
  for (double x = -6.0; x < 6.0; x += h)
  {
    for (double y = -5.0; y < 5.0; y += h)
    {
      sum += h * h * SegmentCoverage(segment, x, y);
    }
  }
  EXPECT_NEAR(sum, 3.0 * 0.7, 1e-6);
}

TEST(Streaks, MoveAlongTheVectorAndLoop)
{
  for (double x = -1.2; x < 1.2; x += 0.13)
  {
    for (double y = -1.0; y < 1.0; y += 0.17)
    {
      EXPECT_NEAR(VectorTexture(x, y, 0.8, 0.0), VectorTexture(x, y, 0.8, 1.0), 1e-12);
      // What was at x is at x + period * dphi a phase step later.
      EXPECT_NEAR(
        streaks::Value(x / 0.8 - 0.3, y), streaks::Value((x + 0.8 * 0.1) / 0.8 - 0.4, y), 1e-12);
    }
  }
}

TEST(Streaks, MeanOverACycleIsTheSameEverywhereAlong)
{
  const auto mean = [](double x, double y) {
    double sum = 0.0;
    for (int k = 0; k < 16; ++k)
    {
      sum += streaks::Value(x - k / 16.0, y) / 16.0;
    }
    return sum;
  };
  for (double y = -0.9; y < 1.0; y += 0.1)
  {
    EXPECT_NEAR(mean(0.0, y), mean(0.37, y), 1e-12);
  }
  EXPECT_NEAR(mean(0.0, 0.0), 3.0 / 8.0, 1e-12); // of a squared raised cosine
}

TEST(Streaks, StayBetweenZeroAndOneWithoutJumps)
{
  double last = streaks::Value(0.2, -1.5);
  for (double y = -1.5; y < 1.5; y += 0.001)
  {
    const double value = streaks::Value(0.2, y);
    EXPECT_GE(value, 0.0);
    EXPECT_LE(value, 1.0);
    EXPECT_LT(std::abs(value - last), 0.25) << y; // where two streaks meet both are faint
    last = value;
  }
}

TEST(Phase, DoesNotJumpWhenTheWindChanges)
{
  double phase = 0.0, place = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const double speed = i < 50 ? 0.3 : 0.7;
    phase = AdvancePhase(phase, speed, 0.8, 0.05);
    place += speed * 0.05 / 0.8;
  }
  EXPECT_NEAR(phase, place - std::floor(place), 1e-12);
  EXPECT_NEAR(AdvancePhase(0.1, -1.0, 1.0, 0.3), 0.8, 1e-12);
}
