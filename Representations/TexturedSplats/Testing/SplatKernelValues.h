// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The kernels of SplatKernel.h by definition, and what its coefficients mean: the reference for
// SplatFootprint.glsl. Plain C++17.
#ifndef nephoscope_SplatKernelValues_h
#define nephoscope_SplatKernelValues_h

#include "SplatKernel.h"

namespace nephoscope
{
namespace cubic_kernel
{
inline double Value(double r)
{
  if (r >= radius)
  {
    return 0.0;
  }
  const double d = radius - r;
  return r <= innerRadius ? inner[0] + r * r * (inner[2] + r * inner[3])
                          : d * d * (outerSquare + d * outerCube);
}

inline double FootprintPolynomial(double q)
{
  double sum = 0.0;
  for (std::size_t i = footprintCoefficients.size(); i-- > 0;)
  {
    sum = sum * (2.0 * q - 1.0) + footprintCoefficients[i];
  }
  return q < 1.0 ? (1.0 - q) * (1.0 - q) * (1.0 - q) * sum : 0.0;
}

inline double ShareBefore(double cut, double q)
{
  const auto& c = shareCoefficients;
  const double x = std::min(std::abs(cut), 1.0);
  const double behind =
    (1.0 - x) * (1.0 - x) * (1.0 - x) * (0.5 + x * (c[0] + c[1] * q + x * (c[2] + c[3] * q)));
  return cut < 0.0 ? behind : 1.0 - behind;
}
}

namespace gaussian_kernel
{
// Along a line it is not cut off.
inline double ShareBefore(double z)
{
  return 0.5 * std::erfc(-z / std::sqrt(2.0 * variance));
}
}

// The share of the kernel's mass along a line at distance rho of its centre that lies before z,
// counted from the point nearest to the centre. The quadratic kernel, a footprint without depth, is
// as deep as the cubic one of the same radius.
inline double KernelShareBefore(SplatKernel kernel, double rho, double z)
{
  if (kernel == SplatKernel::Gaussian)
  {
    return gaussian_kernel::ShareBefore(z);
  }
  const double scale = cubic_kernel::radius / KernelRadius(kernel);
  const double half = cubic_kernel::FootprintUpTo(scale * rho, cubic_kernel::radius);
  const double part =
    half > 0.0 ? cubic_kernel::FootprintUpTo(scale * rho, scale * std::abs(z)) / half : 1.0;
  return z < 0.0 ? 0.5 - 0.5 * part : 0.5 + 0.5 * part;
}
}

#endif
