// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MediumMeasures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace nephoscope;

namespace
{
const MediumBounds cube = { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } };

// Cubes of a lattice that fill the frame, with a scalar at their middles, which is the opacity,
// too.
template <typename Scalar>
MediumMeasures MeasureLattice(int count, const Scalar& scalar)
{
  MediumMeasures measures;
  const double edge = 2.0 / count;
  for (int cell = 0; cell < count * count * count; ++cell)
  {
    const double x = -1.0 + edge * (cell % count), y = -1.0 + edge * (cell / count % count),
                 z = -1.0 + edge * (cell / count / count);
    const double value = scalar(x + 0.5 * edge, y + 0.5 * edge, z + 0.5 * edge);
    measures.AddPart(
      cube, { { { x, x + edge, y, y + edge, z, z + edge } }, edge * edge * edge, value, value });
  }
  measures.Reach.fill(3.0);
  return measures;
}

double Gaussian(double sigma, double x, double y, double z)
{
  return std::exp(-0.5 * (x * x + y * y + z * z) / (sigma * sigma));
}
} // namespace

TEST(MediumMeasures, SpreadMediumHasMeanOpticalDepth2)
{
  for (const int count : { 1, 3, 10, 32, 50 }) // pixels of the projections need not match the cells
  {
    const MediumMeasures measures =
      MeasureLattice(count, [](double, double, double) { return 1.0; });
    EXPECT_NEAR(measures.Projections.Localization(), 1.0, 1e-9) << count;
    EXPECT_NEAR(DefaultUnitDistance(measures, cube, false), 4.0 / 3.0 / 2.0, 1e-9) << count;
  }
}

TEST(MediumMeasures, SmallDenseMediumIsAsInClosedForm)
{
  // The square of a Gaussian picture has the mean pi sigma^2 / 4, the Gaussian has 2 pi sigma^2 /
  // 4: localization 1 / (pi sigma^2).
  for (const double sigma : { 0.15, 0.2, 0.25, 0.3 })
  {
    const MediumMeasures measures =
      MeasureLattice(50, [=](double x, double y, double z) { return Gaussian(sigma, x, y, z); });
    const double localization = 1.0 / (M_PI * sigma * sigma);
    EXPECT_NEAR(measures.Projections.Localization() / localization, 1.0, 0.03) << sigma;
    const double mean = std::pow(2.0 * M_PI, 1.5) * std::pow(sigma, 3) / 8.0;
    const double distance = 4.0 / 3.0 * mean / meanOpticalDepth * localization / localOpticalDepth;
    EXPECT_NEAR(DefaultUnitDistance(measures, cube, false) / distance, 1.0, 0.03) << sigma;
  }
}

TEST(MediumMeasures, LayerIsSpreadSeenFromAbove)
{
  const MediumMeasures measures =
    MeasureLattice(20, [](double, double y, double) { return std::abs(y) < 0.1 ? 1.0 : 0.0; });
  EXPECT_NEAR(measures.Projections.Localization(), 1.0, 1e-9);
}

TEST(MediumMeasures, RampIsTheOpacityOfTheRange)
{
  const auto scalar = [](double x, double y, double z) {
    return 200.0 + 100.0 * Gaussian(0.2, x, y, z);
  };
  const auto opacity = [](double x, double y, double z) { return Gaussian(0.2, x, y, z); };
  MediumMeasures ramp = MeasureLattice(20, scalar);
  ramp.ScalarRange[0] = 200.0;
  ramp.ScalarRange[1] = 300.0;
  const double expected = DefaultUnitDistance(MeasureLattice(20, opacity), cube, false);
  EXPECT_NEAR(DefaultUnitDistance(ramp, cube, true) / expected, 1.0, 1e-9);
}

TEST(MediumMeasures, WhatIsNotFiniteIsNotOpaque)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MediumMeasures measures =
    MeasureLattice(10, [=](double x, double, double) { return x < 0.0 ? nan : 300.0; });
  measures.ScalarRange[0] = 200.0;
  measures.ScalarRange[1] = 300.0;
  EXPECT_NEAR(MeanRamp(measures), 0.5, 1e-9);
  EXPECT_TRUE(std::isfinite(measures.Projections.Localization(measures.ScalarRange)));
}

TEST(MediumMeasures, PartsOutsideOfTheFrameCountAtItsBorder)
{
  MediumMeasures measures;
  measures.AddPart(cube, { { { 5.0, 6.0, -3.0, 4.0, 0.0, 0.0 } }, 1.0, 1.0, 1.0 });
  EXPECT_NEAR(measures.Projections.Localization(), 1.0, 1e-9);
  EXPECT_EQ(MediumMeasures().Projections.Localization(), 1.0);
}

TEST(MediumMeasures, SumsOverProcessesAreThoseOfOne)
{
  const auto left = [](double x, double y, double z) {
    return x < 0.0 ? Gaussian(0.3, x, y, z) : 0.0;
  };
  const auto right = [](double x, double y, double z) {
    return x < 0.0 ? 0.0 : Gaussian(0.3, x, y, z);
  };
  MediumProjections sum = MeasureLattice(16, left).Projections;
  const MediumProjections other = MeasureLattice(16, right).Projections;
  for (std::size_t i = 0; i < sum.GetPixels().size(); ++i)
  {
    sum.GetPixels()[i] += other.GetPixels()[i];
  }
  const double whole = MeasureLattice(16, [](double x, double y, double z) {
    return Gaussian(0.3, x, y, z);
  }).Projections.Localization();
  EXPECT_NEAR(sum.Localization() / whole, 1.0, 1e-9);
}
