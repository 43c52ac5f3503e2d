// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance between rays, on drivers whose pictures take a fixed time and a time per ray.
#include "SampleDistance.h"

#include <gtest/gtest.h>

#include <cmath>

using nephoscope::SampleDistance;

namespace
{
constexpr double atRest = 1e4; // seconds

/** Times of pictures, in turn slower and faster by a fraction. */
struct Driver
{
  double Fixed, Rays, Noise = 0;
  int Pictures = 0;

  double Draw(SampleDistance& chosen, double seconds, double most = 8)
  {
    const double distance = chosen.Choose(seconds, most);
    const double sign = this->Pictures++ % 2 ? 1 : -1;
    const double time =
      (this->Fixed + this->Rays / (distance * distance)) * (1 + sign * this->Noise);
    chosen.Measure(this->Pictures == 1 ? time + 3 : time, distance); // shaders are compiled
    return distance;
  }
};

TEST(SampleDistance, IsOneAtRest)
{
  SampleDistance chosen;
  Driver driver = { 0.01, 5 };
  for (const double seconds : { atRest, 0.1, 0.1, 0.1, atRest })
  {
    EXPECT_EQ(driver.Draw(chosen, seconds) == 1, seconds == atRest || driver.Pictures <= 1);
  }
}

// From the third picture of a movement on, though the only picture before was the one that compiled
// shaders; and it stays.
TEST(SampleDistance, IsTheSmallestThatIsFastEnough)
{
  for (const double fixed : { 0.0, 0.02 })
  {
    for (const double rays : { 0.01, 0.1, 0.2, 0.5, 1.0, 3.0 })
    {
      SampleDistance chosen;
      Driver driver = { fixed, rays };
      driver.Draw(chosen, atRest);
      driver.Draw(chosen, 0.1);
      driver.Draw(chosen, 0.1);
      const double distance = driver.Draw(chosen, 0.1);
      const auto time = [&](double d) { return fixed + rays / (d * d); };
      EXPECT_LE(time(distance), 0.1 + 1e-9) << fixed << " " << rays;
      for (const double finer : SampleDistance::Steps)
      {
        EXPECT_TRUE(finer >= distance || time(finer) > 0.1 / 1.6) << fixed << " " << rays;
      }
      for (int i = 0; i < 10; ++i)
      {
        EXPECT_EQ(driver.Draw(chosen, 0.1), distance) << fixed << " " << rays;
      }
    }
  }
}

TEST(SampleDistance, IsSteadyWhereTimesAreNot)
{
  for (const double rays : { 0.1, 0.2, 0.37, 0.4, 0.6, 0.85, 1.5 })
  {
    SampleDistance chosen;
    Driver driver = { 0, rays, 0.1 };
    driver.Draw(chosen, atRest);
    driver.Draw(chosen, atRest);
    int changes = 0;
    double last = 0;
    for (int i = 0; i < 40; ++i)
    {
      const double distance = driver.Draw(chosen, 0.1);
      changes += i > 5 && distance != last;
      last = distance;
    }
    EXPECT_EQ(changes, 0) << rays;
  }
}

// What takes long besides the rays is no reason to see less.
TEST(SampleDistance, StaysSmallWhereRaysAreNotWhatTakesLong)
{
  SampleDistance chosen;
  Driver driver = { 0.5, 0.1 };
  for (int movement = 0; movement < 3; ++movement)
  {
    driver.Draw(chosen, atRest);
    driver.Draw(chosen, atRest);
    for (int i = 0; i < 5; ++i)
    {
      driver.Draw(chosen, 0.1);
    }
  }
  EXPECT_EQ(driver.Draw(chosen, 0.1), 1);
}

// The machine did something else.
TEST(SampleDistance, GetsOverOneSlowPicture)
{
  for (int slow = 1; slow < 12; ++slow)
  {
    SampleDistance chosen;
    Driver driver = { 0.01, 2 };
    for (int i = 0; i < 12; ++i)
    {
      driver.Fixed = i == slow ? 2.5 : 0.01;
      driver.Draw(chosen, i % 6 < 2 ? atRest : 0.1);
    }
    driver.Draw(chosen, 0.1);
    driver.Draw(chosen, 0.1);
    EXPECT_GE(driver.Draw(chosen, 0.1), 4) << slow;
  }
}

TEST(SampleDistance, IsNeverMoreThanAsked)
{
  SampleDistance chosen;
  Driver driver = { 0.0, 1000 };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_LE(driver.Draw(chosen, 0.1, 5), 5);
  }
  EXPECT_EQ(driver.Draw(chosen, 0.1, 5), 5);
  EXPECT_EQ(driver.Draw(chosen, 0.1, 16), 16);
  EXPECT_EQ(driver.Draw(chosen, 0.1, 1), 1);
}

// A view from nearer, which costs more, and back.
TEST(SampleDistance, FollowsTheView)
{
  SampleDistance chosen;
  Driver driver = { 0.0, 0.3 };
  driver.Draw(chosen, atRest);
  driver.Draw(chosen, atRest);
  driver.Draw(chosen, 0.1);
  EXPECT_EQ(driver.Draw(chosen, 0.1), 2);
  driver.Rays = 2.0;
  driver.Draw(chosen, 0.1);
  driver.Draw(chosen, 0.1);
  EXPECT_EQ(driver.Draw(chosen, 0.1), 6);
  driver.Rays = 0.05;
  driver.Draw(chosen, 0.1);
  driver.Draw(chosen, 0.1);
  EXPECT_EQ(driver.Draw(chosen, 0.1), 1);
}
}
