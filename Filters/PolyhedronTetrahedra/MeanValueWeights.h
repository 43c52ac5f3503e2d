// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Values at new points inside a cell, from the values at the cell's own points.
 *
 * A new point sees all triangles of its link: the faces opposite it in the tetrahedra that meet
 * there. Its value is the mean-value interpolation over the link (JuSchaeferWarren2005;
 * FloaterKosReimers2005 show that the weights are positive where the whole link is seen). The
 * weight of a vertex v at distance |v - x| is the sum over the link's triangles T of w_T,v with
 *   m_T = 1/2 sum_i theta_i n_i,    w_T,i = n_i . m_T / n_i . (v_i - x),
 * where theta_i is the angle at x of the edge opposite vertex i of T, and n_i the unit normal of
 * its plane with x. m_T is the integral of the unit vector over T's solid angle, and these add up
 * to zero around x: so a linear field is reproduced exactly.
 *
 * With several new points in one cell each depends on others; (I - W) v_new = U v_old is solved. W
 * has no negative entry and each row of (W U) sums to 1, so that the matrix is regular, and the
 * weights on old points are not negative and sum to 1: no new value lies outside the range of the
 * cell's values.
 */
#ifndef nephoscope_MeanValueWeights_h
#define nephoscope_MeanValueWeights_h

#include "Tetrahedron.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nephoscope
{

/** Adds the weights of one outward triangle of the link of x. */
template <typename Add>
void AddMeanValueWeights(const Vector3& x, const std::array<Vector3, 3>& corners, Add add)
{
  std::array<Vector3, 3> arm;
  for (std::size_t i = 0; i < 3; ++i)
  {
    arm[i] = Difference(corners[i], x);
  }
  std::array<Vector3, 3> normal;
  Vector3 mean{ { 0, 0, 0 } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3 &p = arm[(i + 1) % 3], &q = arm[(i + 2) % 3];
    const Vector3 across = Cross(p, q);
    const double sine = std::sqrt(Dot(across, across)); // times both lengths
    const double angle = std::atan2(sine, Dot(p, q));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      normal[i][axis] = sine > 0 ? across[axis] / sine : 0;
      mean[axis] += 0.5 * angle * normal[i][axis];
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double height = Dot(normal[i], arm[i]);
    if (height > 0) // a triangle edge-on to x has no solid angle
    {
      add(i, Dot(normal[i], mean) / height);
    }
  }
}

/**
 * The weights of the old vertices at each new one. Vertices from `numberOfOld` on are new;
 * tetrahedra are positively oriented. weights[k][v]: of old vertex v at new vertex k.
 */
inline std::vector<std::vector<double>> NewPointWeights(const std::vector<Vector3>& positions,
  int numberOfOld, const std::vector<std::array<int, 4>>& tetrahedra)
{
  const auto old = static_cast<std::size_t>(numberOfOld);
  const std::size_t all = positions.size();
  std::vector<std::vector<double>> rows(all - old, std::vector<double>(all, 0.0));
  // Faces opposite each vertex, wound outward.
  constexpr int outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  for (const std::array<int, 4>& t : tetrahedra)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const auto x = static_cast<std::size_t>(t[i]);
      if (x < old)
      {
        continue;
      }
      std::array<Vector3, 3> corners;
      std::array<std::size_t, 3> vertices;
      for (std::size_t k = 0; k < 3; ++k)
      {
        vertices[k] = static_cast<std::size_t>(t[static_cast<std::size_t>(outward[i][k])]);
        corners[k] = positions[vertices[k]];
      }
      AddMeanValueWeights(
        positions[x], corners, [&](std::size_t k, double w) { rows[x - old][vertices[k]] += w; });
    }
  }
  // Rows of (-W + I | U), then Gauss-Jordan elimination; diagonally dominant, so without pivoting.
  const std::size_t count = rows.size();
  for (std::size_t r = 0; r < count; ++r)
  {
    double sum = 0;
    for (const double w : rows[r])
    {
      sum += w;
    }
    for (std::size_t c = 0; c < all; ++c)
    {
      rows[r][c] *= (c < old ? 1 : -1) / sum;
    }
    rows[r][old + r] += 1;
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    const double pivot = rows[k][old + k];
    for (double& value : rows[k])
    {
      value /= pivot;
    }
    for (std::size_t r = 0; r < count; ++r)
    {
      const double factor = rows[r][old + k];
      for (std::size_t c = 0; r != k && factor != 0 && c < all; ++c)
      {
        rows[r][c] -= factor * rows[k][c];
      }
    }
  }
  for (auto& row : rows)
  {
    row.resize(old);
  }
  return rows;
}

} // namespace nephoscope

#endif
