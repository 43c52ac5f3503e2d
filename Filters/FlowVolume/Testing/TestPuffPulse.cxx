// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PuffPulse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using nephoscope::PuffPulse;

namespace
{
// Widths and floors of all kinds, for a period that is no round number.
std::vector<PuffPulse> Pulses()
{
  std::vector<PuffPulse> pulses;
  for (const double width : { 0.05, 0.3, 0.5, 0.99, 1.0 })
  {
    for (const double floor : { 0.0, 0.1, 0.7, 1.0 })
    {
      PuffPulse pulse;
      pulse.Period = 3.7;
      pulse.Width = width;
      pulse.Floor = floor;
      pulse.Scale = 1.3;
      pulses.push_back(pulse);
    }
  }
  return pulses;
}
}

TEST(PuffPulse, ByHand)
{
  PuffPulse pulse;
  pulse.Period = 8.0;
  pulse.Width = 0.5; // 4 s from end to end
  pulse.Floor = 0.2;
  EXPECT_DOUBLE_EQ(pulse(0.0, 0.0), 1.0);   // the crest
  EXPECT_NEAR(pulse(1.0, 0.0), 0.6, 1e-15); // half way down: 0.2 + 0.8 / 2
  EXPECT_NEAR(pulse(-1.0, 0.0), 0.6, 1e-15);
  EXPECT_DOUBLE_EQ(pulse(2.0, 0.0), 0.2); // the end
  EXPECT_DOUBLE_EQ(pulse(4.0, 0.0), 0.2); // between two puffs
  EXPECT_DOUBLE_EQ(pulse(8.0, 0.0), 1.0); // the next one
}

TEST(PuffPulse, IsPeriodicInAgeAndTime)
{
  for (const PuffPulse& pulse : Pulses())
  {
    for (double age = 0.0; age < 12.0; age += 0.173)
    {
      for (const double time : { 0.0, 0.91, 5.0 })
      {
        const double here = pulse(age, time);
        EXPECT_NEAR(pulse(age + 3.0 * pulse.Period, time), here, 1e-12);
        EXPECT_NEAR(pulse(age, time + pulse.Period), here, 1e-12);
        EXPECT_NEAR(pulse(age, time - 5.0 * pulse.Period), here, 1e-12);
      }
    }
  }
}

// Smoke that ages as time passes keeps its pulse: crests move with the flow, not against it or at
// another speed.
TEST(PuffPulse, MovesWithTheSmoke)
{
  for (const PuffPulse& pulse : Pulses())
  {
    for (double passed = 0.0; passed < 20.0; passed += 0.31)
    {
      EXPECT_NEAR(pulse(0.6 + passed, passed), pulse(0.6, 0.0), 1e-12);
    }
  }
}

// Midpoints of equal intervals integrate smooth periodic functions; the C1 shape leaves an error of
// second order at least.
TEST(PuffPulse, HasTheMeanStated)
{
  for (const PuffPulse& pulse : Pulses())
  {
    const int count = 20000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
      sum += pulse((i + 0.5) * pulse.Period / count, 0.4);
    }
    EXPECT_NEAR(sum / count, pulse.Mean(), 1e-8) << pulse.Width << " " << pulse.Floor;
  }
}

TEST(PuffPulse, StaysBetweenFloorAndCrest)
{
  for (const PuffPulse& pulse : Pulses())
  {
    double low = 1e9, high = -1e9;
    for (double age = 0.0; age < pulse.Period; age += 1e-3)
    {
      low = std::min(low, pulse(age, 0.0));
      high = std::max(high, pulse(age, 0.0));
    }
    EXPECT_NEAR(high, pulse.Scale, 1e-12);
    EXPECT_GE(low, pulse.Scale * pulse.Floor - 1e-12);
    EXPECT_NEAR(low, pulse.Scale * pulse.Floor, pulse.Width < 1.0 ? 1e-12 : 1e-6);
  }
}

// The derivative is continuous: over a step h it changes by no more than h times the largest second
// derivative, scale (1 - floor) 2 pi^2 / (width period)^2; everywhere, so also at the ends of a
// puff and where the period closes.
TEST(PuffPulse, IsSmooth)
{
  for (const PuffPulse& pulse : Pulses())
  {
    const double h = 1e-4 * pulse.Width * pulse.Period;
    const double length = pulse.Width * pulse.Period;
    const double bend = pulse.Scale * (1.0 - pulse.Floor) * 2.0 * 9.8696044 / (length * length);
    for (double age = -pulse.Period; age < pulse.Period; age += 0.5 * h)
    {
      const double change = pulse(age + h, 0.0) - 2.0 * pulse(age, 0.0) + pulse(age - h, 0.0);
      ASSERT_LE(std::abs(change), 1.0001 * bend * h * h + 1e-14) << pulse.Width << " at " << age;
    }
  }
}

// Seconds since 1970, or since the year 1: still the same pulse, to the digits that such a time
// has.
TEST(PuffPulse, KeepsItsDigitsAtLateTimes)
{
  PuffPulse pulse;
  pulse.Period = 1.0 / 3.0;
  for (const double time : { 1.3e9, 6.3e10 })
  {
    EXPECT_NEAR(pulse(std::remainder(time, pulse.Period) + 0.05, time), pulse(0.05, 0.0), 1e-12);
  }
}
