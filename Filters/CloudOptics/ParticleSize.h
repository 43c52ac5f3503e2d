// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Effective radii of droplets, ice crystals, rain and snow: the mean of r^3 over that of r^2. Plain
// C++17. Contents in kg/m3, temperatures in kelvins, numbers in 1/m3, radii in metres.
#ifndef nephoscope_ParticleSize_h
#define nephoscope_ParticleSize_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace particles
{
inline constexpr double PI = 3.14159265358979323846;
inline constexpr double WATER_DENSITY = 1000.0;
inline constexpr double ICE_DENSITY = 916.7;
inline constexpr double SNOW_DENSITY = 100.0; // LinFarleyOrville1983

// MartinJohnsonSpice1994, equation 11 with the k of maritime (0.80) and continental (0.67) air.
// `content` and `number` are of the cloud itself.
// Kept between 4 and 24 micrometres, where droplets are.
inline double DropletRadius(double content, double number, double k)
{
  const double radius = std::cbrt(3.0 * content / (4.0 * PI * WATER_DENSITY * k * number));
  return std::min(std::max(radius, 4e-6), 24e-6);
}

// The effective size of SunRikus1999 as Sun2001 revised it, times 3 sqrt(3) / 8: the radius whose
// extinction is that of Fu1996.
// The size is kept between 20 and 155 micrometres.
inline double CrystalRadius(double content, double temperature)
{
  const double grams = std::max(1e3 * content, 1e-9);
  const double celsius = temperature - 273.15;
  const double size = (1.2351 + 0.0105 * celsius) *
    (45.8966 * std::pow(grams, 0.2214) + 0.7957 * std::pow(grams, 0.2535) * (temperature - 83.15));
  return 0.375 * std::sqrt(3.0) * 1e-6 * std::min(std::max(size, 20.0), 155.0);
}

// Sizes are distributed exponentially in the diameter (MarshallPalmer1948): the effective radius is
// 3/2 of the mean diameter.
inline double ExponentialRadius(double content, double density, double intercept)
{
  return 1.5 * std::pow(content / (PI * density * intercept), 0.25);
}

// Intercepts in 1/m4: LinFarleyOrville1983.
inline double RainRadius(double content)
{
  return std::max(ExponentialRadius(content, WATER_DENSITY, 8e6), 5e-5);
}
inline double SnowRadius(double content)
{
  return std::max(ExponentialRadius(content, SNOW_DENSITY, 3e6), 5e-5);
}

// Fraction of ice if only the sum is known: none above 0 degrees Celsius, all below -20, linear in
// between, as in the radiation of GFS (HouMoorthiCampana2002).
inline double IceFraction(double temperature)
{
  return std::min(std::max((273.16 - temperature) / 20.0, 0.0), 1.0);
}
}
}

#endif
