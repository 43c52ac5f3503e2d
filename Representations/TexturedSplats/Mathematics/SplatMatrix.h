// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Vectors and 3x3 matrices of the splats' mathematics. Plain C++17.
#ifndef nephoscope_SplatMatrix_h
#define nephoscope_SplatMatrix_h

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
using SplatMatrix = std::array<Vector3, 3>; // columns

inline Vector3 ToDouble(const std::array<float, 3>& v)
{
  return { { v[0], v[1], v[2] } };
}

inline SplatMatrix ToDouble(const std::array<std::array<float, 3>, 3>& m)
{
  return { { ToDouble(m[0]), ToDouble(m[1]), ToDouble(m[2]) } };
}

inline Vector3 Times(const SplatMatrix& m, const Vector3& v)
{
  Vector3 product{};
  for (std::size_t row = 0; row < 3; ++row)
  {
    product[row] = m[0][row] * v[0] + m[1][row] * v[1] + m[2][row] * v[2];
  }
  return product;
}

inline SplatMatrix Product(const SplatMatrix& m, const SplatMatrix& n)
{
  return { { Times(m, n[0]), Times(m, n[1]), Times(m, n[2]) } };
}

inline double Determinant(const SplatMatrix& m)
{
  return TripleProduct(m[1], m[2], m[0]);
}

// Largest factor by which a matrix stretches a vector.
inline double LargestStretch(const SplatMatrix& m)
{
  const double a = Dot(m[0], m[0]), b = Dot(m[1], m[1]), c = Dot(m[2], m[2]);
  const double d = Dot(m[0], m[1]), e = Dot(m[1], m[2]), f = Dot(m[0], m[2]);
  const double mean = (a + b + c) / 3.0;
  const double square = ((a - mean) * (a - mean) + (b - mean) * (b - mean) +
                          (c - mean) * (c - mean) + 2.0 * (d * d + e * e + f * f)) /
    6.0;
  if (square <= 0.0)
  {
    return std::sqrt(mean);
  }
  // The eigenvalues of a symmetric matrix, by the roots of a cubic in closed form (Smith 1961).
  const double p = std::sqrt(square);
  const double x = (a - mean) / p, y = (b - mean) / p, z = (c - mean) / p;
  const double u = d / p, v = e / p, w = f / p;
  const double half = 0.5 * (x * (y * z - v * v) - u * (u * z - v * w) + w * (u * v - y * w));
  return std::sqrt(mean + 2.0 * p * std::cos(std::acos(std::clamp(half, -1.0, 1.0)) / 3.0));
}

// The determinant must not be 0.
inline SplatMatrix Inverse(const SplatMatrix& m)
{
  const double d = 1.0 / Determinant(m);
  const Vector3 rows[3] = { Cross(m[1], m[2]), Cross(m[2], m[0]), Cross(m[0], m[1]) };
  SplatMatrix inverse;
  for (std::size_t column = 0; column < 3; ++column)
  {
    inverse[column] = { { d * rows[0][column], d * rows[1][column], d * rows[2][column] } };
  }
  return inverse;
}
}

#endif
