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
Ray makeRay(double h1, double sine, double length)
{
  const double cosine = std::sqrt(1 - sine * sine);
  return { { { 0, 0, earth + h1 } }, { { 0.6 * length * cosine, 0.8 * length * cosine, earth + h1 + length * sine } } };
}

double quadrature(const Ray& ray, double scaleHeight)
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

template <typename Real>
Real haze(const Ray& ray, double scaleHeight)
{
  std::array<Real, 3> p, q;
  for (std::size_t c = 0; c < 3; ++c)
  {
    p[c] = Real(ray.P[c]);
    q[c] = Real(ray.Q[c]);
  }
  return globeHazeLength<Real>(p, q, Real(earth), Real(scaleHeight));
}
}

TEST(Haze, HasTheGivenValues)
{
  EXPECT_NEAR(haze<double>(makeRay(0, 0, 500), 8), 275.448612591889, 2e-4 * 275);
  EXPECT_NEAR(haze<double>(makeRay(0, 0.1, 100), 8), 55.8060243300098, 2e-4 * 56);
  EXPECT_NEAR(haze<double>(makeRay(5, -0.03, 400), 2), 90.00686193061898, 2e-4 * 90);
  EXPECT_NEAR(haze<double>(makeRay(10, 0, 800), 8), 81.13463000805936, 2e-4 * 81);
}

TEST(Haze, LimbIsThatOfAnInfiniteRay)
{
  const Ray limb{ { { -40000, 0, earth } }, { { 40000, 0, earth } } };
  EXPECT_NEAR(haze<double>(limb, 8) / 566.1651122833583, 1, 1e-6);
  EXPECT_NEAR(haze<float>(limb, 8) / 566.1651122833583, 1, 1e-4);
}

TEST(Haze, AgreesWithQuadratureUpAndDown)
{
  Random random(1);
  for (int i = 0; i < 300; ++i)
  {
    const double scaleHeight = random.Uniform(2, 10);
    const Ray ray = makeRay(random.Uniform(0, 25), i % 5 ? std::pow(random.Uniform(), 2) : random.Uniform(), random.LogUniform(1, 1600));
    const Ray back{ ray.Q, ray.P };
    const double exact = quadrature(ray, scaleHeight);
    EXPECT_NEAR(haze<double>(ray, scaleHeight) / exact, 1, 2e-4);
    EXPECT_NEAR(haze<double>(back, scaleHeight), haze<double>(ray, scaleHeight), 1e-6 * exact);
    EXPECT_NEAR(haze<float>(ray, scaleHeight), exact, 3e-4 * exact + 2e-3) << "in float";
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
    EXPECT_NEAR(haze<double>(ray, 8) / quadrature(ray, 8), 1, 1e-5);
    EXPECT_NEAR(haze<float>(ray, 8) / quadrature(ray, 8), 1, 3e-4) << "in float";
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
    const float x = haze<float>(ray, 8);
    EXPECT_TRUE(std::isfinite(x) && x >= 0) << x;
    if (eye[0] * ground[0] + eye[1] * ground[1] + eye[2] * ground[2] > 0.3) // the ray does not pass through the planet
    {
      EXPECT_NEAR(x / quadrature(ray, 8), 1, 3e-3);
    }
  }
  EXPECT_EQ(haze<float>(makeRay(0, 0, 0), 8), 0);
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
      EXPECT_NEAR(flatHazeLength(h1, h2, 700.0, 8.0) / sum, 1, 1e-4);
      EXPECT_NEAR(flatHazeLength(float(h1), float(h2), 700.0f, 8.0f) / sum, 1, 1e-4);
    }
  }
}

TEST(Haze, ScaledErfc)
{
  for (double x = 0; x < 6; x += 0.013)
  {
    EXPECT_NEAR(scaledErfc(x) / (std::exp(x * x) * std::erfc(x)), 1, 1e-7);
  }
  EXPECT_NEAR(scaledErfc(1e4) * 1e4 * std::sqrt(std::acos(-1.0)), 1, 1e-6);
}
