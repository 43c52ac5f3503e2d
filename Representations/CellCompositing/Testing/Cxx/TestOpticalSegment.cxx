// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The weights of a ray segment against closed forms, series and adaptive quadrature, and the
// identities they obey.
#include "OpticalSegment.h"

#include "SegmentReference.h"
#include "TestRandom.h"

#include <gtest/gtest.h>

#include <utility>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
// In float, up to optical depths of 1000: two million random pairs erred by 5.5e-7 at most, all of
// it rounding.
constexpr double floatTolerance = 6e-7;
constexpr double floatRelativeTolerance = 1e-6;
// In double: truncation at optical depth 18 and the rules themselves.
constexpr double doubleTolerance = 1e-7;

struct WeightOracle
{
  double TauFront, TauBack, Front, Back;
};

// From quadrature with 40 digits.
constexpr WeightOracle oracles[] = {
  { 1, 1, 0.367879441171, 0.264241117657 },
  { 0, 2, 0.253175867188, 0.378944691641 },
  { 2, 0, 0.461920493087, 0.170200065741 },
  { 0.5, 1.5, 0.313393512281, 0.318727046547 },
  { 1, 2, 0.438340641194, 0.338529198658 },
  { 2, 1, 0.521731859065, 0.255137980787 },
  { 10, 2, 0.888984175221, 0.108537072602 },
  { 2, 10, 0.727410862679, 0.270110385144 },
  { 0, 0.1, 0.016419614157, 0.0323509613422 },
};

/** Pairs with zero, equal, nearly equal and very different ends. */
std::pair<float, float> RandomPair(Random& random, double largest)
{
  const auto draw = [&]() {
    return random.Integer(0, 1) ? random.Uniform(0, largest) : random.LogUniform(1e-8, largest);
  };
  const double a = draw();
  const double b = draw();
  switch (random.Integer(0, 5))
  {
    case 0:
      return { 0.0f, float(b) };
    case 1:
      return { float(a), 0.0f };
    case 2:
      return { float(a), float(a) };
    case 3:
      return { float(a), float(std::min(largest, a * (1 + random.LogUniform(1e-7, 1e-3)))) };
    default:
      return { float(a), float(b) };
  }
}

struct Errors
{
  double Absolute = 0, Relative = 0;
  float WorstFront = 0, WorstBack = 0;
};

Errors MeasureFloatErrors(Random& random, double largest, int samples)
{
  Errors errors;
  for (int i = 0; i < samples; ++i)
  {
    const auto [tf, tb] = RandomPair(random, largest);
    const SegmentWeights<float> weights = ExactSegmentWeights(tf, tb);
    const ReferenceWeights expected = FindReferenceWeights(tf, tb);
    const double front = std::fabs(double(weights.Front - expected.Front));
    const double back = std::fabs(double(weights.Back - expected.Back));
    if (std::max(front, back) > errors.Absolute)
    {
      errors.Absolute = std::max(front, back);
      errors.WorstFront = tf;
      errors.WorstBack = tb;
    }
    if (std::max(tf, tb) >
      1e-6f) // below, the weights are no longer large against the smallest floats squared
    {
      errors.Relative =
        std::max({ errors.Relative, front / double(expected.Front), back / double(expected.Back) });
    }
  }
  return errors;
}

/** A way to integrate segments, and the largest optical depth it is used for. */
struct Rung
{
  const char* Name;
  double Low, High;
};
constexpr Rung rungs[] = { { "series", 1e-6, thinSegment }, { "10 nodes", thinSegment, 10 },
  { "16 nodes", 10, 1000 } };

class OpticalDepthsUpTo : public ::testing::TestWithParam<double>
{
};
}

TEST(SegmentReference, AgreesWithSeriesAndClosedForm)
{
  Random random(11);
  for (int i = 0; i < 500; ++i)
  {
    const long double tf = random.LogUniform(1e-3, 20), tb = random.LogUniform(1e-3, 20);
    const ReferenceWeights weights = FindReferenceWeights(tf, tb);
    const long double transparency = std::exp(-0.5L * (tf + tb));
    const long double psi = BesselSeriesPsi(tf, tb);
    EXPECT_NEAR(double(weights.Front - (1 - psi)), 0, 1e-15) << double(tf) << " " << double(tb);
    EXPECT_NEAR(double(weights.Back - (psi - transparency)), 0, 1e-15)
      << double(tf) << " " << double(tb);
    if (tb > 2 * tf)
    {
      EXPECT_NEAR(double(ClosedFormPsi(tf, tb) - psi), 0, 1e-15) << double(tf) << " " << double(tb);
    }
  }
}

