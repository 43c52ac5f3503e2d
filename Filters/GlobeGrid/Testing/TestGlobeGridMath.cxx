// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy.h"
#include "GridOrder.h"
#include "LevelAxis.h"
#include "LongitudeRow.h"
#include "StandardAtmosphere.h"

#include <gtest/gtest.h>

using namespace nephoscope;

namespace
{
geodesy::Basis BasisAt(double longitude, double latitude)
{
  return geodesy::LocalBasis(
    geodesy::TurnFromDegrees(longitude), geodesy::TurnFromDegrees(latitude));
}

std::vector<double> Row(double first, double spacing, int count)
{
  std::vector<double> row(count);
  for (int i = 0; i < count; ++i)
  {
    row[i] = first + i * spacing;
  }
  return row;
}
}

// StandardAtmosphere1976, table I (geopotential altitude): m, K, Pa, and half a unit of the last
// digit printed.
TEST(StandardAtmosphere, MatchesThePublishedTable)
{
  const double table[][4] = { { 0.0, 288.150, 101325.0, 0.5 }, { 5000.0, 255.650, 54020.0, 0.5 },
    { 10000.0, 223.150, 26436.0, 0.5 }, { 11000.0, 216.650, 22632.0, 0.5 },
    { 15000.0, 216.650, 12045.0, 0.5 }, { 20000.0, 216.650, 5474.9, 0.05 },
    { 25000.0, 221.650, 2511.0, 0.05 }, { 30000.0, 226.650, 1171.9, 0.05 },
    { 32000.0, 228.650, 868.02, 0.005 }, { 47000.0, 270.650, 110.91, 0.005 },
    { 51000.0, 270.650, 66.939, 0.0005 }, { 71000.0, 214.650, 3.9564, 0.00005 } };
  for (const auto& row : table)
  {
    const double scaleHeight = 287.0529 * row[1] / 9.80665;
    EXPECT_NEAR(atmosphere::Temperature(row[0]), row[1], 5e-4) << row[0];
    EXPECT_NEAR(atmosphere::Pressure(row[0]), row[2], row[3]) << row[0];
    EXPECT_NEAR(atmosphere::HeightFromPressure(row[2]), row[0], scaleHeight * row[3] / row[2]);
  }
  EXPECT_NEAR(atmosphere::Density(101325.0, 288.15), 1.2250, 5e-5);
}

TEST(StandardAtmosphere, HeightInvertsPressureEverywhere)
{
  for (double height = -1000.0; height < 84000.0; height += 123.0)
  {
    EXPECT_NEAR(atmosphere::HeightFromPressure(atmosphere::Pressure(height)), height, 0.01);
  }
}

// By hand: 850 hPa, 280 K: density 85000/(287.0529 * 280) = 1.05755; -1 Pa/s rises at 0.096423 m/s.
TEST(StandardAtmosphere, OmegaByHand)
{
  EXPECT_NEAR(atmosphere::UpwardWindFromOmega(-1.0, 85000.0, 280.0), 0.096423, 1e-6);
}

TEST(Geodesy, BasisIsRightHandedAndOrthonormal)
{
  for (double longitude = -180.0; longitude <= 360.0; longitude += 22.5)
  {
    for (double latitude = -90.0; latitude <= 90.0; latitude += 15.0)
    {
      const geodesy::Basis b = BasisAt(longitude, latitude);
      EXPECT_NEAR(Dot(b.east, b.east), 1.0, 1e-15);
      EXPECT_NEAR(Dot(b.north, b.north), 1.0, 1e-15);
      EXPECT_NEAR(Dot(b.east, b.north), 0.0, 1e-15);
      const Vector3 cross = { b.east[1] * b.north[2] - b.east[2] * b.north[1],
        b.east[2] * b.north[0] - b.east[0] * b.north[2],
        b.east[0] * b.north[1] - b.east[1] * b.north[0] };
      EXPECT_NEAR(Dot(cross, b.up), 1.0, 1e-15);
    }
  }
}

TEST(Geodesy, SeamAndPolesAreExact)
{
  for (double longitude : { 0.0, 45.0, 122.5, 180.0 })
  {
    EXPECT_EQ(BasisAt(longitude, 20.0).up, BasisAt(longitude + 360.0, 20.0).up);
    const Vector3 up = BasisAt(longitude, 90.0).up;
    EXPECT_EQ(std::abs(up[0]) + std::abs(up[1]), 0.0);
    EXPECT_EQ(up[2], 1.0);
  }
  EXPECT_EQ(BasisAt(-180.0, 20.0).up, BasisAt(180.0, 20.0).up);
}

