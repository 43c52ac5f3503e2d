// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureSets.h"

#include <gtest/gtest.h>

#include <random>

using namespace nephoscope;

TEST(TextureSets, WeightsAddUpToOneAtAnyTime)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1e6, 1e6);
  for (int n = 0; n < 100000; ++n)
  {
    const TextureSets sets{ any(random), 1.0 + std::abs(any(random)) };
    const double time = any(random);
    const double sum = sets.Weight(0, time) + sets.Weight(1, time);
    EXPECT_NEAR(sum, 1.0, 4e-16);
    EXPECT_GE(sets.Weight(0, time), 0.0);
    EXPECT_GE(sets.Weight(1, time), 0.0);
  }
}

TEST(TextureSets, HoursOfThePaper)
{
  const TextureSets sets{ 0.0, 86400.0 };
  for (int hour = 0; hour < 96; ++hour)
  {
    const double time = 3600.0 * hour;
    const int age = hour % 24;
    const int other = (hour + 12) % 24;
    EXPECT_EQ(sets.Age(0, time), 3600.0 * age);
    EXPECT_EQ(sets.Age(1, time), 3600.0 * other);
    EXPECT_NEAR(sets.Weight(0, time), 1.0 - std::abs(age - 12) / 12.0, 4e-16);
    EXPECT_NEAR(sets.Weight(1, time), 1.0 - std::abs(other - 12) / 12.0, 4e-16);
    EXPECT_EQ(sets.Older(time), other > age ? 1 : 0);
  }
}

TEST(TextureSets, ASetIsReplacedWhereItWeighsNothing)
{
  const TextureSets sets{ 137.0, 1000.0 };
  for (int n = -5; n < 5; ++n)
  {
    for (int set = 0; set < 2; ++set)
    {
      const double birth = 137.0 + 1000.0 * n + 500.0 * set;
      EXPECT_EQ(sets.Birth(set, birth), birth);
      EXPECT_EQ(sets.Weight(set, birth), 0.0);
      EXPECT_NEAR(sets.Weight(set, birth - 1e-6), 0.0, 1e-8);
      EXPECT_EQ(sets.Birth(set, birth - 1e-6), birth - 1000.0);
    }
  }
}

TEST(TextureSets, OddPeriodsHaveAgesWithinThem)
{
  const TextureSets sets{ 0.1, 0.3 };
  for (int n = -1000; n < 1000; ++n)
  {
    for (int set = 0; set < 2; ++set)
    {
      const double age = sets.Age(set, 0.05 * n);
      EXPECT_GE(age, 0.0);
      EXPECT_LT(age, 0.3);
    }
  }
}

TEST(TextureSets, StartFromTheGridWhereTheyAreToldTo)
{
  TextureSets sets{ 100.0, 1000.0, true };
  EXPECT_EQ(sets.Origin(0, 100.0), 100.0);
  EXPECT_EQ(sets.Origin(1, 100.0), 100.0); // half a period old, and the grid itself
  EXPECT_EQ(sets.Weight(1, 100.0), TextureSets{ 100.0 }.Weight(1, 100.0));
  EXPECT_EQ(sets.Origin(1, 599.0), 100.0);
  EXPECT_EQ(sets.Origin(1, 600.0), 600.0); // its next birth
  EXPECT_EQ(sets.Origin(0, 50.0), 50.0);   // before the start nothing has moved
  sets.FromGrid = false;
  EXPECT_EQ(sets.Origin(1, 100.0), -400.0);
}

TEST(KeyAges, WithoutAnIntervalEveryAgeIsAKey)
{
  const KeyAges keys = KeyAgesAround(123.0, 0.0, 1000.0);
  EXPECT_EQ(keys.First, 123.0);
  EXPECT_EQ(keys.Weight, 0.0);
}

TEST(KeyAges, BracketTheAgeAndEndAtDeath)
{
  for (int n = 0; n < 1000; ++n)
  {
    const double age = n;
    const KeyAges keys = KeyAgesAround(age, 300.0, 1000.0);
    EXPECT_LE(keys.First, age);
    EXPECT_GE(keys.Second, age);
    EXPECT_LE(keys.Second, 1000.0);
    EXPECT_NEAR((1.0 - keys.Weight) * keys.First + keys.Weight * keys.Second, age, 1e-12);
    EXPECT_EQ(keys.First, 300.0 * std::floor(age / 300.0));
  }
  EXPECT_EQ(KeyAgesAround(950.0, 300.0, 1000.0).Second, 1000.0);
  EXPECT_EQ(KeyAgesAround(600.0, 300.0, 1000.0).Weight, 0.0);
}