TEST(OpticalSegment, Oracles)
{
  for (const WeightOracle& o : oracles)
  {
    const SegmentWeights<double> weights = ExactSegmentWeights(o.TauFront, o.TauBack);
    EXPECT_NEAR(weights.Front, o.Front, 1e-6 * o.Front) << o.TauFront << " " << o.TauBack;
    EXPECT_NEAR(weights.Back, o.Back, 1e-6 * o.Back) << o.TauFront << " " << o.TauBack;
  }
}

TEST(OpticalSegment, UnitCube)
{
  // Extinction 1, colour 1: alpha = 1 - 1/e.
  EXPECT_NEAR(ExactSegmentWeights(1.0, 1.0).Alpha(), 0.6321205588285577, 0.6321205588285577e-6);
  // Extinction 1 + z, colour z, seen from z = 0 and from z = 1.
  EXPECT_NEAR(ExactSegmentWeights(1.0, 2.0).Back, 0.338529199, 1e-6 * 0.338529199);
  EXPECT_NEAR(ExactSegmentWeights(2.0, 1.0).Front, 0.521731859, 1e-6 * 0.521731859);
  EXPECT_NEAR(1 - ExactSegmentWeights(1.0, 2.0).Alpha(), 0.223130160, 1e-6 * 0.223130160);
}

TEST(OpticalSegment, AverageRule)
{
  // Colour from 0 to 1 over unit depth: 0.316060279 instead of 0.264241118.
  const SegmentWeights<double> average = AverageSegmentWeights(1.0, 1.0);
  EXPECT_NEAR(average.Back, 0.316060279, 1e-6 * 0.316060279);
  EXPECT_NEAR(average.Back - ExactSegmentWeights(1.0, 1.0).Back, 0.0518191617571635,
    1e-5 * 0.0518191617571635);
  Random random(12);
  for (int i = 0; i < 1000; ++i)
  {
    const double tf = random.LogUniform(1e-12, 100), tb = random.LogUniform(1e-12, 100);
    const SegmentWeights<double> weights = AverageSegmentWeights(tf, tb);
    const double alpha =
      -std::expm1(-0.5 * (tf + tb)); // its transparency is exact whatever the ends
    EXPECT_NEAR(weights.Alpha(), alpha, 1e-14 * alpha);
    EXPECT_EQ(weights.Front, weights.Back);
    const SegmentWeights<float> single = AverageSegmentWeights(float(tf), float(tb));
    EXPECT_NEAR(single.Alpha(), alpha, 3e-7 * alpha);
  }
}

TEST_P(OpticalDepthsUpTo, FloatErrors)
{
  const double largest = this->GetParam();
  Random random(13);
  const Errors errors = MeasureFloatErrors(random, largest, 20000);
  std::cout << "optical depths up to " << largest << ": largest error " << errors.Absolute
            << " at (" << errors.WorstFront << ", " << errors.WorstBack << "), relative "
            << errors.Relative << std::endl;
  EXPECT_LE(errors.Absolute, floatTolerance);
  EXPECT_LE(errors.Relative, floatRelativeTolerance);
}
INSTANTIATE_TEST_SUITE_P(
  OpticalSegment, OpticalDepthsUpTo, ::testing::Values(0.05, 0.25, 1, 10, 100, 1000));

TEST(OpticalSegment, BeyondThousand)
{
  Random random(14);
  double largest = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const float tf = float(random.LogUniform(1e-3, 1e6)), tb = float(random.LogUniform(1e3, 1e6));
    const SegmentWeights<float> weights = ExactSegmentWeights(tf, tb);
    const ReferenceWeights expected = FindReferenceWeights(tf, tb);
    largest = std::max({ largest, std::fabs(double(weights.Front - expected.Front)),
      std::fabs(double(weights.Back - expected.Back)) });
  }
  std::cout << "optical depths of 1000 to 1e6: largest error " << largest << std::endl;
  EXPECT_LE(largest, 1e-6);
}

// Each rule, up to the largest optical depths it is used for, must be good enough by itself: in
// double nothing else errs.
TEST(OpticalSegment, EveryRungHolds)
{
  Random random(15);
  EXPECT_EQ(ChooseQuadratureRule(10.0).Size, 10);
  EXPECT_EQ(ChooseQuadratureRule(10.001).Size, 16);
  for (const Rung& rung : rungs)
  {
    const double low = rung.Low, high = rung.High;
    double absolute = 0, relative = 0;
    for (int i = 0; i < 4000; ++i)
    {
      const double dense = i % 2 ? high : random.LogUniform(low, high);
      const double thin = i % 5 ? random.Uniform(0, dense) : 0.0;
      const double tf = i % 3 ? dense : thin, tb = i % 3 ? thin : dense;
      const SegmentWeights<double> weights = ExactSegmentWeights(tf, tb);
      const ReferenceWeights expected = FindReferenceWeights(tf, tb);
      const double front = std::fabs(double(weights.Front - expected.Front));
      const double back = std::fabs(double(weights.Back - expected.Back));
      absolute = std::max({ absolute, front, back });
      relative =
        std::max({ relative, front / double(expected.Front), back / double(expected.Back) });
    }
    std::cout << rung.Name << " up to " << high << ": largest error " << absolute << ", relative "
              << relative << std::endl;
    EXPECT_LE(absolute, 4e-7) << rung.Name << " up to " << high;
    EXPECT_LE(relative, 1e-6) << rung.Name << " up to " << high;
  }
}

