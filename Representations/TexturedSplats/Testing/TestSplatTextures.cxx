// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures of vector splats: coverage of segments; motion, mean, blur and sense of streaks; the
 * kernel that is lengthened for them.
 */
#include "ContrastingColor.h"
#include "EllipsoidSplat.h"
#include "SplatKernelValues.h"
#include "SplatSeed.h"
#include "VectorTextureValues.h"

#include <gtest/gtest.h>

#include <random>

using namespace nephoscope;

namespace
{
// Where in its cell a segment is: -1/2 to 1/2 along each edge.
inline std::array<double, 3> JitterOf(float seed)
{
  std::array<double, 3> jitter;
  constexpr double factors[3] = { 1.0, 61.0, 3721.0 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double number = seed * factors[axis];
    jitter[axis] = number - static_cast<double>(static_cast<std::int64_t>(number)) - 0.5;
  }
  return jitter;
}

constexpr streaks::Shape shape{ 4.0, 2.4, 0.1, 1.0, 0.0 };

// By midpoints over one period and one row, whose pattern is not periodic across: over many rows.
double MeanOf(const streaks::Shape& of)
{
  const double dx = 0.02, dy = 0.02;
  const int rows = 40;
  double sum = 0.0;
  std::size_t count = 0;
  for (double x = 0.5 * dx; x < of.Period; x += dx)
  {
    for (double y = 0.5 * dy; y < rows * of.Spacing; y += dy, ++count)
    {
      sum += streaks::Rows(of, x, y, 0.3, 0.0);
    }
  }
  return sum / static_cast<double>(count);
}
}

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

// As a density along the vector: segments of a travel's length, each with its weight.
TEST(LineSegment, MovesByATravelAndGoesOnWithoutAJump)
{
  const auto ink = [](double phase, double x) {
    const MovingSegment moved = MoveSegment(phase);
    const auto inside = [&](double from) {
      return std::abs(x - moved.Offset - from) < 0.5 ? 1.0 : 0.0;
    };
    return moved.Weight * inside(0.0) + (1.0 - moved.Weight) * inside(1.0);
  };
  for (double x = -1.6; x < 1.6; x += 0.0371)
  {
    EXPECT_NEAR(ink(0.0, x), ink(1.0 - 1e-12, x), 1e-9) << x;
  }
  for (double phase = 0.0; phase < 1.0; phase += 0.01)
  {
    double sum = 0.0;
    for (double x = -1.9995; x < 2.0; x += 0.001)
    {
      sum += 0.001 * ink(phase, x);
    }
    EXPECT_NEAR(sum, 1.0, 2e-3) << phase;
    EXPECT_NEAR(MoveSegment(phase).Offset, MoveSegment(0.0).Offset + phase, 1e-12);
  }
}

TEST(LineSegment, ErrorFunctionOfShadersIsAccurate)
{
  for (double x = -6.0; x < 6.0; x += 0.01)
  {
    EXPECT_NEAR(ErrorFunction(x), std::erf(x), 2e-7) << x;
  }
}

TEST(Streaks, MoveAlongTheVectorAndLoop)
{
  for (double x = -5.0; x < 5.0; x += 0.37)
  {
    for (double y = -2.0; y < 2.0; y += 0.17)
    {
      EXPECT_NEAR(
        streaks::Value(shape, x, y, 0.0, 0.4), streaks::Value(shape, x, y, 1.0, 0.4), 1e-12);
      // What was at x is a tenth of a period farther a tenth of a phase later.
      EXPECT_NEAR(streaks::Value(shape, x, y, 0.3, 0.4),
        streaks::Value(shape, x + 0.1 * shape.Period, y, 0.4, 0.4), 1e-9);
    }
  }
}