// The displayed position of a parcel a short time before and after, by its longitude, latitude,
// height.
TEST(Geodesy, DisplayVelocityIsTheRateOfTheDisplayPosition)
{
  const geodesy::Planet planet = { 6371000.0, 40.0 };
  const double u = 31.0, v = -17.0, w = 0.4, height = 9000.0, seconds = 0.5;
  const double perDegree = geodesy::RADIANS_PER_DEGREE;
  for (double latitude : { -85.0, -30.0, 0.0, 47.0, 89.0 })
  {
    const double longitude = 77.0;
    const auto at = [&](double t) {
      const double radius = planet.radius + height;
      const double lambda =
        longitude + t * u / (radius * std::cos(latitude * perDegree)) / perDegree;
      return std::array<double, 3>{ lambda, latitude + t * v / radius / perDegree, height + t * w };
    };
    const auto p = at(-seconds), q = at(seconds);
    const geodesy::Basis b = BasisAt(longitude, latitude);
    const Vector3 wind = geodesy::Combine(b, u, v, w);
    const Vector3 globe = geodesy::GlobeDisplayVelocity(planet, b, height, wind);
    const Vector3 map =
      geodesy::MapDisplayVelocity(planet, std::cos(latitude * perDegree), height, u, v, w);
    const Vector3 g0 = geodesy::GlobePosition(planet, BasisAt(p[0], p[1]), p[2]);
    const Vector3 g1 = geodesy::GlobePosition(planet, BasisAt(q[0], q[1]), q[2]);
    const Vector3 m0 = geodesy::MapPosition(planet, p[0] * perDegree, p[1] * perDegree, p[2]);
    const Vector3 m1 = geodesy::MapPosition(planet, q[0] * perDegree, q[1] * perDegree, q[2]);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR((g1[c] - g0[c]) / (2.0 * seconds), globe[c], 1e-5) << latitude;
      EXPECT_NEAR((m1[c] - m0[c]) / (2.0 * seconds), map[c], 1e-5) << latitude;
    }
  }
}

TEST(LongitudeRow, KnowsGlobalFromRegional)
{
  EXPECT_EQ(JudgeCoverage(Row(0.0, 2.5, 144)), Coverage::Open);
  EXPECT_EQ(JudgeCoverage(Row(0.0, 2.5, 145)), Coverage::Closed);
  EXPECT_EQ(JudgeCoverage(Row(180.0, -2.5, 144)), Coverage::Open);
  EXPECT_EQ(JudgeCoverage(Row(0.0, 2.5, 146)), Coverage::Overlap);
  EXPECT_EQ(JudgeCoverage(Row(0.0, 2.5, 142)), Coverage::Regional);
  EXPECT_EQ(JudgeCoverage(Row(-60.0, 1.0, 121)), Coverage::Regional);
  std::vector<double> dateline = { 170.0, 175.0, 180.0, -175.0, -170.0 };
  UnwrapLongitudes(dateline);
  EXPECT_EQ(dateline, Row(170.0, 5.0, 5));
}

TEST(LevelAxis, GuessesUnits)
{
  const HeightTrend unknown = HeightTrend::Unknown;
  EXPECT_EQ(GuessLevelUnits(-1000.0, -100.0, unknown), LevelUnits::Hectopascal);
  EXPECT_EQ(GuessLevelUnits(10.0, 1000.0, unknown), LevelUnits::Hectopascal);
  EXPECT_EQ(GuessLevelUnits(1000.0, 100000.0, unknown), LevelUnits::Pascal);
  EXPECT_EQ(GuessLevelUnits(0.0, 20000.0, unknown), LevelUnits::Metre);
  EXPECT_EQ(GuessLevelUnits(1.0, 100.0, HeightTrend::FallsWithLevel), LevelUnits::Hectopascal);
  EXPECT_EQ(GuessLevelUnits(10.0, 1000.0, HeightTrend::GrowsWithLevel), LevelUnits::Metre);
  EXPECT_EQ(GuessLevelUnits(-1.0, -0.01, unknown), LevelUnits::Sigma);
  EXPECT_EQ(GuessLevelUnits(0.01, 0.997, HeightTrend::FallsWithLevel), LevelUnits::Sigma);
  EXPECT_EQ(GuessLevelUnits(-0.5, -0.01, unknown), LevelUnits::Hectopascal);
  EXPECT_EQ(GuessLevelUnits(0.0, 1.0, unknown), LevelUnits::Metre);
  EXPECT_NEAR(LevelHeight(LevelUnits::Sigma, -0.2233611), 11000.0, 0.1); // 226.32 hPa
  EXPECT_NEAR(LevelHeight(LevelUnits::Hectopascal, -226.3206), 11000.0, 0.1);
  EXPECT_EQ(LevelHeight(LevelUnits::Kilometre, 3.0), 3000.0);
}

TEST(GridOrder, CentresAnyMeridian)
{
  for (double meridian : { -720.0, -90.0, 0.0, 1.0, 180.0, 359.0 })
  {
    GridOrder order;
    order.InputDimensions = { 144, 1, 1 };
    order.OutputDimensions = { 145, 1, 1 };
    order.Period = 144;
    const std::vector<double> row = Row(0.0, 2.5, 144);
    order.Centre(row, meridian);
    double last = -1e9;
    for (int i = 0; i < 145; ++i)
    {
      const double longitude = row[order.OrderedColumn(i)] + order.LongitudeOffset(i);
      EXPECT_NEAR(longitude, i ? last + 2.5 : longitude, 1e-9);
      EXPECT_GE(longitude, meridian - 180.0 - 1e-6);
      EXPECT_LT(longitude, meridian + 180.0 + 2.5);
      last = longitude;
    }
  }
}
