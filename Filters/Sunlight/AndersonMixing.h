// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Anderson's acceleration of a fixed-point iteration x = f(x) (WalkerNi2011). Plain C++17.
#ifndef nephoscope_AndersonMixing_h
#define nephoscope_AndersonMixing_h

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace nephoscope
{
class AndersonMixing
{
public:
  explicit AndersonMixing(std::size_t depth)
    : Depth(depth)
  {
  }

  /** `x` becomes the next one to try; `image` is f(x). */
  void Mix(std::vector<float>& x, const std::vector<float>& image)
  {
    std::vector<float> residual(x.size());
    std::transform(image.begin(), image.end(), x.begin(), residual.begin(),
      [](float a, float b) { return a - b; });
    if (!this->LastImage.empty())
    {
      this->Residuals.push_back(Difference(residual, this->LastResidual));
      this->Images.push_back(Difference(image, this->LastImage));
      if (this->Images.size() > this->Depth)
      {
        this->Residuals.pop_front();
        this->Images.pop_front();
      }
    }
    x = image;
    const std::vector<double> weights = this->Weights(residual);
    for (std::size_t k = 0; k < weights.size(); ++k)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        x[i] -= static_cast<float>(weights[k]) * this->Images[k][i];
      }
    }
    this->LastImage = image;
    this->LastResidual.swap(residual);
  }

private:
  static std::vector<float> Difference(const std::vector<float>& a, const std::vector<float>& b)
  {
    std::vector<float> c(a.size());
    std::transform(
      a.begin(), a.end(), b.begin(), c.begin(), [](float p, float q) { return p - q; });
    return c;
  }
  static double Dot(const std::vector<float>& a, const std::vector<float>& b)
  {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      sum += double(a[i]) * b[i];
    }
    return sum;
  }

  // Least squares by the normal equations, which a small part of their diagonal keeps regular.
  std::vector<double> Weights(const std::vector<float>& residual) const
  {
    const std::size_t n = this->Residuals.size();
    std::vector<double> a(n * n), b(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      b[i] = Dot(this->Residuals[i], residual);
      for (std::size_t j = 0; j <= i; ++j)
      {
        a[i * n + j] = a[j * n + i] = Dot(this->Residuals[i], this->Residuals[j]);
      }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      a[i * n + i] = a[i * n + i] * (1 + 1e-8) + 1e-30;
    }
    return Solve(std::move(a), std::move(b));
  }

  static std::vector<double> Solve(std::vector<double> a, std::vector<double> b)
  {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) // positive definite: no pivots
    {
      for (std::size_t i = k + 1; i < n; ++i)
      {
        const double factor = a[i * n + k] / a[k * n + k];
        for (std::size_t j = k; j < n; ++j)
        {
          a[i * n + j] -= factor * a[k * n + j];
        }
        b[i] -= factor * b[k];
      }
    }
    for (std::size_t k = n; k-- > 0;)
    {
      for (std::size_t j = k + 1; j < n; ++j)
      {
        b[k] -= a[k * n + j] * b[j];
      }
      b[k] /= a[k * n + k];
    }
    return b;
  }

  std::size_t Depth;
  std::deque<std::vector<float>> Residuals, Images;
  std::vector<float> LastImage, LastResidual;
};
}

#endif