TEST(OpticalSegment, RulesAreGaussLegendre)
{
  for (const double largest : { 9.0, 900.0 })
  {
    const QuadratureRule rule = ChooseQuadratureRule(largest);
    for (int power = 0; power < 2 * rule.Size; ++power) // exact for these, and for no higher one
    {
      double sum = 0;
      for (int i = rule.First; i < rule.First + rule.Size; ++i)
      {
        sum += quadratureNodes[i][1] * std::pow(quadratureNodes[i][0], power);
      }
      EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-15) << rule.Size << " nodes, power " << power;
    }
  }
}

TEST(OpticalSegment, WeightsArePositiveAndBounded)
{
  Random random(16);
  for (int i = 0; i < 100000; ++i)
  {
    const auto [tf, tb] = RandomPair(random, i % 2 ? 1e5 : 5);
    const SegmentWeights<float> weights = ExactSegmentWeights(tf, tb);
    ASSERT_GE(weights.Front, 0.0f) << tf << " " << tb;
    ASSERT_GE(weights.Back, 0.0f) << tf << " " << tb;
    ASSERT_LE(weights.Alpha(), 1.0f + 2e-6f) << tf << " " << tb;
  }
  const SegmentWeights<float> nothing = ExactSegmentWeights(0.0f, 0.0f);
  EXPECT_EQ(nothing.Front, 0.0f);
  EXPECT_EQ(nothing.Back, 0.0f);
}

// Seen from its other end a segment has the same transparency, and alpha is 1 - T.
TEST(OpticalSegment, AlphaAndReversal)
{
  Random random(17);
  for (int i = 0; i < 20000; ++i)
  {
    const auto [tf, tb] = RandomPair(random, 50);
    const double alpha = -std::expm1(-0.5 * (double(tf) + double(tb)));
    ASSERT_NEAR(ExactSegmentWeights(double(tf), double(tb)).Alpha(), alpha, doubleTolerance)
      << tf << " " << tb;
    ASSERT_NEAR(ExactSegmentWeights(double(tb), double(tf)).Alpha(), alpha, doubleTolerance)
      << tf << " " << tb;
    ASSERT_NEAR(ExactSegmentWeights(tf, tb).Alpha(), alpha, 2 * floatTolerance) << tf << " " << tb;
  }
}

// A segment cut anywhere and composited front to back is the whole segment.
TEST(OpticalSegment, CutSegmentsCompositeToTheWhole)
{
  Random random(18);
  for (int i = 0; i < 20000; ++i)
  {
    const auto [front, back] = RandomPair(random, 30);
    const double tf = front, tb = back, cut = random.Uniform();
    const double colors[2] = { random.Uniform(), random.Uniform() };
    const double tauAtCut = tf + cut * (tb - tf),
                 colorAtCut = colors[0] + cut * (colors[1] - colors[0]);
    const SegmentWeights<double> whole = ExactSegmentWeights(tf, tb);
    const SegmentWeights<double> near = ExactSegmentWeights(cut * tf, cut * tauAtCut);
    const SegmentWeights<double> far = ExactSegmentWeights((1 - cut) * tauAtCut, (1 - cut) * tb);
    const double composited = near.Front * colors[0] + near.Back * colorAtCut +
      (1 - near.Alpha()) * (far.Front * colorAtCut + far.Back * colors[1]);
    ASSERT_NEAR(composited, whole.Front * colors[0] + whole.Back * colors[1], 3 * doubleTolerance)
      << tf << " " << tb << " " << cut;
  }
}

TEST(OpticalSegment, OpaqueEnd)
{
  Random random(19);
  for (int i = 0; i < 1000; ++i)
  {
    const double tf = random.LogUniform(1e-3, 1e4), tb = i % 7 ? random.LogUniform(1e-3, 1e4) : 0;
    const double end = OpaqueEnd(tf, tb);
    const double depth = end * (tf + 0.5 * (tb - tf) * end);
    ASSERT_GT(end, 0);
    ASSERT_LE(end, 1);
    ASSERT_NEAR(depth, std::min(18.0, 0.5 * (tf + tb)), 1e-9) << tf << " " << tb;
  }
}
