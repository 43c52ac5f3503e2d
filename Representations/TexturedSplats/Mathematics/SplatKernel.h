// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Reconstruction kernels of splats and their footprints, which are their integrals along a line.
// Lengths are in cells, values are those of a kernel with unit integral. Plain C++17.
#ifndef nephoscope_SplatKernel_h
#define nephoscope_SplatKernel_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
// The piecewise cubic kernel in space whose sum over a lattice is flattest in the mean
// (CrawfisMax1993, table 1): constant data are reconstructed to within -0.23 % and +0.53 %.
namespace cubic_kernel
{
constexpr double innerRadius = 0.889392;
constexpr double radius = 1.556228;
constexpr double inner[4] = { 0.557526, 0.0, -1.157743, 0.671033 }; // of powers of r
constexpr double outerSquare = 0.067599;                            // of (radius - r)^2
constexpr double outerCube = 0.282474;

// The integrals of r^0 .. r^3 along a line at distance rho of the centre, from the point nearest to
// it to z ahead.
inline std::array<double, 4> LineMoments(double rho, double z)
{
  const double square = rho * rho;
  const double r = std::sqrt(square + z * z);
  const double logarithm = rho > 0.0 ? square * std::log((z + r) / rho) : 0.0;
  const double first = 0.5 * (z * r + logarithm);
  return { { z, first, z * (z * z / 3.0 + square), (z * r * r * r + 3.0 * square * first) / 4.0 } };
}

constexpr std::array<double, 4> outerPowers = { { outerSquare * radius * radius +
    outerCube * radius * radius * radius,
  -2.0 * outerSquare* radius - 3.0 * outerCube* radius* radius,
  outerSquare + 3.0 * outerCube* radius, -outerCube } };

// Half of a chord of the ball of radius R.
inline double HalfChord(double R, double rho)
{
  return rho < R ? std::sqrt((R - rho) * (R + rho)) : 0.0;
}

// The integral of the kernel along a line at distance rho of its centre, from the point nearest to
// it to z >= 0 ahead.
inline double FootprintUpTo(double rho, double z)
{
  const auto all = LineMoments(rho, std::min(z, HalfChord(radius, rho)));
  const auto core = LineMoments(rho, std::min(z, HalfChord(innerRadius, rho)));
  double sum = 0.0;
  for (std::size_t n = 0; n < 4; ++n)
  {
    sum += outerPowers[n] * all[n] + (inner[n] - outerPowers[n]) * core[n];
  }
  return rho < radius ? std::max(0.0, sum) : 0.0;
}

// The integral of the kernel along a whole line at distance rho of its centre.
inline double Footprint(double rho)
{
  return 2.0 * FootprintUpTo(rho, radius);
}

// The footprint as (1 - q)^3 times a polynomial of 2 q - 1, where q = (rho / radius)^2, to 1.5e-5:
// without roots and logarithms, for shaders. The polynomial has the least greatest deviation.
constexpr std::array<double, 12> footprintCoefficients = { { 0.32783254, -0.189764633, 0.128078513,
  0.00415959703, 0.280323296, -0.40178336, -1.30090379, 0.814175339, 2.8502731, 0.327845877,
  -2.03252278, -1.00148049 } };

// The share of the kernel along a ray that lies before a cut, in half chords from -1 to 1, for
// shaders: with x = |cut| it is (1 - x)^3 (1/2 + x (c0 + c1 q + x (c2 + c3 q))) on the far side, to
// 8e-4 of a splat's peak.
constexpr std::array<double, 4> shareCoefficients = { { 0.265042, 0.417971, -0.843034, 0.106023 } };

// Mean square distance from the centre along one axis, weighted by the kernel.
constexpr double variance = 0.199406;
}

// The piecewise quadratic kernel of a flat sheet, with the least ripple of its lattice sum, 0.44 %.
// It is a footprint by itself, not the projection of a kernel in space.
namespace quadratic_kernel
{
constexpr double innerRadius = 0.48470;
constexpr double radius = 1.37790;
constexpr double Ring(double r) // integral of r (radius - r)^2
{
  return r * r * (radius * radius / 2.0 - 2.0 * radius * r / 3.0 + r * r / 4.0);
}
// From the unit integral: 1.0208.
constexpr double inner = 1.0 /
  (6.283185307179586 *
    (innerRadius * innerRadius * innerRadius * (radius / 2.0 - innerRadius / 4.0) +
      innerRadius / (radius - innerRadius) * (Ring(radius) - Ring(innerRadius))));
constexpr double outer = inner * innerRadius / (radius - innerRadius);

inline double Footprint(double rho)
{
  if (rho >= radius)
  {
    return 0.0;
  }
  return rho <= innerRadius ? inner * (innerRadius * radius - rho * rho)
                            : outer * (radius - rho) * (radius - rho);
}
}

// A gaussian of the cubic kernel's variance, cut off where it is 1e-4 of its peak; for comparison.
namespace gaussian_kernel
{
constexpr double variance = cubic_kernel::variance;
constexpr double radius = 1.916; // sqrt(2 ln(1e4) variance)

inline double Footprint(double rho)
{
  constexpr double twoPi = 6.283185307179586;
  return rho >= radius ? 0.0 : std::exp(-0.5 * rho * rho / variance) / (twoPi * variance);
}
}

enum class SplatKernel
{
  Cubic = 0,
  Quadratic = 1,
  Gaussian = 2
};

inline double KernelRadius(SplatKernel kernel)
{
  return kernel == SplatKernel::Cubic  ? cubic_kernel::radius
    : kernel == SplatKernel::Quadratic ? quadratic_kernel::radius
                                       : gaussian_kernel::radius;
}

inline double KernelFootprint(SplatKernel kernel, double rho)
{
  return kernel == SplatKernel::Cubic  ? cubic_kernel::Footprint(rho)
    : kernel == SplatKernel::Quadratic ? quadratic_kernel::Footprint(rho)
                                       : gaussian_kernel::Footprint(rho);
}
}

#endif
