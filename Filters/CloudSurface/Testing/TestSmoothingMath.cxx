// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The exchange between neighbours, the volumes of points and the neighbours themselves, against
// closed forms.
#include "DualCells.h"
#include "GridTopology.h"
#include "SmoothingKernel.h"
#include "TestRandom.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

using namespace nephoscope;

namespace
{
using Row = std::vector<double>;

// One pass over a row, as the filters do it.
Row Smoothed(const Row& f, const Row& m, bool ring, double strength = 1.0)
{
  GridTopology topology;
  topology.Size = { { static_cast<int>(f.size()), 1, 1 } };
  topology.Ring[0] = ring;
  Row out(f.size());
  for (int i = 0; i < static_cast<int>(f.size()); ++i)
  {
    const int a = topology.Step(0, i, -1);
    const int b = topology.Step(0, i, 1);
    out[i] = SmoothedValue(f[i], m[i], f[a], m[a], f[b], m[b], strength);
  }
  return out;
}

Row Noise(nephoscope_test::Random& random, int n)
{
  Row row(n);
  for (double& value : row)
  {
    value = random.Normal();
  }
  return row;
}

Row Masses(nephoscope_test::Random& random, int n)
{
  Row row(n);
  for (double& value : row)
  {
    value = random.LogUniform(1e-3, 1e3);
  }
  return row;
}

double Total(const Row& f, const Row& m)
{
  return std::inner_product(f.begin(), f.end(), m.begin(), 0.0);
}
}

TEST(SmoothingKernel, EqualMassesGiveOneTwoOne)
{
  const Row out = Smoothed({ 1, 0, 0, 8, 0 }, Row(5, 3.0), false);
  EXPECT_EQ(out, (Row{ 0.75, 0.25, 2, 4, 2 })); // the ends keep 3/4
  EXPECT_EQ(Smoothed({ 1, 0, 0, 8, 0 }, Row(5, 3.0), true), (Row{ 0.5, 0.25, 2, 4, 2.25 }));
}

TEST(SmoothingKernel, WavesShrinkByCosineSquared)
{
  for (int n : { 2, 3, 4, 8, 16, 32 })
  {
    Row wave(n);
    for (int i = 0; i < n; ++i)
    {
      wave[i] = std::cos(2 * M_PI * i / n);
    }
    const double factor = std::pow(std::cos(M_PI / n), 2);
    const Row out = Smoothed(wave, Row(n, 1.0), true);
    for (int i = 0; i < n; ++i)
    {
      EXPECT_NEAR(out[i], factor * wave[i], 1e-15) << n << " points, at " << i;
    }
  }
}

TEST(SmoothingKernel, UnevenMassesKeepTheTotalTheRangeAndConstants)
{
  nephoscope_test::Random random(5);
  for (int run = 0; run < 200; ++run)
  {
    const int n = random.Integer(2, 40);
    const bool ring = run % 2 == 0;
    const Row m = Masses(random, n);
    const Row f = Noise(random, n);
    const Row out = Smoothed(f, m, ring, random.Uniform(0.1, 1.0));
    double scale = 0;
    for (int i = 0; i < n; ++i)
    {
      scale += std::abs(m[i] * f[i]);
    }
    EXPECT_NEAR(Total(out, m), Total(f, m), 1e-15 * n * scale);
    EXPECT_LE(*std::max_element(out.begin(), out.end()), *std::max_element(f.begin(), f.end()));
    EXPECT_GE(*std::min_element(out.begin(), out.end()), *std::min_element(f.begin(), f.end()));
    const Row constant(n, random.Normal());
    EXPECT_EQ(Smoothed(constant, m, ring), constant);
  }
}

TEST(SmoothingKernel, MissingPointsTakeNoPart)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Row out = Smoothed({ 4, nan, 8, 0 }, { 1, 0, 1, 1 }, false);
  EXPECT_EQ(out[0], 4);
  EXPECT_TRUE(std::isnan(out[1]));
  EXPECT_EQ(out[2], 6);
  EXPECT_EQ(out[3], 2);
}

TEST(SmoothingKernel, RepeatedPassesAddTheirVariances)
{
  for (double ratio : { 0.3, 1.0, 2.0, 7.4, 30.0 })
  {
    const RepeatedPass passes = PassesFor(ratio, 100);
    EXPECT_NEAR(passes.Count * passes.Strength, ratio, 1e-12);
    Row f(401, 0.0);
    f[200] = 1.0;
    for (int pass = 0; pass < passes.Count; ++pass)
    {
      f = Smoothed(f, Row(401, 1.0), false, passes.Strength);
    }
    double variance = 0.0;
    for (int i = 0; i < 401; ++i)
    {
      variance += f[i] * (i - 200) * (i - 200);
    }
    EXPECT_NEAR(variance, 0.5 * ratio, 1e-10); // one pass: 1/2
  }
  EXPECT_EQ(PassesFor(1e9, 10).Count, 100);
  EXPECT_EQ(PassesFor(0.0, 10).Count, 0);
  EXPECT_EQ(PassesFor(std::numeric_limits<double>::infinity(), 10).Count, 100);
  EXPECT_EQ(PassesFor(std::numeric_limits<double>::quiet_NaN(), 10).Count, 0);
}

