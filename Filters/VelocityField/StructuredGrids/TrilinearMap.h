// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The trilinear map of a hexahedral cell and its inverse. Plain C++17.
#ifndef nephoscope_TrilinearMap_h
#define nephoscope_TrilinearMap_h

#include "GridCell.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
enum class InverseResult
{
  Inside,
  Outside, // the parametric coordinates tell on which side, roughly
  Failed
};

// x(r, s, t) = sum of Coefficients[e] * r^e0 s^e1 t^e2 with e = (e2 e1 e0) in binary, relative to a
// position that the inverse is wanted of, so that large coordinates cost no digits.
class TrilinearMap
{
public:
  template <typename Coordinate>
  TrilinearMap(
    const Coordinate* points, const std::array<std::int64_t, 8>& corners, const Vector3& x)
    : Magnitude(std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) }))
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      double p[8];
      for (std::size_t e = 0; e < 8; ++e)
      {
        p[e] = points[3 * corners[e] + static_cast<std::int64_t>(c)];
      }
      const double bottom = p[1] - p[0];
      const double top = p[5] - p[4];
      const double back = p[3] - p[2];
      this->Coefficients[0][c] = p[0] - x[c];
      this->Coefficients[1][c] = bottom;
      this->Coefficients[2][c] = p[2] - p[0];
      this->Coefficients[3][c] = back - bottom;
      this->Coefficients[4][c] = p[4] - p[0];
      this->Coefficients[5][c] = top - bottom;
      this->Coefficients[6][c] = p[6] - p[4] - (p[2] - p[0]);
      this->Coefficients[7][c] = p[7] - p[6] - top - (back - bottom);
    }
  }

  // Newton's method from `r`, which becomes the parametric coordinates of the position.
  InverseResult Invert(Vector3& r) const
  {
    for (int iteration = 0; iteration < 16; ++iteration)
    {
      Vector3 columns[3];
      const Vector3 residual = this->Evaluate(r, columns);
      Vector3 step = SolveColumns(columns, residual);
      double size = SizeOfStep(step);
      if (!(size < 100.0)) // also NaN
      {
        step = SolveDamped(columns, residual);
        size = SizeOfStep(step);
        if (!(size < 1e30))
        {
          return InverseResult::Failed;
        }
      }
      bool far = false;
      for (std::size_t a = 0; a < 3; ++a)
      {
        r[a] -= step[a];
        far = far || r[a] < -0.1 || r[a] > 1.1;
      }
      if (far)
      {
        for (double& coordinate : r)
        {
          coordinate = std::clamp(coordinate, -3.0, 4.0);
        }
      }
      // The error is of the order of the square of the last step.
      if (size < 1e-7)
      {
        return this->IsInside(r, columns) ? InverseResult::Inside : InverseResult::Outside;
      }
      // Seldom a first step goes too far within the right cell.
      if (far && (size < 0.1 || iteration >= 3))
      {
        return InverseResult::Outside;
      }
    }
    return InverseResult::Failed;
  }

private:
  // The position and its derivatives.
  Vector3 Evaluate(const Vector3& r, Vector3 (&columns)[3]) const
  {
    Vector3 value;
    const auto& k = this->Coefficients;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double a = k[0][c] + r[2] * k[4][c];
      const double ar = k[1][c] + r[2] * k[5][c];
      const double as = k[2][c] + r[2] * k[6][c];
      const double ars = k[3][c] + r[2] * k[7][c];
      columns[0][c] = ar + r[1] * ars;
      columns[1][c] = as + r[0] * ars;
      columns[2][c] = k[4][c] + r[0] * k[5][c] + r[1] * (k[6][c] + r[0] * k[7][c]);
      value[c] = a + r[0] * columns[0][c] + r[1] * as;
    }
    return value;
  }

  static double SizeOfStep(const Vector3& v)
  {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]); // keeps a NaN
  }

  static Vector3 SolveColumns(const Vector3 (&columns)[3], const Vector3& b)
  {
    const Vector3 bc = Cross(columns[1], columns[2]);
    const double inverse = 1.0 / Dot(columns[0], bc);
    const Vector3 xc = Cross(columns[0], b);
    return { inverse * Dot(b, bc), inverse * Dot(columns[2], xc), -inverse * Dot(columns[1], xc) };
  }

  // Where a face has collapsed (a pole) and the columns depend on each other: least squares, damped
  // (Levenberg1944).
  static Vector3 SolveDamped(const Vector3 (&columns)[3], const Vector3& b)
  {
    Vector3 rows[3];
    Vector3 right;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        rows[i][j] = Dot(columns[i], columns[j]);
      }
      right[i] = Dot(columns[i], b);
    }
    const double trace = rows[0][0] + rows[1][1] + rows[2][2];
    for (std::size_t i = 0; i < 3; ++i)
    {
      rows[i][i] += 1e-9 * rows[i][i] + 1e-18 * trace;
    }
    const Vector3 bc = Cross(rows[1], rows[2]);
    const double inverse = 1.0 / Dot(rows[0], bc);
    const Vector3 xc = Cross(rows[0], right);
    return { inverse * Dot(right, bc), inverse * Dot(rows[2], xc), -inverse * Dot(rows[1], xc) };
  }

  // Within the tolerance, or as near to a face as the coordinates can tell.
  bool IsInside(const Vector3& r, const Vector3 (&columns)[3]) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double beyond = std::max(-r[a], r[a] - 1.0);
      if (beyond > PARAMETRIC_TOLERANCE)
      {
        const double rounding = 4e-16 * this->Magnitude;
        const double length = beyond * std::sqrt(Dot(columns[a], columns[a]));
        if (length > rounding)
        {
          return false;
        }
      }
    }
    return true;
  }

  Vector3 Coefficients[8];
  double Magnitude;
};
}

#endif
