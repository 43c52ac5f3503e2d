// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Haze along rays against given values and quadrature, in double and in float. */
#include "Haze.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

using namespace nephoscope;
using nephoscope_test::Random;

namespace
{
constexpr double earth = 6371;

struct Ray
{
  std::array<double, 3> P, Q;
};

/** From altitude h1 with the sine of elevation over a length. */
Ray MakeRay(double h1, double sine, double length)
{
  const double cosine = std::sqrt(1 - sine * sine);
  return { { { 0, 0, earth + h1 } },
    { { 0.6 * length * cosine, 0.8 * length * cosine, earth + h1 + length * sine } } };
}

double Quadrature(const Ray& ray, double scaleHeight)
{
  const int steps = 40000;
  double length = 0;
  for (int c = 0; c < 3; ++c)
  {
    length += (ray.Q[c] - ray.P[c]) * (ray.Q[c] - ray.P[c]);
  }
  length = std::sqrt(length);
  double sum = 0;
  for (int i = 0; i <= steps; ++i)
  {
    const double t = i / double(steps);
    double square = 0;
    for (int c = 0; c < 3; ++c)
    {
      const double x = ray.P[c] + t * (ray.Q[c] - ray.P[c]);
      square += x * x;
    }
    const double weight = i == 0 || i == steps ? 1 : i % 2 ? 4 : 2;
    sum += weight * std::exp(-(std::sqrt(square) - earth) / scaleHeight);
  }
  return sum * length / steps / 3;
}

/** In the unit of the ray; in float the eye's altitude and the ray alone are rounded. */
template <typename Real>
Real Haze(const Ray& ray, double scaleHeight)
{
  HazePlace<Real> from;
  HazeVector<Real> step;
  double squares = 0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    from.FromCenter[c] = Real(ray.P[c] / scaleHeight);
    step[c] = Real((ray.Q[c] - ray.P[c]) / scaleHeight);
    squares += ray.P[c] * ray.P[c];
  }
  from.Radius = Real(std::sqrt(squares) / scaleHeight);
  from.Altitude = Real((std::sqrt(squares) - earth) / scaleHeight);
  return Real(scaleHeight) * GlobeHazeLength(from, step);
}

template <typename Real>
Real HazeToSky(const Ray& ray, double scaleHeight)
{
  HazePlace<Real> from;
  HazeVector<Real> direction;
  double squares = 0, length = 0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    squares += ray.P[c] * ray.P[c];
    length += (ray.Q[c] - ray.P[c]) * (ray.Q[c] - ray.P[c]);
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    from.FromCenter[c] = Real(ray.P[c] / scaleHeight);
    direction[c] = Real((ray.Q[c] - ray.P[c]) / std::sqrt(length));
  }
  from.Radius = Real(std::sqrt(squares) / scaleHeight);
  from.Altitude = Real((std::sqrt(squares) - earth) / scaleHeight);
  return Real(scaleHeight) * GlobeHazeLengthToSky(from, direction);
}
}

TEST(Haze, HasTheGivenValues)
{
  EXPECT_NEAR(Haze<double>(MakeRay(0, 0, 500), 8), 275.448612591889, 2e-4 * 275);
  EXPECT_NEAR(Haze<double>(MakeRay(0, 0.1, 100), 8), 55.8060243300098, 2e-4 * 56);
  EXPECT_NEAR(Haze<double>(MakeRay(5, -0.03, 400), 2), 90.00686193061898, 2e-4 * 90);
  EXPECT_NEAR(Haze<double>(MakeRay(10, 0, 800), 8), 81.13463000805936, 2e-4 * 81);
}

TEST(Haze, LimbIsThatOfAnInfiniteRay)
{
  const Ray limb{ { { -40000, 0, earth } }, { { 40000, 0, earth } } };
  EXPECT_NEAR(Haze<double>(limb, 8) / 566.1651122833583, 1, 1e-6);
  EXPECT_NEAR(Haze<float>(limb, 8) / 566.1651122833583, 1, 1e-4);
}

TEST(Haze, AgreesWithQuadratureUpAndDown)
{
  Random random(1);
  for (int i = 0; i < 300; ++i)
  {
    const double scaleHeight = random.Uniform(2, 10);
    const Ray ray = MakeRay(random.Uniform(0, 25),
      i % 5 ? std::pow(random.Uniform(), 2) : random.Uniform(), random.LogUniform(1, 1600));
    const Ray back{ ray.Q, ray.P };
    const double exact = Quadrature(ray, scaleHeight);
    EXPECT_NEAR(Haze<double>(ray, scaleHeight) / exact, 1, 2e-4);
    EXPECT_NEAR(Haze<double>(back, scaleHeight), Haze<double>(ray, scaleHeight), 1e-6 * exact);
    EXPECT_NEAR(Haze<float>(ray, scaleHeight), exact, 3e-4 * exact + 2e-3) << "in float";
  }
}

TEST(Haze, AgreesWithQuadraturePastTheHorizon)
{
  Random random(2);
  for (int i = 0; i < 100; ++i)
  {
    const double low = random.Uniform(0, 10);
    const double s1 = -random.Uniform(1, 600), s2 = random.Uniform(1, 600);
    const Ray ray{ { { s1, 0, earth + low } }, { { s2, 0, earth + low } } };
    EXPECT_NEAR(Haze<double>(ray, 8) / Quadrature(ray, 8), 1, 1e-5);
    EXPECT_NEAR(Haze<float>(ray, 8) / Quadrature(ray, 8), 1, 3e-4) << "in float";
  }
}

