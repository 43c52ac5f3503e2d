// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Steps on the sphere in winds of which the paths are known.
#include "SphereSteps.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

using namespace nephoscope;

namespace
{
constexpr double PI = 3.14159265358979323846;
constexpr double EARTH_KM = 6371.22;

using Wind = std::function<SphereRates(const double*, double)>; // at a time

SphereState At(double longitude, double latitude)
{
  return { { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
             std::sin(latitude) },
    0.0 };
}

SphereRates Turning(const double axis[3], const double p[3])
{
  return { { axis[1] * p[2] - axis[2] * p[1], axis[2] * p[0] - axis[0] * p[2],
             axis[0] * p[1] - axis[1] * p[0] },
    0.0 };
}

// Rodrigues' formula, for an axis of unit length.
SphereState Turned(const SphereState& from, const double axis[3], double angle)
{
  const double* p = from.Direction;
  const SphereRates cross = Turning(axis, p);
  const double along = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
  SphereState to = from;
  for (int c = 0; c < 3; ++c)
  {
    to.Direction[c] = p[c] * std::cos(angle) + cross.Direction[c] * std::sin(angle) +
      axis[c] * along * (1.0 - std::cos(angle));
  }
  return to;
}

double AngleBetween(const SphereState& a, const SphereState& b)
{
  const double d[3] = { a.Direction[0] - b.Direction[0], a.Direction[1] - b.Direction[1],
    a.Direction[2] - b.Direction[2] };
  return 2.0 * std::asin(std::min(1.0, 0.5 * LengthOf(d)));
}

enum Method
{
  EULER,
  RK4,
  ADAPTIVE
};

SphereState Follow(
  SphereState state, const Wind& wind, double from, double to, int steps, Method method)
{
  const double h = (to - from) / steps;
  for (int n = 0; n < steps; ++n)
  {
    const auto motion = [&](const SphereState& s, double f) {
      return wind(s.Direction, from + (n + f) * h);
    };
    state = method == EULER ? EulerStep(state, h, motion)
      : method == RK4       ? RungeKutta4Step(state, h, motion)
                            : AdaptiveStep(state, h, 1e-10, 0.0, 0.1, motion);
  }
  return state;
}

// Nair and Lauritzen's deforming wind: what starts anywhere is back at time 5.
SphereRates NairLauritzen(const double* p, double t)
{
  const double length = LengthOf(p);
  const double longitude = std::atan2(p[1], p[0]);
  const double latitude = std::asin(std::max(-1.0, std::min(1.0, p[2] / length)));
  const double T = 5.0;
  const double k = 10.0 / T;
  const double moved = longitude - 2.0 * PI * t / T;
  const double u =
    k * std::sin(moved) * std::sin(moved) * std::sin(2.0 * latitude) * std::cos(PI * t / T) +
    2.0 * PI / T * std::cos(latitude);
  const double v = k * std::sin(2.0 * moved) * std::cos(latitude) * std::cos(PI * t / T);
  return { { length * (-u * std::sin(longitude) - v * std::sin(latitude) * std::cos(longitude)),
             length * (u * std::cos(longitude) - v * std::sin(latitude) * std::sin(longitude)),
             length * v * std::cos(latitude) },
    0.0 };
}
}

TEST(SphereSteps, OverThePoleInADay)
{
  // A turn over the poles in 12 days, 24 hours back in steps of an hour.
  const double axis[3] = { 1.0, 0.0, 0.0 };
  const double rate = -2.0 * PI / 12.0;
  const Wind wind = [&](const double* p, double) {
    const double a[3] = { rate, 0.0, 0.0 };
    return Turning(a, p);
  };
  double worst[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 72; ++i)
  {
    for (int j = -18; j <= 18; ++j)
    {
      const SphereState start = At(i * PI / 36.0, j * PI / 36.0);
      const SphereState exact = Turned(start, axis, -rate);
      for (const Method method : { EULER, RK4, ADAPTIVE })
      {
        worst[method] = std::max(
          worst[method], EARTH_KM * AngleBetween(Follow(start, wind, 1.0, 0.0, 24, method), exact));
      }
    }
  }
  EXPECT_LT(worst[RK4], 1e-5);
  EXPECT_GT(worst[RK4], 1e-7);
  EXPECT_LT(worst[ADAPTIVE], 1e-3);
  EXPECT_GT(worst[EULER], 10.0);
  EXPECT_LT(worst[EULER], 20.0);
}