TEST(DualCells, WidthsOfAnAxis)
{
  EXPECT_EQ(AxisWidths({ 0, 1, 4, 6 }), (Row{ 0.5, 2, 2.5, 1 }));
  EXPECT_EQ(AxisWidths({ 6, 4, 1, 0 }), (Row{ 1, 2.5, 2, 0.5 }));
  EXPECT_EQ(AxisWidths({ 0, 1, 4, 6 }, 3), (Row{ 2, 2, 2.5, 2.5 }));
  EXPECT_EQ(AxisWidths({ 7 }), (Row{ 1 }));
}

TEST(DualCells, LatitudesFillTheSphere)
{
  for (const Row& latitudes :
    { Row{ -90, -60, -30, 0, 30, 60, 90 }, Row{ 75, 45, 15, -15, -45, -75 } })
  {
    const Row widths = LatitudeWidths(latitudes);
    EXPECT_NEAR(std::accumulate(widths.begin(), widths.end(), 0.0), 2.0, 1e-15);
    for (std::size_t j = 0; j < widths.size(); ++j)
    {
      const double low = std::max(-90.0, latitudes[j] - 15) * M_PI / 180;
      const double high = std::min(90.0, latitudes[j] + 15) * M_PI / 180;
      EXPECT_NEAR(widths[j], std::sin(high) - std::sin(low), 1e-15);
    }
  }
}

TEST(DualCells, LatitudesOfARegionEndHalfAStepBeyondIt)
{
  const Row widths = LatitudeWidths({ 10, 20, 30 });
  EXPECT_NEAR(std::accumulate(widths.begin(), widths.end(), 0.0),
    std::sin(35 * M_PI / 180) - std::sin(5 * M_PI / 180), 1e-15);
}

TEST(DualCells, OctantsOfABox)
{
  std::array<Vector3, 8> corners;
  for (int c = 0; c < 8; ++c)
  {
    corners[c] = { { 2.0 * (c & 1), 3.0 * (c >> 1 & 1), 5.0 * (c >> 2) } };
  }
  const HexahedronOctants octants(corners);
  for (int c = 0; c < 8; ++c)
  {
    EXPECT_NEAR(octants.Volume(c), 30.0 / 8, 1e-13);
  }
}

// The determinant integrated by brute force over each octant.
TEST(DualCells, OctantsOfATwistedHexahedron)
{
  nephoscope_test::Random random(8);
  std::array<Vector3, 8> p;
  for (int c = 0; c < 8; ++c)
  {
    p[c] = { { (c & 1) + random.Uniform(-0.2, 0.2), (c >> 1 & 1) + random.Uniform(-0.2, 0.2),
      (c >> 2) + random.Uniform(-0.2, 0.2) } };
  }
  const auto at = [&](double u, double v, double w) {
    Vector3 x = { { 0, 0, 0 } };
    for (int c = 0; c < 8; ++c)
    {
      const double weight = (c & 1 ? u : 1 - u) * (c & 2 ? v : 1 - v) * (c & 4 ? w : 1 - w);
      for (int d = 0; d < 3; ++d)
      {
        x[d] += weight * p[c][d];
      }
    }
    return x;
  };
  const HexahedronOctants octants(p);
  const int n = 24;
  const double h = 0.5 / n;
  for (int c = 0; c < 8; ++c)
  {
    double volume = 0.0;
    for (int cell = 0; cell < n * n * n; ++cell)
    {
      const double u = 0.5 * (c & 1) + h * (cell % n + 0.5);
      const double v = 0.5 * (c >> 1 & 1) + h * (cell / n % n + 0.5);
      const double w = 0.5 * (c >> 2) + h * (cell / n / n + 0.5);
      const double e = 1e-4;
      const Vector3 a = at(u + e, v, w) - at(u - e, v, w);
      const Vector3 b = at(u, v + e, w) - at(u, v - e, w);
      const Vector3 d = at(u, v, w + e) - at(u, v, w - e);
      volume += Dot(a, Cross(b, d)) / (8 * e * e * e) * h * h * h;
    }
    EXPECT_NEAR(octants.Volume(c), volume, 1e-5);
  }
}

TEST(GridTopology, NeighborsOfARingWithARepeatedPoint)
{
  GridTopology t;
  t.Size = { { 5, 3, 2 } };
  t.Ring[0] = t.Repeated[0] = true;
  EXPECT_EQ(t.Distinct(0), 4);
  EXPECT_EQ(t.Step(0, 3, 1), 0);
  EXPECT_EQ(t.Step(0, 0, -1), 3);
  EXPECT_EQ(t.Step(1, 0, -1), 0);
  EXPECT_EQ(t.Step(1, 2, 1), 2);
  EXPECT_EQ(t.Canonical({ { 4, 1, 0 } }), (GridIndex{ { 0, 1, 0 } }));
  for (std::int64_t id = 0; id < t.Count(); ++id)
  {
    EXPECT_EQ(t.Id(t.Index(id)), id);
  }
  t.Poles.push_back({ 0, 1, true });
  EXPECT_EQ(t.PoleAt({ { 1, 2, 0 } }), &t.Poles[0]);
  EXPECT_EQ(t.PoleAt({ { 1, 0, 0 } }), nullptr);
}
