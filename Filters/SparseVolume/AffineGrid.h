// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Affine maps from the indices of a lattice to positions. Plain C++17.
#ifndef nephoscope_AffineGrid_h
#define nephoscope_AffineGrid_h

#include "Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
// Rows of a 4 x 4 matrix for column vectors; the last row is (0, 0, 0, 1).
using AffineMatrix = std::array<double, 16>;

inline Vector3 Column(const AffineMatrix& m, std::size_t column)
{
  return { { m[column], m[4 + column], m[8 + column] } };
}

inline Vector3 Apply(const AffineMatrix& m, const Vector3& x)
{
  Vector3 y;
  for (std::size_t row = 0; row < 3; ++row)
  {
    y[row] = m[4 * row] * x[0] + m[4 * row + 1] * x[1] + m[4 * row + 2] * x[2] + m[4 * row + 3];
  }
  return y;
}

// Edge lengths of a voxel.
inline Vector3 Spacing(const AffineMatrix& m)
{
  return { { Norm(Column(m, 0)), Norm(Column(m, 1)), Norm(Column(m, 2)) } };
}

inline double VoxelVolume(const AffineMatrix& m)
{
  return std::abs(TripleProduct(Column(m, 1), Column(m, 2), Column(m, 0)));
}

// Whether the edges of a voxel meet at right angles, to a share of 1e-6: what an image can hold.
inline bool IsRectangular(const AffineMatrix& m)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const Vector3 u = Column(m, a), v = Column(m, (a + 1) % 3);
    if (std::abs(Dot(u, v)) > 1e-6 * Norm(u) * Norm(v))
    {
      return false;
    }
  }
  return true;
}

// Whether two lattices are the same: edges to a share of 1e-6, places to 1e-3 of a voxel.
inline bool IsSameLattice(const AffineMatrix& a, const AffineMatrix& b)
{
  const Vector3 edges = Spacing(a);
  const double longest = *std::max_element(edges.begin(), edges.end());
  const double shortest = *std::min_element(edges.begin(), edges.end());
  for (std::size_t i = 0; i < 12; ++i)
  {
    const double tolerance = i % 4 == 3 ? 1e-3 * shortest : 1e-6 * longest;
    if (!(std::abs(a[i] - b[i]) <= tolerance))
    {
      return false;
    }
  }
  return true;
}

// The determinant must not be 0.
inline AffineMatrix InverseOf(const AffineMatrix& m)
{
  AffineMatrix inverse{};
  double determinant = 0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      // Cofactors by cyclic indices carry their sign.
      const std::size_t r1 = (column + 1) % 3, r2 = (column + 2) % 3;
      const std::size_t c1 = (row + 1) % 3, c2 = (row + 2) % 3;
      inverse[4 * row + column] = m[4 * r1 + c1] * m[4 * r2 + c2] - m[4 * r1 + c2] * m[4 * r2 + c1];
    }
  }
  for (std::size_t column = 0; column < 3; ++column)
  {
    determinant += m[column] * inverse[4 * column];
  }
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      inverse[4 * row + column] /= determinant;
    }
    inverse[4 * row + 3] =
      -(inverse[4 * row] * m[3] + inverse[4 * row + 1] * m[7] + inverse[4 * row + 2] * m[11]);
  }
  inverse[15] = 1;
  return inverse;
}
}

#endif