TEST(Haze, SeenFromSpaceIsFiniteInFloat)
{
  Random random(3);
  for (int i = 0; i < 300; ++i)
  {
    const auto eye = random.Direction();
    const auto ground = random.Direction();
    Ray ray;
    for (std::size_t c = 0; c < 3; ++c)
    {
      ray.P[c] = 26000 * eye[c];
      ray.Q[c] = (earth + 5) * ground[c];
    }
    const float x = Haze<float>(ray, 8);
    EXPECT_TRUE(std::isfinite(x) && x >= 0) << x;
    if (eye[0] * ground[0] + eye[1] * ground[1] + eye[2] * ground[2] >
      0.3) // the ray does not pass through the planet
    {
      EXPECT_NEAR(x / Quadrature(ray, 8), 1, 3e-3);
    }
  }
  EXPECT_EQ(Haze<float>(MakeRay(0, 0, 0), 8), 0);
}

TEST(Haze, FlatGround)
{
  for (const double h1 : { 0.0, 3.0, 20.0 })
  {
    for (const double h2 : { 0.0, 1e-6, 3.0, 3.1, 30.0, 500.0 })
    {
      double sum = 0;
      const int steps = 20000;
      for (int i = 0; i < steps; ++i)
      {
        sum += std::exp(-(h1 + (h2 - h1) * (i + 0.5) / steps) / 8) * 700 / steps;
      }
      EXPECT_NEAR(8 * FlatHazeLength(h1 / 8, h2 / 8, 700.0 / 8) / sum, 1, 1e-4);
      EXPECT_NEAR(8 * FlatHazeLength(float(h1 / 8), float(h2 / 8), 700.0f / 8) / sum, 1, 1e-4);
    }
  }
}

// A fog of 100 m on the Earth: radii in float are known to half a metre, altitudes must be better.
TEST(Haze, ThinFogIsExactInFloat)
{
  Random random(4);
  for (int i = 0; i < 300; ++i)
  {
    const Ray ray =
      MakeRay(random.Uniform(0, 0.3), random.Uniform(-0.02, 0.02), random.LogUniform(0.01, 60));
    const double exact = Quadrature(ray, 0.1);
    EXPECT_NEAR(Haze<double>(ray, 0.1) / exact, 1, 1e-4);
    EXPECT_NEAR(Haze<float>(ray, 0.1), exact, 1e-3 * exact + 1e-5) << "in float";
  }
}

TEST(Haze, OfTheSkyEndsWhereThereIsNone)
{
  Random random(5);
  for (int i = 0; i < 200; ++i)
  {
    const double scaleHeight = random.Uniform(2, 10);
    const Ray up = MakeRay(random.Uniform(0, 50), std::pow(random.Uniform(), 3), 4000);
    const double exact = Quadrature(up, scaleHeight);
    EXPECT_NEAR(HazeToSky<double>(up, scaleHeight), exact, 5e-3 * exact + 1e-6);
    EXPECT_NEAR(HazeToSky<float>(up, scaleHeight), exact, 5e-3 * exact + 1e-3) << "in float";
  }
  // From space, past the planet and down to it.
  for (const double lowest : { 0.5, 4.0, 30.0 })
  {
    const double sine = -std::sqrt(1 - std::pow((earth + lowest) / (earth + 20000), 2));
    const Ray limb = MakeRay(20000, sine, 60000);
    const double exact = Quadrature(limb, 8);
    EXPECT_NEAR(HazeToSky<double>(limb, 8) / exact, 1, 1e-3);
    EXPECT_NEAR(HazeToSky<float>(limb, 8) / exact, 1, 5e-3) << "in float";
  }
  const Ray down = MakeRay(20000, -1, 20000);
  EXPECT_NEAR(HazeToSky<float>(down, 8), 8, 0.02);
  EXPECT_EQ(HazeToSky<float>(MakeRay(20000, 0.1, 100), 8), 0) << "away from the planet";
}

TEST(Haze, OfTheSkyOverFlatGround)
{
  EXPECT_NEAR(FlatHazeLengthToSky(0.0, 0.5), 2, 1e-12);
  EXPECT_NEAR(FlatHazeLengthToSky(1.0, 1.0), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(FlatHazeLengthToSky(1.0, -1.0), 1 - std::exp(-1.0), 1e-12);
  EXPECT_GT(FlatHazeLengthToSky(0.0f, 0.0f), 0);
  EXPECT_EQ(FlatHazeLengthToSky(-1.0f, -1.0f), 0) << "below the ground";
}

TEST(Haze, ScaledErfc)
{
  for (double x = 0; x < 6; x += 0.013)
  {
    EXPECT_NEAR(ScaledErfc(x) / (std::exp(x * x) * std::erfc(x)), 1, 1e-7);
  }
  EXPECT_NEAR(ScaledErfc(1e4) * 1e4 * std::sqrt(std::acos(-1.0)), 1, 1e-6);
}