TEST(Streaks, HaveTheirHeadInFront)
{
  // Half of the brightness is reached much closer to the head in front of it than behind.
  EXPECT_NEAR(streaks::Comet(shape, 0.0, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(streaks::Comet(shape, 0.5 * shape.Tail, 0.0), 0.5, 1e-12);
  EXPECT_LT(streaks::Comet(shape, -0.05 * shape.Tail, 0.0), 0.5);
  EXPECT_EQ(streaks::Comet(shape, 1.01 * shape.Tail, 0.0), 0.0);
  EXPECT_NEAR(streaks::Value(shape, 0.25 * shape.Period, 0.0, 0.25, 0.0), 1.0,
    1e-12); // phase 0.25: the head is there
}

TEST(Streaks, MeanOverACycleIsTheSameEverywhereAlong)
{
  const auto mean = [](double x, double y) {
    double sum = 0.0;
    for (int k = 0; k < 64; ++k)
    {
      sum += streaks::Value(shape, x, y, k / 64.0, 0.0) / 64.0;
    }
    return sum;
  };
  for (double y = -0.9; y < 1.0; y += 0.1)
  {
    EXPECT_NEAR(mean(0.0, y), mean(0.37, y), 2e-3);
  }
}

TEST(Streaks, MeanInClosedForm)
{
  EXPECT_NEAR(MeanOf(shape) / streaks::Mean(shape), 1.0, 5e-3);
}

TEST(Streaks, BlurKeepsTheInk)
{
  streaks::Shape small = shape;
  for (const double pixel : { 0.05, 0.1, 0.2 })
  {
    small.Pixel = pixel;
    EXPECT_NEAR(MeanOf(small) / MeanOf(shape), 1.0, 0.05) << pixel;
  }
  small.Pixel = 1.0; // a pixel as wide as a row: nothing but the mean is left
  EXPECT_NEAR(streaks::Value(small, 0.3, 0.2, 0.1, 0.5), streaks::Mean(small), 1e-12);
}

TEST(Streaks, AreRoundWhenTheVectorPointsAtTheEye)
{
  streaks::Shape end = shape;
  end.Period = 0.1;
  end.Tail = 0.1;
  for (int i = 0; i < 12; ++i)
  {
    EXPECT_NEAR(streaks::Value(end, 0.13 * std::cos(i), 0.13 * std::sin(i), 0.1 * i, 0.7),
      streaks::Value(end, 0.13, 0.0, 0.0, 0.0), 1e-9);
  }
  EXPECT_NEAR(streaks::Value(end, 0.0, 0.0, 0.0, 0.0), 1.0, 1e-12);
}

TEST(Streaks, StayBetweenZeroAndOneWithoutJumps)
{
  double last = streaks::Value(shape, 0.2, -1.5, 0.1, 0.3);
  for (double y = -1.5; y < 1.5; y += 0.001)
  {
    const double value = streaks::Value(shape, 0.2, y, 0.1, 0.3);
    EXPECT_GE(value, 0.0);
    EXPECT_LE(value, 1.0);
    EXPECT_LT(std::abs(value - last), 0.01) << y;
    last = value;
  }
}

// A kernel that is lengthened along a vector still sums up to a constant over the lattice, times
// its length.
TEST(Streaks, LengthenedKernelIsFlat)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  double worst = 0.0;
  for (int trial = 0; trial < 40; ++trial)
  {
    Vector3 v{ { normal(random), normal(random), trial % 2 ? normal(random) : 0.0 } };
    const double length = Norm(v);
    const double longer = 1.0 + 3.0 * uniform(random);
    const double at[3] = { uniform(random), uniform(random), uniform(random) };
    double sum = 0.0;
    for (int n = 0; n < 15 * 15 * 15; ++n)
    {
      const double d[3] = { n % 15 - 7 - at[0], n / 15 % 15 - 7 - at[1], n / 225 - 7 - at[2] };
      const double along = (d[0] * v[0] + d[1] * v[1] + d[2] * v[2]) / length;
      const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      const double r =
        std::sqrt(std::max(0.0, square - along * along) + along * along / (longer * longer));
      sum += cubic_kernel::Value(r);
    }
    worst = std::max(worst, std::abs(sum / longer - 1.0));
  }
  EXPECT_LT(worst, 0.006);
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

TEST(Phase, IsOneOfSixteenStoredOnes)
{
  EXPECT_EQ(StoredPhase(0.3, 0), 0.3);
  EXPECT_EQ(StoredPhase(0.3, 16), 5.0 / 16.0);
  EXPECT_EQ(StoredPhase(0.99, 16), 0.0);
  EXPECT_NEAR(StoredPhase(1.3, 0), 0.3, 1e-12);
}

// A mean of corners added up in another order.
TEST(Seed, DoesNotDependOnRounding)
{
  int others = 0;
  for (int n = 0; n < 16000; ++n)
  {
    const double x = (n % 40 - 20) * 0.25, y = n / 40 / 7.0, z = 1e6 * std::sin(n);
    const double place[3] = { x, y, z },
                 rounded[3] = { std::nextafter(x, 1e9), std::nextafter(y, -1e9), z * (1 + 2e-16) };
    others += SeedOf(place).Phase != SeedOf(rounded).Phase ? 1 : 0;
  }
  EXPECT_LE(others, 3);
  const double here[3] = { 1e6, 0, 0 }, there[3] = { 1e6 + 0.001, 0, 0 };
  EXPECT_NE(SeedOf(here).Phase, SeedOf(there).Phase);
}

TEST(Seed, IsUniformAndDependsOnThePlaceAlone)
{
  std::vector<int> phases(16), rests(16);
  for (int n = 0; n < 16000; ++n)
  {
    const double place[3] = { 0.5 * (n % 20), n / 20 % 40 - 20.0, n / 800 * 1e6 };
    const nephoscope::SplatSeed seed = SeedOf(place);
    EXPECT_EQ(seed.Phase, SeedOf(place).Phase);
    ++phases[static_cast<std::size_t>(16 * seed.Phase)];
    ++rests[static_cast<std::size_t>(16 * seed.Rest)];
  }
  for (std::size_t i = 0; i < 16; ++i)
  {
    EXPECT_NEAR(phases[i], 1000, 130) << i; // 4 standard deviations
    EXPECT_NEAR(rests[i], 1000, 130) << i;
  }
  const double plus[3] = { 0.0, 1.0, 2.0 }, minus[3] = { -0.0, 1.0, 2.0 };
  EXPECT_EQ(SeedOf(plus).Rest, SeedOf(minus).Rest);
  const double origin[3] = { 0.0, 0.0, 0.0 }, nearly[3] = { 1e-17, 0.0, -3e-17 };
  EXPECT_EQ(SeedOf(origin, 0.1).Phase, SeedOf(nearly, 0.1).Phase);
  for (const double j : JitterOf(0.73f))
  {
    EXPECT_LE(std::abs(j), 0.5);
  }
}

namespace
{
// ParaView's Cool to Warm, from Diverging space to RGB at a few places.
const std::vector<StreakColor> coolToWarm = { { { 0.23, 0.30, 0.75 } }, { { 0.48, 0.62, 0.97 } },
  { { 0.75, 0.83, 0.96 } }, { { 0.87, 0.87, 0.87 } }, { { 0.95, 0.79, 0.72 } },
  { { 0.94, 0.60, 0.48 } }, { { 0.84, 0.32, 0.26 } }, { { 0.71, 0.02, 0.15 } } };
const std::vector<StreakColor> rainbow = { { { 0, 0, 1 } }, { { 0, 1, 1 } }, { { 0, 1, 0 } },
  { { 1, 1, 0 } }, { { 1, 0, 0 } } };
const std::vector<StreakColor> white = { { { 1, 1, 1 } } };
}

// Dark, ParaView's own, light, and gradients.
TEST(ContrastingColor, CanBeReadOnEveryBackground)
{
  const std::vector<std::vector<StreakColor>> backgrounds = { { { { 0, 0, 0 } } },
    { { { 0.32, 0.34, 0.43 } } }, { { { 1, 1, 1 } } },
    { { { 0, 0, 0.16 } }, { { 0.32, 0.34, 0.43 } } }, { { { 1, 1, 1 } }, { { 0, 0, 0 } } } };
  for (const std::vector<StreakColor>& background : backgrounds)
  {
    for (const std::vector<StreakColor>& medium : { coolToWarm, rainbow, white })
    {
      const StreakColor color = ContrastingColor(background, medium);
      EXPECT_GE(DistanceToNearest(color, background), 0.7)
        << color[0] << " " << color[1] << " " << color[2];
    }
    const StreakColor color = ContrastingColor(background, coolToWarm);
    EXPECT_GE(DistanceToNearest(color, coolToWarm), 0.35);
  }
}
