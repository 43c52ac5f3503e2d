// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Converts the requested cover to the threshold above which there is cloud.
 *
 * What is compared with the threshold is a sum of cosines of independent phases (the texture, or
 * two of them blended) and of Gaussian parts (what the pixel's filter has taken away, the soft
 * edge). Its distribution follows from its characteristic function, a product of Bessel functions
 * J_0(a_i t) and a Gaussian, by Gil-Pelaez:
 *   P(x > T) = 1/2 - 1/pi int_0^inf sin(t T) phi(t) / t dt.
 * A sum of many cosines is nearly Gaussian, one texture alone less so (15 % cover: 1.0895 against
 * 1.036), two blended are in between: the sum of fourth powers of the amplitudes, over that of a
 * single texture, tells by how much. So one table of thresholds by cover and by this ratio serves
 * all blends and all distances.
 */
#ifndef nephoscope_CoverageThreshold_h
#define nephoscope_CoverageThreshold_h

#include "GardnerWaves.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephoscope
{

/** Bessel function J_k(x), whole k, from its integral; to rounding for |x| < 60. */
inline double BesselJ(int k, double x)
{
  constexpr int steps = 128;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
  {
    const double theta = 2 * gardnerPi * i / steps;
    sum += std::cos(k * theta - x * std::sin(theta));
  }
  return sum / steps;
}

/** The fourth powers of all amplitudes, unfiltered. */
inline double GardnerFourth(const GardnerWaves& waves = PaperWaves())
{
  double sum = 0;
  for (const GardnerWave& wave : waves)
  {
    sum += std::pow(wave.Amplitude, 4);
  }
  return sum;
}

/**
 * Distribution of a blend that has unit variance; "Fourth" is its ratio of fourth powers, 0
 * (Gaussian) to 1 (one texture).
 */
class BlendDistribution
{
public:
  explicit BlendDistribution(double fourth, const GardnerWaves& waves = PaperWaves())
  {
    // From 1/2 on: two textures with weights whose fourth powers add up to it. Below: two in equal
    // parts, and a Gaussian.
    const double split = fourth >= 0.5 ? std::sqrt(2 * std::min(1.0, fourth) - 1) : 0;
    const double scale = fourth >= 0.5 ? 1 : std::pow(std::max(0.0, 2 * fourth), 0.25);
    const double w1 = scale * std::sqrt((1 + split) / 2);
    const double w2 = scale * std::sqrt((1 - split) / 2);
    const double rest = 1 - scale * scale;
    this->Terms.resize(steps);
    for (int k = 0; k < steps; ++k)
    {
      const double t = (k + 0.5) * step;
      double phi = std::exp(-rest * t * t / 2);
      for (const GardnerWave& wave : waves)
      {
        phi *= BesselJ(0, w1 * wave.Amplitude * t) * BesselJ(0, w2 * wave.Amplitude * t);
      }
      this->Terms[k] = phi * step / (gardnerPi * t);
    }
  }

  /** Share above the threshold. */
  double Above(double threshold) const
  {
    double sum = 0.5;
    for (int k = 0; k < steps; ++k)
    {
      sum -= std::sin((k + 0.5) * step * threshold) * this->Terms[k];
    }
    return std::min(1.0, std::max(0.0, sum));
  }

private:
  // Midpoints: the sum repeats itself with a period of 4 pi / step in the threshold, far beyond the
  // largest value of 3.1.
  static constexpr double step = 0.2;
  static constexpr int steps = 250;
  std::vector<double> Terms;
};

/**
 * Thresholds at unit variance by cover (columns, 0 to 1) and ratio of fourth powers (rows, 0 to 1).
 */
class CoverageThresholds
{
public:
  static constexpr int columns = 257;
  static constexpr int rows = 9;
  static constexpr double farthest = 4.0; ///< threshold of cover 0, beyond all values

  explicit CoverageThresholds(const GardnerWaves& waves = PaperWaves())
  {
    this->Values.reserve(columns * rows);
    for (int row = 0; row < rows; ++row)
    {
      this->AppendRow(BlendDistribution(row / double(rows - 1), waves));
    }
  }

  /** Linear between the entries, as textures are read. */
  double Find(double cover, double fourth) const
  {
    const double x = std::min(1.0, std::max(0.0, cover)) * (columns - 1);
    const double y = std::min(1.0, std::max(0.0, fourth)) * (rows - 1);
    const int i = std::min(columns - 2, static_cast<int>(x));
    const int j = std::min(rows - 2, static_cast<int>(y));
    const auto along = [&](int row) {
      const float* v = &this->Values[static_cast<std::size_t>(row * columns + i)];
      return v[0] + (x - i) * (v[1] - v[0]);
    };
    return along(j) + (y - j) * (along(j + 1) - along(j));
  }

  const std::vector<float>& GetValues() const { return this->Values; }

private:
  // The distribution is symmetric: thresholds of covers above one half are those below, negative.
  void AppendRow(const BlendDistribution& distribution)
  {
    constexpr int samples = 801;
    std::vector<double> above(samples);
    for (int k = 0; k < samples; ++k)
    {
      above[static_cast<std::size_t>(k)] = distribution.Above(farthest * k / (samples - 1));
    }
    above[0] = 0.5;
    std::vector<float> row(columns);
    int k = samples - 1;
    for (int i = 0; i <= columns / 2; ++i) // cover rises, the threshold falls
    {
      const double cover = i / double(columns - 1);
      while (k > 1 && above[static_cast<std::size_t>(k - 1)] < cover)
      {
        --k;
      }
      const double low = above[static_cast<std::size_t>(k)];
      const double high = above[static_cast<std::size_t>(k - 1)];
      const double t =
        high > low ? std::min(1.0, std::max(0.0, (cover - low) / (high - low))) : 0.0;
      const float threshold = i == 0 ? float(farthest) : float(farthest * (k - t) / (samples - 1));
      row[static_cast<std::size_t>(i)] = threshold;
      row[static_cast<std::size_t>(columns - 1 - i)] = -threshold;
    }
    this->Values.insert(this->Values.end(), row.begin(), row.end());
  }

  std::vector<float> Values;
};

/**
 * Threshold above which the share "cover" of a texture lies, with soft edges. "fourth": sum of the
 * fourth powers of its amplitudes, over that of all waves.
 */
inline double ThresholdOfCover(
  const CoverageThresholds& thresholds, double cover, double softness, double fourth = 1)
{
  const double variance = 1 + softness * softness;
  return std::sqrt(variance) * thresholds.Find(cover, fourth / (variance * variance));
}

/** Its inverse for one set of waves: the fraction of the texture above a threshold. */
inline double CoverOfThreshold(const GardnerWaves& waves, double threshold, double softness)
{
  const double variance = 1 + softness * softness;
  const double t = threshold / std::sqrt(variance);
  return std::abs(t) >= CoverageThresholds::farthest
    ? double(t < 0)
    : BlendDistribution(1 / (variance * variance), waves).Above(t);
}

} // namespace nephoscope

#endif
