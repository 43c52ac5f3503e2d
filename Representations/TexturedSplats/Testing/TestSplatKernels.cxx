// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Kernels and footprints against quadrature, published values and lattice sums. */
#include "SplatCost.h"
#include "SplatKernelValues.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using nephoscope::SplatKernel;

double Simpson(const std::function<double(double)>& f, double a, double b, int steps)
{
  const double h = (b - a) / steps;
  double sum = f(a) + f(b);
  for (int i = 1; i < steps; ++i)
  {
    sum += (i % 2 ? 4.0 : 2.0) * f(a + i * h);
  }
  return sum * h / 3.0;
}

double LatticeSum(double x, double y, double z)
{
  double sum = 0.0;
  for (int i = -2; i <= 3; ++i)
  {
    for (int j = -2; j <= 3; ++j)
    {
      for (int k = -2; k <= 3; ++k)
      {
        sum += nephoscope::cubic_kernel::Value(
          std::sqrt((x - i) * (x - i) + (y - j) * (y - j) + (z - k) * (z - k)));
      }
    }
  }
  return sum;
}

double SheetSum(SplatKernel kernel, double x, double y)
{
  double sum = 0.0;
  for (int i = -3; i <= 4; ++i)
  {
    for (int j = -3; j <= 4; ++j)
    {
      sum += nephoscope::KernelFootprint(kernel, std::hypot(x - i, y - j));
    }
  }
  return sum;
}

double DiskIntegral(SplatKernel kernel)
{
  const double pi = std::acos(-1.0);
  return Simpson([&](double r) { return 2.0 * pi * r * nephoscope::KernelFootprint(kernel, r); },
    0.0, nephoscope::KernelRadius(kernel), 4000);
}
}

TEST(CubicKernel, FootprintIsTheLineIntegral)
{
  using namespace nephoscope::cubic_kernel;
  for (double rho = 0.0; rho < radius; rho += 0.0371)
  {
    const double half = std::sqrt(radius * radius - rho * rho);
    const double exact =
      2.0 * Simpson([&](double z) { return Value(std::hypot(rho, z)); }, 0.0, half, 20000);
    EXPECT_NEAR(Footprint(rho), exact, 2e-9) << rho;
  }
}

TEST(CubicKernel, FootprintHasThePublishedValues)
{
  using nephoscope::cubic_kernel::Footprint;
  EXPECT_NEAR(Footprint(0.0), 0.6999434253238361, 1e-12);
  EXPECT_NEAR(Footprint(0.25), 0.6200474997902856, 1e-12);
  EXPECT_NEAR(Footprint(0.5), 0.4277432415209295, 1e-12);
  EXPECT_NEAR(Footprint(1.0), 0.0738679948576646, 1e-12);
  EXPECT_NEAR(Footprint(1.25), 0.012688899990392688, 1e-12);
  EXPECT_EQ(Footprint(1.6), 0.0);
}

TEST(CubicKernel, PolynomialIsTheFootprint)
{
  using namespace nephoscope::cubic_kernel;
  for (double rho = 0.0; rho < 1.6; rho += 0.0013)
  {
    EXPECT_NEAR(FootprintPolynomial(rho * rho / (radius * radius)), Footprint(rho), 1.55e-5) << rho;
  }
}

TEST(CubicKernel, ShareBeforeACutIsTheIntegral)
{
  using namespace nephoscope::cubic_kernel;
  for (double rho = 0.0; rho < radius; rho += 0.083)
  {
    const double half = std::sqrt(radius * radius - rho * rho);
    const double q = rho * rho / (radius * radius);
    for (double cut = -1.0; cut <= 1.0; cut += 0.0625)
    {
      const double part =
        Simpson([&](double z) { return Value(std::hypot(rho, z)); }, -half, cut * half, 2000);
      const double share =
        nephoscope::KernelShareBefore(nephoscope::SplatKernel::Cubic, rho, cut * half);
      EXPECT_NEAR(share * Footprint(rho), part, 1e-9) << rho << " " << cut;
      EXPECT_NEAR(ShareBefore(cut, q) * Footprint(rho), part, 8e-4 * Footprint(0.0))
        << rho << " " << cut;
    }
    EXPECT_EQ(ShareBefore(-1.5, q), 0.0);
    EXPECT_EQ(ShareBefore(1.5, q), 1.0);
    EXPECT_EQ(nephoscope::KernelShareBefore(nephoscope::SplatKernel::Cubic, rho, -1e37), 0.0);
    EXPECT_EQ(nephoscope::KernelShareBefore(nephoscope::SplatKernel::Cubic, rho, 1e37), 1.0);
  }
}