TEST(SphereSteps, LengthStays)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int n = 0; n < 1000; ++n)
  {
    const SphereState end =
      Follow(At(any(random), 0.5 * any(random)), NairLauritzen, 0.0, 5.0, 7, RK4);
    EXPECT_NEAR(LengthOf(end.Direction), 1.0, 4e-16);
  }
}

TEST(SphereSteps, EulerGoesAlongAGreatCircle)
{
  const double axis[3] = { 0.0, 0.0, 1.0 };
  const Wind wind = [&](const double* p, double) { return Turning(axis, p); };
  const SphereState end = Follow(At(0.0, 0.0), wind, 0.0, 2.5, 3, EULER);
  EXPECT_LT(AngleBetween(end, At(2.5, 0.0)), 1e-15);
}

TEST(SphereSteps, PointsOfNairAndLauritzen)
{
  const SphereState first = Follow(At(0.75 * PI, 0.0), NairLauritzen, 0.0, 2.5, 2000, RK4);
  EXPECT_LT(AngleBetween(first, At(4.506115702, 0.763498487)), 2e-9);
  const SphereState second = Follow(At(PI / 3.0, PI / 4.0), NairLauritzen, 0.0, 2.5, 2000, RK4);
  EXPECT_LT(AngleBetween(second, At(4.355220515, -0.858435686)), 2e-9);
}

TEST(SphereSteps, NairAndLauritzenReturnAtTheirOrder)
{
  const auto worst = [](Method method, int steps) {
    double found = 0.0;
    for (int i = 0; i < 24; ++i)
    {
      for (int j = -5; j <= 5; ++j)
      {
        const SphereState start = At((i + 0.5) * PI / 12.0, j * PI / 12.0);
        found = std::max(
          found, AngleBetween(Follow(start, NairLauritzen, 0.0, 5.0, steps, method), start));
      }
    }
    return found;
  };
  const double euler[2] = { worst(EULER, 240), worst(EULER, 480) };
  EXPECT_NEAR(std::log2(euler[0] / euler[1]), 1.0, 0.2);
  EXPECT_NEAR(euler[1], 0.094, 0.03);
  const double runge[3] = { worst(RK4, 60), worst(RK4, 120), worst(RK4, 240) };
  EXPECT_NEAR(std::log2(runge[0] / runge[1]), 4.0, 0.5);
  EXPECT_NEAR(std::log2(runge[1] / runge[2]), 4.0, 0.3);
  EXPECT_LT(runge[2], 3e-7);
  EXPECT_LT(worst(ADAPTIVE, 5), 1e-7);
}

TEST(SphereSteps, LevelsFollowTheirRate)
{
  const auto motion = [](const SphereState& s, double) {
    return SphereRates{ { 0.0, 0.0, 0.0 }, -0.5 * s.Level };
  };
  SphereState state = At(0.0, 0.0);
  state.Level = 1.0;
  EXPECT_EQ(EulerStep(state, 1.0, motion).Level, 0.5);
  const double h = 0.5; // h times the rate
  EXPECT_NEAR(RungeKutta4Step(state, 1.0, motion).Level,
    1.0 - h + h * h / 2.0 - h * h * h / 6.0 + h * h * h * h / 24.0, 1e-15);
  EXPECT_NEAR(AdaptiveStep(state, 1.0, 1e-12, 1.0, 1.0, motion).Level, std::exp(-0.5), 1e-10);
}
