// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How far one splat is from several that it stands for: kernels are taken as gaussians of the same
// covariance, whose products have integrals in closed form (the distance of mixtures of gaussians
// in the mean square). Plain C++17.
#ifndef nephoscope_SplatGaussian_h
#define nephoscope_SplatGaussian_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
// In space (3), or on the screen (2).
template <std::size_t dimension>
struct SplatGaussian
{
  using Vector = std::array<double, dimension>;

  Vector Place{};
  std::array<Vector, dimension> Covariance{}; // the lower triangle counts
  std::array<double, 4> Mass{}; // red, green, blue emission and extinction, integrated
};

namespace splat_gaussian
{
constexpr double twoPi = 6.283185307179586;
}

// The integral of the product of two of mass 1.
template <std::size_t dimension>
double Overlap(const SplatGaussian<dimension>& a, const SplatGaussian<dimension>& b)
{
  // By the Cholesky factor of the sum of the covariances.
  std::array<std::array<double, dimension>, dimension> l;
  typename SplatGaussian<dimension>::Vector solved;
  double volume = 1.0, square = 0.0;
  for (std::size_t i = 0; i < dimension; ++i)
  {
    double offset = a.Place[i] - b.Place[i];
    for (std::size_t j = 0; j <= i; ++j)
    {
      double sum = a.Covariance[i][j] + b.Covariance[i][j];
      for (std::size_t k = 0; k < j; ++k)
      {
        sum -= l[i][k] * l[j][k];
      }
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
    for (std::size_t k = 0; k < i; ++k)
    {
      offset -= l[i][k] * solved[k];
    }
    solved[i] = offset / l[i][i];
    square += solved[i] * solved[i];
    volume *= splat_gaussian::twoPi * l[i][i] * l[i][i];
  }
  return std::exp(-0.5 * square) / std::sqrt(volume);
}

// The integral of the square of the difference between one and the sum of some others, of the
// channel that differs most.
template <std::size_t dimension, typename Iterator>
double SquareDistance(const SplatGaussian<dimension>& one, Iterator begin, Iterator end)
{
  std::array<double, 4> sum{};
  const auto add = [&](const SplatGaussian<dimension>& a, const SplatGaussian<dimension>& b,
                     double times) {
    const double overlap = times * Overlap(a, b);
    for (std::size_t c = 0; c < 4; ++c)
    {
      sum[c] += overlap * a.Mass[c] * b.Mass[c];
    }
  };
  add(one, one, 1.0);
  for (Iterator i = begin; i != end; ++i)
  {
    add(one, *i, -2.0);
    add(*i, *i, 1.0);
    for (Iterator j = begin; j != i; ++j)
    {
      add(*i, *j, 2.0);
    }
  }
  return std::max({ 0.0, sum[0], sum[1], sum[2], sum[3] });
}
}

#endif
