// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of space that belongs to a grid point: along an axis, on latitudes, and in a hexahedron.
// Plain C++17.
#ifndef nephoscope_DualCells_h
#define nephoscope_DualCells_h

#include "Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nephoscope
{
// Length of axis that is nearer to each point than to its neighbours, within the ends.
// `closingGap`: from the last point to the first of a ring, 0 if the axis is open. One point alone:
// 1.
inline std::vector<double> AxisWidths(const std::vector<double>& x, double closingGap = 0.0)
{
  std::vector<double> widths(x.size(), 0.0);
  for (std::size_t i = 1; i < x.size(); ++i)
  {
    const double half = 0.5 * std::abs(x[i] - x[i - 1]);
    widths[i - 1] += half;
    widths[i] += half;
  }
  if (x.size() == 1)
  {
    widths[0] = 1.0;
  }
  else if (!x.empty())
  {
    widths.front() += 0.5 * closingGap;
    widths.back() += 0.5 * closingGap;
  }
  return widths;
}

// The outer edge of the last row of latitudes, whose inner edge is halfway to the next: the pole,
// if it is no farther than 0.8 of a step (a row at the pole, half a step from it, or 0.77 of one as
// on Gaussian grids); else half a step beyond.
inline double OuterEdge(double row, double inner)
{
  const double halfStep = row - inner;
  const double pole = std::copysign(90.0, halfStep);
  return std::abs(pole - row) <= 1.6 * std::abs(halfStep) ? pole : row + halfStep;
}

// Differences of sin(latitude) between the edges of rows (degrees in), which are halfway between
// them.
inline std::vector<double> LatitudeWidths(const std::vector<double>& latitude)
{
  constexpr double radians = 0.017453292519943295769;
  const std::size_t n = latitude.size();
  if (n == 1)
  {
    return { 1.0 };
  }
  std::vector<double> edges(n + 1);
  for (std::size_t j = 1; j < n; ++j)
  {
    edges[j] = 0.5 * (latitude[j - 1] + latitude[j]);
  }
  edges[0] = OuterEdge(latitude[0], edges[1]);
  edges[n] = OuterEdge(latitude[n - 1], edges[n - 1]);
  std::vector<double> widths(n);
  for (std::size_t j = 0; j < n; ++j)
  {
    const double low = std::max(-90.0, std::min(90.0, edges[j]));
    const double high = std::max(-90.0, std::min(90.0, edges[j + 1]));
    // sin a - sin b, without cancellation
    widths[j] = std::abs(
      2.0 * std::sin(0.5 * (high - low) * radians) * std::cos(0.5 * (high + low) * radians));
  }
  return widths;
}

// Signed volumes of the eight octants, halved in parameter space, of the trilinear hexahedron with
// corners p[i + 2 j + 4 k]. The Jacobian determinant is quadratic in each parameter, so three nodes
// an axis integrate it exactly: over [0, 1/2] with weights 5, 8, -1 (/24) at 0, 1/2, 1.
class HexahedronOctants
{
public:
  explicit HexahedronOctants(const std::array<Vector3, 8>& corners)
  {
    for (int node = 0; node < 27; ++node)
    {
      const int half[3] = { node % 3, node / 3 % 3, node / 9 };
      const double u[3] = { 0.5 * half[0], 0.5 * half[1], 0.5 * half[2] };
      const Vector3 a = Tangent(corners, 0, u);
      const Vector3 b = Tangent(corners, 1, u);
      const Vector3 c = Tangent(corners, 2, u);
      this->Determinants[node] = TripleProduct(b, c, a);
    }
  }

  // Octant at corner i + 2 j + 4 k.
  double Volume(int corner) const
  {
    static constexpr double weights[2][3] = { { 5.0 / 24, 8.0 / 24, -1.0 / 24 },
      { -1.0 / 24, 8.0 / 24, 5.0 / 24 } };
    const double* w[3] = { weights[corner & 1], weights[corner >> 1 & 1],
      weights[corner >> 2 & 1] };
    double sum = 0.0;
    for (int node = 0; node < 27; ++node)
    {
      sum += w[0][node % 3] * w[1][node / 3 % 3] * w[2][node / 9] * this->Determinants[node];
    }
    return sum;
  }

private:
  static Vector3 Tangent(const std::array<Vector3, 8>& p, int axis, const double u[3])
  {
    const int one = 1 << axis;
    Vector3 sum = { { 0.0, 0.0, 0.0 } };
    for (int corner = 0; corner < 8; ++corner)
    {
      if (corner & one)
      {
        continue;
      }
      double weight = 1.0;
      for (int other = 0; other < 3; ++other)
      {
        if (other != axis)
        {
          weight *= corner >> other & 1 ? u[other] : 1.0 - u[other];
        }
      }
      const Vector3 edge = p[corner | one] - p[corner];
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += weight * edge[c];
      }
    }
    return sum;
  }

  std::array<double, 27> Determinants;
};
}

#endif
