// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeAir.h"
#include "LevelMotion.h"

#include <gtest/gtest.h>

using namespace nephoscope;

TEST(LevelMotion, DegreesAnHour)
{
  const double radius = 6371000.0;
  EXPECT_NEAR(LongitudeRate(1.0, radius, 1.0), 0.03237558, 1e-7);
  EXPECT_NEAR(LongitudeRate(10.0, radius, 0.5), 0.64751, 1e-5);
  EXPECT_NEAR(LatitudeRate(1.0, radius), 0.03237558, 1e-7);
}

namespace
{
// Pressure on levels that slope and move, p = 1000 + (a + b k) with b and a functions of x and t, and air at level
// k(t) = 2 + .37 t, x(t) = x0 + 3 t.
double Pressure(double x, double k, double t)
{
  return 1000.0 - 100.0 * k + 5.0 * std::sin(0.3 * x + 0.2 * t) - 0.02 * k * k * x;
}

double Derivative(double (*f)(double))
{
  const double h = 1e-5;
  return (f(h) - f(-h)) / (2.0 * h);
}
}

TEST(LevelMotion, TheFullChainRuleGivesTheLevelsOfTheAir)
{
  const double omega = Derivative([](double s) { return Pressure(1.0 + 3.0 * s, 2.0 + 0.37 * s, 4.0 + s); });
  const double onLevel = Derivative([](double s) { return Pressure(1.0, 2.0, 4.0 + s); });
  const double alongWind = Derivative([](double s) { return Pressure(1.0 + 3.0 * s, 2.0, 4.0); });
  const double perLevel = Derivative([](double s) { return Pressure(1.0, 2.0 + s, 4.0); });
  EXPECT_NEAR(LevelRate(omega, onLevel, alongWind, perLevel), 0.37, 1e-8);
  EXPECT_GT(std::abs(omega / perLevel - 0.37), 0.01); // without the slope and the motion of the levels
}

TEST(LevelMotion, HybridLevels)
{
  // p = a + b ps with b = 0.8 on a level.
  EXPECT_NEAR(HybridLevelRate(2.0, 0.8, 0.5, 1.5, -50.0), (2.0 - 0.8 * 0.5 - 0.8 * 1.5) / -50.0, 1e-15);
  EXPECT_EQ(HeldLevel(-0.5, 19), 0.0);
  EXPECT_EQ(HeldLevel(18.5, 19), 18.0);
}

// Following pressure and looking the level up is the chain rule: over a small step, on sloping levels.
TEST(LevelMotion, LookedUpLevelsMoveByTheChainRule)
{
  std::vector<double> longitudes;
  for (int i = 0; i <= 64; ++i)
  {
    longitudes.push_back(i * 2.0 * GlobeColumns::PI / 64.0);
  }
  const GlobeColumns columns(longitudes, { -1.0, -0.5, 0.0, 0.5, 1.0 });
  GlobeAir air;
  const int levels = 4;
  for (int k = 0; k < levels; ++k)
  {
    for (int j = 0; j < 5; ++j)
    {
      for (const double longitude : longitudes)
      {
        air.Levels.push_back(static_cast<float>(100.0 * k + 20.0 * std::sin(longitude)));
      }
    }
  }
  const GlobeAirSampler sampler(columns, levels);
  const auto levelAt = [&](double longitude, double value) {
    const double p[3] = { std::cos(longitude), std::sin(longitude), 0.0 };
    ColumnHint hint;
    std::int32_t k = 0;
    const double above = sampler.FindLevel(air.Levels, sampler.Locate(p, hint), value, k);
    return k + above;
  };
  const double eastward = 1e-3;
  const double rise = 0.5;
  const double moved = levelAt(0.7 + eastward, 150.0 + rise) - levelAt(0.7, 150.0);
  EXPECT_NEAR(moved, LevelRate(rise, 0.0, eastward * 20.0 * std::cos(0.7), 100.0), 2e-5);
}
