// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cloud texture against given values, its period, averages over footprints by Monte Carlo;
 * thresholds against counts.
 */
#include "CoverageThreshold.h"
#include "GardnerTexture.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

using namespace nephoscope;
using nephoscope_test::Random;

namespace
{
using Point = Point3<double>;

Point RandomPoint(Random& random)
{
  return { { random.Uniform(), random.Uniform(0, 2), random.Uniform(0, 10) } };
}

/** Where a Gaussian pixel filter looks. */
Point InFootprint(Random& random, const Point& p, const TextureFootprint<double>& footprint)
{
  const double x = random.Normal();
  const double y = random.Normal();
  Point q;
  for (std::size_t i = 0; i < 3; ++i)
  {
    q[i] = p[i] + x * footprint.Across[i] + y * footprint.Up[i];
  }
  return q;
}

FilteredTexture<double> FilteredBlend(
  const Point& p1, const Point& p2, const TextureFootprint<double>& footprint, double weight)
{
  return BlendTextures(FilteredGardnerTexture(PlaceInSet(0, p1), footprint),
    FilteredGardnerTexture(PlaceInSet(1, p2), footprint), weight, 1 - weight);
}

const CoverageThresholds thresholds;
}

TEST(GardnerTexture, HasTheGivenValues)
{
  EXPECT_NEAR(GardnerTexture<double>({ { 0, 0, 0 } }), 3.0997853734, 1e-5);
  EXPECT_NEAR(GardnerTexture<double>({ { 0.25, 0.5, 0.5 } }), 0.3726117598, 1e-5);
  EXPECT_NEAR(GardnerTexture<double>({ { 0.1, 0.2, 0.3 } }), 2.3731414354, 1e-5);
}

TEST(GardnerTexture, RepeatsItselfAndHasUnitVariance)
{
  Random random(1);
  double mean = 0, square = 0;
  const int samples = 400000;
  for (int i = 0; i < samples; ++i)
  {
    const Point p = RandomPoint(random);
    const double f = GardnerTexture(p);
    if (i < 1000)
    {
      EXPECT_NEAR(GardnerTexture<double>({ { p[0] + 1, p[1], p[2] } }), f, 1e-11);
      EXPECT_NEAR(GardnerTexture<double>({ { p[0] - 7, p[1] + 2, p[2] } }), f, 1e-10);
    }
    mean += f / samples;
    square += f * f / samples;
  }
  EXPECT_NEAR(mean, 0, 0.006);
  EXPECT_NEAR(square, 1, 0.008);
}

TEST(GardnerTexture, ExactFilterIsTheMeanOverTheFootprint)
{
  Random random(2);
  for (const double size : { 0.002, 0.01, 0.03 })
  {
    const TextureFootprint<double> footprint{ { { size, 0.2 * size, 0 } },
      { { -0.1 * size, 0.5 * size, size } } };
    for (int place = 0; place < 4; ++place)
    {
      const Point p = RandomPoint(random);
      const auto filtered = ExactlyFilteredGardnerTexture(p, footprint);
      double mean = 0;
      const int samples = 60000;
      for (int i = 0; i < samples; ++i)
      {
        mean += GardnerTexture(InFootprint(random, p, footprint)) / samples;
      }
      EXPECT_NEAR(filtered.Mean, mean, 0.02) << size;
    }
  }
}

TEST(GardnerTexture, WithoutFootprintNothingIsLost)
{
  Random random(3);
  const Point p = RandomPoint(random);
  const auto exact = ExactlyFilteredGardnerTexture(p, {});
  EXPECT_NEAR(exact.Mean, GardnerTexture(p), 1e-8); // Bessel terms up to 12
  EXPECT_NEAR(exact.Lost, 0, 1e-12);
  EXPECT_NEAR(exact.Fourth, GardnerFourth(), 1e-12);
  const auto quick = FilteredGardnerTexture<double>(p, {});
  EXPECT_NEAR(quick.Mean, GardnerTexture(p), 1e-12);
  EXPECT_NEAR(quick.Lost, 0, 1e-12);
  EXPECT_NEAR(quick.Fourth, GardnerFourth(), 1e-12);
}

