// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How much a map stretches its surroundings, from its derivatives. Plain C++17.
#ifndef nephoscope_FlowMapStretch_h
#define nephoscope_FlowMapStretch_h

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
using Matrix3 = std::array<std::array<double, 3>, 3>;

// The largest eigenvalue of a symmetric matrix, in closed form (Smith1961: trigonometric solution
// of the cubic).
inline double LargestEigenvalue(const Matrix3& a)
{
  const double off = a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
  const double mean = (a[0][0] + a[1][1] + a[2][2]) / 3.0;
  double squares = 2.0 * off;
  for (std::size_t i = 0; i < 3; ++i)
  {
    squares += (a[i][i] - mean) * (a[i][i] - mean);
  }
  const double p = std::sqrt(squares / 6.0);
  if (!(p > 0.0))
  {
    return mean;
  }
  const double b00 = (a[0][0] - mean) / p;
  const double b11 = (a[1][1] - mean) / p;
  const double b22 = (a[2][2] - mean) / p;
  const double b01 = a[0][1] / p;
  const double b02 = a[0][2] / p;
  const double b12 = a[1][2] / p;
  const double halfDeterminant = 0.5 *
    (b00 * (b11 * b22 - b12 * b12) - b01 * (b01 * b22 - b12 * b02) + b02 * (b01 * b12 - b11 * b02));
  return mean + 2.0 * p * std::cos(std::acos(std::clamp(halfDeterminant, -1.0, 1.0)) / 3.0);
}

// The largest factor by which lengths grow under a linear map: its largest singular value. Columns
// are the images of orthonormal vectors; unused ones are zero.
inline double LargestStretch(const Matrix3& columns)
{
  Matrix3 products{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      products[i][j] = columns[i][0] * columns[j][0] + columns[i][1] * columns[j][1] +
        columns[i][2] * columns[j][2];
    }
  }
  return std::sqrt(std::max(0.0, LargestEigenvalue(products)));
}

// 1/s (Haller2001). 0 for an age of 0.
inline double LyapunovExponent(double stretch, double age)
{
  return age > 0.0 && stretch > 0.0 ? std::log(stretch) / age : 0.0;
}

// How much of a set's weight is left where its texture has been stretched: 1 where it is not, one
// half at `limit`.
inline double WeightLeft(double stretch, double limit)
{
  const double ratio = stretch / limit;
  return 1.0 / (1.0 + ratio * ratio * ratio * ratio);
}
}

#endif
