// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudColumn.h"
#include "ParticleOptics.h"

#include <gtest/gtest.h>

using namespace nephoscope;

// By hand: 0.3 g/m3 of droplets of 10 micrometres: 3 * 3e-4 / (2 * 1000 * 1e-5) = 0.045 1/m.
TEST(ParticleOptics, ExtinctionByHand)
{
  EXPECT_NEAR(particles::Extinction(3e-4, particles::WATER_DENSITY, 10e-6), 0.045, 1e-12);
  EXPECT_EQ(particles::Extinction(0.0, particles::WATER_DENSITY, 10e-6), 0.0);
}

// Slingo1989: beta = L (2.817e-2 + 1.305 / r) m2/g in the visible; the limit of large particles is
// within 8 % of it.
TEST(ParticleOptics, DropletsAgreeWithSlingo)
{
  for (double r : { 5.0, 8.0, 10.0 })
  {
    EXPECT_NEAR(
      particles::Extinction(1e-3, particles::WATER_DENSITY, 1e-6 * r) / (2.817e-2 + 1.305 / r), 1.0,
      0.08)
      << r;
  }
  EXPECT_NEAR(particles::DropletAsymmetry(10), 0.85382, 1e-5);
  EXPECT_NEAR(1 - particles::DropletAlbedo(10), 1.574e-6, 1e-9);
}

// Fu1996: beta = I (-6.656e-6 + 2.519884 / D) m2/g with the generalized effective size D in
// micrometres.
TEST(ParticleOptics, CrystalsAgreeWithFu)
{
  for (double size : { 20.0, 50.0, 100.0, 155.0 })
  {
    const double radius = 0.375 * std::sqrt(3.0) * 1e-6 * size;
    EXPECT_NEAR(
      particles::Extinction(1e-3, particles::ICE_DENSITY, radius) / (-6.656e-6 + 2.519884 / size),
      1.0, 0.002)
      << size;
  }
}

TEST(ParticleSize, DropletsByHand)
{
  // 3 * 3e-4 / (4 pi * 1000 * 0.8 * 1e8) = 8.9525e-16; its cube root is 9.6378 micrometres.
  EXPECT_NEAR(particles::DropletRadius(3e-4, 100e6, 0.8), 9.6378e-6, 1e-9);
  EXPECT_NEAR(particles::DropletRadius(3e-4, 300e6, 0.67), 7.0891e-6, 1e-9);
  EXPECT_EQ(particles::DropletRadius(0, 100e6, 0.8), 4e-6);
  EXPECT_EQ(particles::DropletRadius(1, 100e6, 0.8), 24e-6);
}

// 0.01 g/m3 at -40: (1.2351 - 0.42) (45.8966 * 0.360744 + 0.7957 * 0.311172 * 150) = 43.767; times
// 0.6495 = 28.43 micrometres.
TEST(ParticleSize, CrystalsByHand)
{
  EXPECT_NEAR(particles::CrystalRadius(1e-5, 233.15), 28.43e-6, 0.01e-6);
  EXPECT_GT(particles::CrystalRadius(1e-5, 253.15), particles::CrystalRadius(1e-5, 213.15));
  EXPECT_GE(particles::CrystalRadius(0, 150.0), 12.9e-6);
}

// Rain of 1 g/m3 by MarshallPalmer1948: slope (pi 1000 8e6 / 1e-3)^(1/4) = 2239.06 1/m; 1.5 / slope
// = 0.6699 mm.
TEST(ParticleSize, RainByHand)
{
  EXPECT_NEAR(particles::RainRadius(1e-3), 0.66992e-3, 1e-7);
}

TEST(ParticleSize, IceFraction)
{
  EXPECT_EQ(particles::IceFraction(280), 0);
  EXPECT_EQ(particles::IceFraction(240), 1);
  EXPECT_NEAR(particles::IceFraction(263.16), 0.5, 1e-12);
}

// Half of the extinction is liquid with g = 0.85382, half ice with g = 0.783653 (30 micrometres).
TEST(ParticleOptics, MixtureWeighsByScattering)
{
  particles::Optics optics;
  particles::AddDroplets(optics, 2 * 1000 * 10e-6 / 3, 10e-6);
  particles::AddCrystals(optics, 2 * 916.7 * 30e-6 / 3, 30e-6);
  EXPECT_NEAR(optics.Extinction, 2, 1e-12);
  EXPECT_NEAR(optics.Asymmetry(), 0.5 * (0.85382 + 0.783653), 1e-5);
  EXPECT_NEAR(1 - optics.Albedo(), 0.5 * (1.574e-6 + 1e-5), 1e-9);
  EXPECT_EQ(particles::Optics().Albedo(), 1);
}

TEST(CloudColumn, LinearExtinctionIsExact)
{
  const std::vector<double> depth = column::OpticalDepthToEnd({ 0, 2, 1 }, { 3, 4 });
  EXPECT_DOUBLE_EQ(depth[2], 0);
  EXPECT_DOUBLE_EQ(depth[1], 6);
  EXPECT_DOUBLE_EQ(depth[0], 9);
}

// An isothermal column: p falls by exp(-g dz / (R T)).
TEST(CloudColumn, PressureInBalance)
{
  const std::vector<double> p = column::Pressures({ 0, 1000, 5000 }, { 250, 250, 250 });
  EXPECT_NEAR(p[0], 101325, 1e-6);
  EXPECT_NEAR(p[2], 101325 * std::exp(-9.80665 * 5000 / (287.0529 * 250)), 1e-6);
  EXPECT_NEAR(column::Pressures({ 1000 }, {})[0], atmosphere::Pressure(1000), 1e-9);
}