TEST(GardnerTexture, QuickFilterIsNearTheExactOne)
{
  Random random(4);
  const double sizes[3] = { 0.005, 0.01, 0.02 };
  const double allowed[3] = { 0.03, 0.045, 0.06 };
  for (int k = 0; k < 3; ++k)
  {
    double square = 0;
    const int samples = 2000;
    for (int i = 0; i < samples; ++i)
    {
      const Point p = RandomPoint(random);
      const TextureFootprint<double> footprint{ { { sizes[k], 0, 0 } }, { { 0, sizes[k], 0 } } };
      const double difference = FilteredGardnerTexture(p, footprint).Mean -
        ExactlyFilteredGardnerTexture(p, footprint).Mean;
      square += difference * difference / samples;
    }
    EXPECT_LT(std::sqrt(square), allowed[k]) << sizes[k];
  }
}

TEST(CoverageThreshold, HasTheMeasuredValues)
{
  EXPECT_NEAR(thresholds.Find(0.15, 1), 1.0895, 0.0055);
  EXPECT_NEAR(thresholds.Find(0.05, 1), 1.647, 0.015);
  EXPECT_NEAR(thresholds.Find(0.25, 1), 0.7234, 0.008);
  EXPECT_NEAR(thresholds.Find(0.5, 1), 0, 0.003);
  EXPECT_NEAR(thresholds.Find(0.9, 1), -1.333, 0.015);
  EXPECT_NEAR(thresholds.Find(0.15, 0), 1.03643, 2e-4); // of a Gaussian
  EXPECT_NEAR(thresholds.Find(0.05, 0), 1.64485, 5e-4);
}

TEST(CoverageThreshold, UncorrectedBlendsHaveLessCover)
{
  Random random(5);
  const int samples = 400000;
  int above = 0, corrected = 0;
  for (int i = 0; i < samples; ++i)
  {
    const auto blend = FilteredBlend(RandomPoint(random), RandomPoint(random), {}, 0.5);
    above += blend.Mean * std::sqrt(0.5) > 1.0895;
    corrected += blend.Mean > 1.0895;
  }
  EXPECT_NEAR(above / double(samples), 0.063, 0.003);
  EXPECT_NEAR(corrected / double(samples), 0.143, 0.003);
}

// The two sets over 24 hours, also where they have the same coordinates (calm air), near and far,
// hard edges and soft ones.
TEST(CoverageThreshold, CoverStaysWithWeightsDistanceAndSoftness)
{
  Random random(6);
  const int samples = 20000;
  double worst = 0;
  for (const double cover : { 0.05, 0.15, 0.3, 0.5, 0.75, 0.9 })
  {
    for (const double weight : { 0.0, 0.1, 0.25, 0.5, 0.75, 1.0 })
    {
      for (const double size : { 0.0, 0.005, 0.02, 0.1 })
      {
        const bool calm = weight == 0.25 || weight == 0.5;
        const double softness = size == 0.005 ? 0.3 : 0.1;
        const TextureFootprint<double> footprint{ { { size, 0, 0 } }, { { 0, 0.6 * size, 0 } } };
        double sum = 0;
        for (int i = 0; i < samples; ++i)
        {
          const Point p1 = RandomPoint(random);
          const Point p2 = calm ? p1 : RandomPoint(random);
          sum += CloudShare(thresholds, FilteredBlend(p1, p2, footprint, weight), cover, softness) /
            samples;
        }
        worst = std::max(worst, std::abs(sum - cover));
        EXPECT_NEAR(sum, cover, 0.0095)
          << "cover " << cover << " weight " << weight << " size " << size;
      }
    }
  }
  std::cout << "worst cover: off by " << worst << std::endl;
}

// Every preset: variance, exact filter, period on longitudes, and the cover of a threshold by
// counting; and the threshold of that cover.
class Presets : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(GardnerWaves, Presets, testing::Range(0, 4));

