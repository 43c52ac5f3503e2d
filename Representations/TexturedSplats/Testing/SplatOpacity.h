// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a splat adds to a pixel: light (premultiplied colour) and opacity. Plain C++17.
#ifndef nephoscope_SplatOpacity_h
#define nephoscope_SplatOpacity_h

#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
using SplatColor = std::array<double, 3>;

struct SplatLight
{
  SplatColor Light{};
  double Transparency = 1.0;
};

// Opacity of an optical depth (extinction times footprint). The product over splats is the exact
// transparency of the reconstructed field, in any order; with an opacity that is linear in the
// footprint it is not.
inline double SplatAlpha(double opticalDepth)
{
  return -std::expm1(-opticalDepth);
}

// A splat of medium with a vector drawn in its middle plane: half of the medium hides the vector,
// and the vector hides the other half.
inline SplatLight MediumAndVector(
  double opticalDepth, const SplatColor& medium, double vectorAlpha, const SplatColor& vector)
{
  const double half = std::exp(-0.5 * opticalDepth);
  SplatLight sum;
  for (std::size_t c = 0; c < 3; ++c)
  {
    sum.Light[c] = medium[c] * (1.0 - half) +
      half * (vectorAlpha * vector[c] + (1.0 - vectorAlpha) * medium[c] * (1.0 - half));
  }
  sum.Transparency = half * half * (1.0 - vectorAlpha);
  return sum;
}
}

#endif
