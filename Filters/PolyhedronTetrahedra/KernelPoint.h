// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A point that sees the whole inside of a closed surface, if there is one.
 *
 * The kernel of a polyhedron is where all its facets are seen from inside: the intersection of the
 * half-spaces n_i . x <= d_i of its outward triangles. Sought is the centre of the largest ball in
 * it, a linear programme in (x, r):
 *   maximise r subject to n_i . x + r <= d_i.
 * It is solved by an interior-point method (BoydVandenberghe2004, section 11.3): Newton steps on
 *   -r / mu - sum log(d_i - n_i . x - r)
 * for decreasing mu. Every start is feasible with an r that is negative enough, so that one method
 * finds out whether the kernel is empty (r < 0 at the optimum) and where its middle is; that the
 * surface is closed keeps x bounded. Given up once r cannot become positive any more: r is at most
 * (number of triangles) * mu below its optimum.
 */
#ifndef nephoscope_KernelPoint_h
#define nephoscope_KernelPoint_h

#include "Tetrahedron.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nephoscope
{

/** A half-space n . x <= d; n has length 1. */
struct HalfSpace
{
  Vector3 Normal;
  double Offset;
};

struct Ball
{
  Vector3 Center{ { 0, 0, 0 } };
  double Radius = 0;
};

class KernelPoint
{
public:
  /**
   * Coordinates should be of the order of 1 and the origin in the middle of the cell. Returns a
   * ball in the kernel whose radius is within 2 % of the largest, or one of negative radius if the
   * kernel is empty.
   */
  static Ball Find(const std::vector<HalfSpace>& halfSpaces)
  {
    Ball ball;
    ball.Radius = Room(halfSpaces, ball.Center) - 1;
    const double n = static_cast<double>(halfSpaces.size());
    for (double mu = 1; mu > 1e-9; mu *= 0.25)
    {
      Center(halfSpaces, mu, ball);
      const double room = Room(halfSpaces, ball.Center);
      if (room + n * mu < 0 || n * mu < 0.02 * room)
      {
        break;
      }
    }
    ball.Radius = Room(halfSpaces, ball.Center);
    return ball;
  }

  /** Radius of the largest ball around x in all half-spaces; negative outside. */
  static double Room(const std::vector<HalfSpace>& halfSpaces, const Vector3& x)
  {
    double room = 1e300;
    for (const HalfSpace& h : halfSpaces)
    {
      room = std::min(room, h.Offset - Dot(h.Normal, x));
    }
    return room;
  }

private:
  using Vector = std::array<double, 4>;
  using Matrix = std::array<Vector, 4>;

  // Newton's method with backtracking, on (x, r).
  static void Center(const std::vector<HalfSpace>& halfSpaces, double mu, Ball& ball)
  {
    for (int step = 0; step < 20; ++step)
    {
      Vector gradient{ { 0, 0, 0, -1 / mu } };
      Matrix hessian{};
      for (const HalfSpace& h : halfSpaces)
      {
        const Vector a{ { h.Normal[0], h.Normal[1], h.Normal[2], 1 } };
        const double inverse = 1 / (h.Offset - Dot(h.Normal, ball.Center) - ball.Radius);
        for (std::size_t i = 0; i < 4; ++i)
        {
          gradient[i] += a[i] * inverse;
          for (std::size_t j = 0; j < 4; ++j)
          {
            hessian[i][j] += a[i] * a[j] * inverse * inverse;
          }
        }
      }
      Vector move = gradient;
      if (!Solve(hessian, move))
      {
        return;
      }
      double decrement = 0;
      for (std::size_t i = 0; i < 4; ++i)
      {
        decrement += move[i] * gradient[i];
      }
      if (!(decrement > 1e-6) || !LineSearch(halfSpaces, mu, move, decrement, ball))
      {
        return;
      }
    }
  }

  static double Barrier(const std::vector<HalfSpace>& halfSpaces, double mu, const Ball& ball)
  {
    double sum = -ball.Radius / mu;
    for (const HalfSpace& h : halfSpaces)
    {
      const double gap = h.Offset - Dot(h.Normal, ball.Center) - ball.Radius;
      if (!(gap > 0))
      {
        return 1e300;
      }
      sum -= std::log(gap);
    }
    return sum;
  }

  static bool LineSearch(const std::vector<HalfSpace>& halfSpaces, double mu, const Vector& move,
    double decrement, Ball& ball)
  {
    const double before = Barrier(halfSpaces, mu, ball);
    for (double length = 1; length > 1e-8; length *= 0.5)
    {
      Ball next = ball;
      for (std::size_t i = 0; i < 3; ++i)
      {
        next.Center[i] -= length * move[i];
      }
      next.Radius -= length * move[3];
      if (Barrier(halfSpaces, mu, next) <= before - 0.1 * length * decrement)
      {
        ball = next;
        return true;
      }
    }
    return false;
  }

  // Gaussian elimination with pivoting; the right side becomes the solution.
  static bool Solve(Matrix& m, Vector& b)
  {
    for (std::size_t column = 0; column < 4; ++column)
    {
      std::size_t pivot = column;
      for (std::size_t row = column + 1; row < 4; ++row)
      {
        pivot = std::abs(m[row][column]) > std::abs(m[pivot][column]) ? row : pivot;
      }
      if (!(std::abs(m[pivot][column]) > 0))
      {
        return false;
      }
      std::swap(m[pivot], m[column]);
      std::swap(b[pivot], b[column]);
      for (std::size_t row = 0; row < 4; ++row)
      {
        const double factor = row == column ? 0 : m[row][column] / m[column][column];
        for (std::size_t k = column; k < 4 && factor != 0; ++k)
        {
          m[row][k] -= factor * m[column][k];
        }
        b[row] -= factor * b[column];
      }
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      b[i] /= m[i][i];
    }
    return true;
  }
};

} // namespace nephoscope

#endif