TEST_P(Presets, HaveTheirDistribution)
{
  const GardnerWaves waves = PresetWaves(GetParam());
  const CoverageThresholds table(waves);
  Random random(8);
  const int samples = 200000;
  const double levels[4] = { -1.2, -0.3, 0.4, 1.5 };
  for (const double softness : { 0.0, 0.4 })
  {
    double above[4] = {}, square = 0;
    for (int i = 0; i < samples; ++i)
    {
      const Point p{ { random.Uniform(0, 10), random.Uniform(0, 100), random.Uniform(0, 10) } };
      const double f = GardnerTexture(p, waves);
      square += f * f / samples;
      for (int k = 0; k < 4; ++k)
      {
        above[k] += (f + softness * random.Normal() > levels[k]) / double(samples);
      }
    }
    EXPECT_NEAR(square, 1, 0.01);
    for (int k = 0; k < 4; ++k)
    {
      const double cover = CoverOfThreshold(waves, levels[k], softness);
      EXPECT_NEAR(cover, above[k], 0.006) << levels[k];
      EXPECT_NEAR(ThresholdOfCover(table, cover, softness), levels[k], 0.01);
    }
  }
}

TEST_P(Presets, AreFilteredAndGoRound)
{
  GardnerWaves waves = PresetWaves(GetParam());
  Random random(9);
  const TextureFootprint<double> footprint{ { { 0.01, 0.002, 0 } }, { { -0.001, 0.005, 0.01 } } };
  const Point p = RandomPoint(random);
  double mean = 0;
  const int samples = 60000;
  for (int i = 0; i < samples; ++i)
  {
    mean += GardnerTexture(InFootprint(random, p, footprint), waves) / samples;
  }
  EXPECT_NEAR(ExactlyFilteredGardnerTexture(p, footprint, waves).Mean, mean, 0.02);
  CloseOnLongitudes(waves);
  EXPECT_NEAR(
    GardnerTexture<double>({ { p[0] + 3, p[1], p[2] } }, waves), GardnerTexture(p, waves), 1e-10);
}

TEST(GardnerWaves, PrintedPhaseIsThatOfTheFormula)
{
  const GardnerWaves waves = PrintedWaves();
  const Point p{ { 0.3, 0.7, 0.2 } };
  double sum = 0;
  for (const GardnerWave& wave : waves)
  {
    const double turn = 2 * gardnerPi;
    const double b = turn * wave.Frequency[0], c = turn * wave.Frequency[1],
                 d = turn * wave.Frequency[2];
    const double q = 2 * std::sin(0.5 * b * p[0] - 0.5 * wave.Amplitude * p[1]);
    sum += wave.Amplitude * std::cos(b * p[0] + c * p[1] + d * p[2] + q);
  }
  EXPECT_NEAR(GardnerTexture(p, waves), sum, 1e-12);
}

TEST(GardnerWaves, UnusableOnesAreDescribed)
{
  EXPECT_EQ(DescribeUnusable(CloudWaves()), "");
  EXPECT_NE(DescribeUnusable({}).find("at least one amplitude"), std::string::npos);
  GardnerWaves waves(2);
  EXPECT_NE(DescribeUnusable(waves).find("at least one amplitude"), std::string::npos);
  waves[1].Amplitude = 1;
  EXPECT_NE(DescribeUnusable(waves).find("Custom wave 1 has no frequency"), std::string::npos);
  waves[1].Frequency[2] = std::nan("");
  EXPECT_NE(DescribeUnusable(waves).find("not finite"), std::string::npos);
}

TEST(CoverageThreshold, NothingAndEverything)
{
  const auto texture = FilteredGardnerTexture<double>({ { 0, 0, 0 } }, {});
  EXPECT_EQ(CloudShare(thresholds, texture, 0, 0.1), 0);
  EXPECT_EQ(CloudShare(thresholds, texture, 1, 0.1), 1);
}
