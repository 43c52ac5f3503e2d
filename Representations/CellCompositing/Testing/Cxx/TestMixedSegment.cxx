// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments in several media against adaptive quadrature of their emission.
#include "MixedSegment.h"

#include "SegmentReference.h"
#include "TestRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
struct Medium
{
  double Tau[2], Color[2]; // at the front and the back end

  double TauAt(double t) const { return Tau[0] + t * (Tau[1] - Tau[0]); }
  double EmissionAt(double t) const
  {
    return this->TauAt(t) * (this->Color[0] + t * (this->Color[1] - this->Color[0]));
  }
};

struct Sums
{
  double Emission[3] = { 0, 0, 0 }, Tau[2] = { 0, 0 };

  explicit Sums(const std::vector<Medium>& media)
  {
    for (const Medium& medium : media)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Emission[i] += medium.EmissionAt(0.5 * i);
      }
      this->Tau[0] += medium.Tau[0];
      this->Tau[1] += medium.Tau[1];
    }
  }

  template <typename Real>
  double Light() const
  {
    return MixedLight(Real(this->Emission[0]), Real(this->Emission[1]), Real(this->Emission[2]),
      Real(this->Tau[0]), Real(this->Tau[1]));
  }
};

long double Transmittance(const std::vector<Medium>& media, long double t)
{
  long double depth = 0;
  for (const Medium& m : media)
  {
    depth += m.Tau[0] * t + 0.5L * (m.Tau[1] - m.Tau[0]) * t * t;
  }
  return std::exp(-depth);
}

double ExpectedLight(const std::vector<Medium>& media)
{
  const auto emitted = [&](long double t) {
    ReferenceWeights value;
    for (const Medium& m : media)
    {
      value.Front += m.EmissionAt(static_cast<double>(t));
    }
    value.Front *= Transmittance(media, t);
    return value;
  };
  return static_cast<double>(AdaptiveIntegral(emitted, 0.0L, 1.0L, 14).Front);
}

std::vector<Medium> RandomMedia(Random& random, double largest)
{
  std::vector<Medium> media(static_cast<std::size_t>(random.Integer(1, 4)));
  for (Medium& m : media)
  {
    for (double& tau : m.Tau)
    {
      tau = random.Integer(0, 4) == 0 ? 0.0 : random.LogUniform(1e-6, largest);
    }
    for (double& color : m.Color)
    {
      color = random.Uniform();
    }
  }
  return media;
}
}

TEST(MixedSegment, AgreesWithQuadrature)
{
  Random random(71);
  double worst[2] = { 0, 0 };
  for (const double largest : { 0.1, 1.0, 10.0, 300.0 })
  {
    for (int i = 0; i < 3000; ++i)
    {
      const std::vector<Medium> media = RandomMedia(random, largest);
      const double expected = ExpectedLight(media);
      worst[0] = std::max(worst[0], std::abs(Sums(media).Light<double>() - expected));
      worst[1] = std::max(worst[1], std::abs(Sums(media).Light<float>() - expected));
    }
  }
  EXPECT_LT(worst[0], 1e-6);
  EXPECT_LT(worst[1], 4e-6);
  std::printf("largest error %.2g in double, %.2g in float\n", worst[0], worst[1]);
}

TEST(MixedSegment, OneMediumIsThatOfOpticalSegment)
{
  Random random(72);
  for (int i = 0; i < 2000; ++i)
  {
    const Medium m = { { random.LogUniform(1e-4, 100), random.LogUniform(1e-4, 100) },
      { random.Uniform(), random.Uniform() } };
    const SegmentWeights<double> weights = ExactSegmentWeights(m.Tau[0], m.Tau[1]);
    ASSERT_NEAR(
      Sums({ m }).Light<double>(), weights.Front * m.Color[0] + weights.Back * m.Color[1], 1e-12);
  }
}

TEST(MixedSegment, OrderOfMediaDoesNotMatter)
{
  Random random(73);
  for (int i = 0; i < 500; ++i)
  {
    std::vector<Medium> media = RandomMedia(random, 10);
    const double light = Sums(media).Light<double>();
    std::reverse(media.begin(), media.end());
    ASSERT_NEAR(Sums(media).Light<double>(), light, 1e-12);
  }
}