TEST(GaussianKernel, ShareBeforeACutIsTheIntegral)
{
  using namespace nephoscope::gaussian_kernel;
  for (double rho = 0.0; rho < radius; rho += 0.17)
  {
    const auto value = [&](double z) {
      return std::exp(-0.5 * (rho * rho + z * z) / variance) /
        std::pow(6.283185307179586 * variance, 1.5);
    };
    for (double z = -3.0; z <= 3.0; z += 0.25)
    {
      const double share = nephoscope::KernelShareBefore(nephoscope::SplatKernel::Gaussian, rho, z);
      EXPECT_NEAR(share * Footprint(rho), Simpson(value, -6.0, z, 4000), 1e-9) << rho << " " << z;
    }
  }
}

TEST(CubicKernel, LatticeSumIsFlat)
{
  EXPECT_NEAR(LatticeSum(0, 0, 0), 1.0007489513372883, 1e-6);
  EXPECT_NEAR(LatticeSum(0.5, 0.5, 0), 1.0053347989862678, 1e-6);
  EXPECT_NEAR(LatticeSum(0.5, 0.5, 0.5), 1.0005397486660996, 1e-6);
  EXPECT_NEAR(LatticeSum(0.25, 0.25, 0.25), 0.9976923135692721, 1e-6);
  double low = 2.0, high = 0.0;
  for (int i = 0; i <= 15; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        const double sum = LatticeSum(i / 30.0, j / 30.0, k / 30.0);
        low = std::min(low, sum);
        high = std::max(high, sum);
      }
    }
  }
  EXPECT_NEAR(low, 0.997671, 2e-5);
  EXPECT_NEAR(high, 1.005335, 2e-5);
}

TEST(CubicKernel, ColumnsOfALatticeSeenAlongAnAxis)
{
  EXPECT_NEAR(SheetSum(SplatKernel::Cubic, 0, 0), 1.0010322982424198, 1e-6);
  EXPECT_NEAR(SheetSum(SplatKernel::Cubic, 0.5, 0.5), 1.002491337, 1e-6);
  EXPECT_NEAR(-std::expm1(-SheetSum(SplatKernel::Cubic, 0.5, 0.5)), 0.633035930, 1e-6);
}

TEST(CubicKernel, VarianceIsThatOfTheKernel)
{
  using namespace nephoscope::cubic_kernel;
  const double pi = std::acos(-1.0);
  const double square =
    Simpson([&](double r) { return 4.0 * pi * r * r * r * r * Value(r); }, 0.0, innerRadius, 2000) +
    Simpson(
      [&](double r) { return 4.0 * pi * r * r * r * r * Value(r); }, innerRadius, radius, 2000);
  EXPECT_NEAR(square / 3.0, variance, 1e-5);
}

TEST(QuadraticKernel, SheetIsFlatToItsRipple)
{
  double low = 2.0, high = 0.0;
  for (int i = 0; i <= 40; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      const double sum = SheetSum(SplatKernel::Quadratic, i / 80.0, j / 80.0);
      low = std::min(low, sum);
      high = std::max(high, sum);
    }
  }
  EXPECT_NEAR(low, 0.995564, 2e-5);
  EXPECT_NEAR(high, 1.004436, 2e-5);
}

TEST(AllKernels, HaveUnitIntegral)
{
  EXPECT_NEAR(DiskIntegral(SplatKernel::Cubic), 0.9999992, 2e-6);
  EXPECT_NEAR(DiskIntegral(SplatKernel::Quadratic), 1.0, 2e-6);
  EXPECT_NEAR(DiskIntegral(SplatKernel::Gaussian), 1.0 - 1e-4, 2e-6);
}

TEST(SplatCost, IsToldOfVeryManySplats)
{
  EXPECT_EQ(nephoscope::TellSplatCost(1000000), "");
  const std::string told = nephoscope::TellSplatCost(12000000);
  EXPECT_EQ(told.find("12.0 million splats take about 3.0 GB"), 0u);
  EXPECT_NE(told.find("ErrorTolerance"), std::string::npos);
}
