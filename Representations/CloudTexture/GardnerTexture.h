// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The texture of clouds: a sum of cosines whose phases are modulated across their direction (Gardner1985, as in MaxCrawfisBecker1993
 * section 4),
 *   f(u, v, w) = sum of a_i cos(b_i u + c_i v + d_i w + 2 sin(chi_i)),   chi_i = (c_i u - b_i v) / 2.
 * The printed phase, 2 sin((b_i u - a_i v) / 2), has an amplitude in the place of a frequency; this one has half the frequency of its
 * term and a direction at right angles to it, as the text asks. With b_i = 2 pi m_i and c_i = 4 pi n_i, m and n whole
 * numbers, f has period 1 in u and 2 in v. The variance of f is 1, its mean 0.
 *
 */
#ifndef GardnerTexture_h
#define GardnerTexture_h

#include <array>
#include <cmath>

namespace nephoscope
{

constexpr int numberOfGardnerTerms = 7;
constexpr double gardnerPi = 3.14159265358979323846;
/** Amplitude of the first term, so that the sum of a_i^2 / 2 is 1; each term has gardnerRatio times the one before. */
constexpr double gardnerAmplitude = 1.013393;
constexpr double gardnerRatio = 0.7;

/** m, n and d / 2 pi of each term. */
constexpr double gardnerTerms[numberOfGardnerTerms][3] = { { 3, 1, 2.1 }, { -5, 2, -3.3 }, { 8, -3, 5.2 },
  { 11, 6, -7.9 }, { -19, 8, 11.3 }, { 27, -13, 15.1 }, { 41, 21, -22.7 } };

template <typename Real>
using Point3 = std::array<Real, 3>;

template <typename Real>
Real dot(const Point3<Real>& a, const Point3<Real>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** b, c, d of term i. */
template <typename Real>
Point3<Real> gardnerWave(int i)
{
  return { { Real(2 * gardnerPi * gardnerTerms[i][0]), Real(4 * gardnerPi * gardnerTerms[i][1]),
    Real(2 * gardnerPi * gardnerTerms[i][2]) } };
}

/** A pixel on the texture: how far (u, v, w) change over one standard deviation of the pixel's filter, across and up. */
template <typename Real>
struct TextureFootprint
{
  Point3<Real> Across{ { 0, 0, 0 } };
  Point3<Real> Up{ { 0, 0, 0 } };

  /** Variance of the phase of a wave inside the footprint. */
  Real PhaseVariance(const Point3<Real>& wave) const
  {
    const Real x = dot(wave, this->Across);
    const Real y = dot(wave, this->Up);
    return x * x + y * y;
  }
};

/** The texture as seen through a footprint. */
template <typename Real>
struct FilteredTexture
{
  Real Mean = 0;   ///< of f
  Real Lost = 0;   ///< variance of f around the mean, 0 ... 1
  Real Fourth = 0; ///< sum of the fourth powers of the amplitudes that are left
};

/** Without a filter. */
template <typename Real>
Real gardnerTexture(const Point3<Real>& p)
{
  Real sum = 0;
  Real amplitude = Real(gardnerAmplitude);
  for (int i = 0; i < numberOfGardnerTerms; ++i, amplitude *= Real(gardnerRatio))
  {
    const Point3<Real> wave = gardnerWave<Real>(i);
    const Real modulation = 2 * std::sin((wave[1] * p[0] - wave[0] * p[1]) / 2);
    sum += amplitude * std::cos(dot(wave, p) + modulation);
  }
  return sum;
}

/**
 * With each term taken as a wave of the frequency that it has at p. Over footprints of a wave length and more the
 * mean differs from the exact one by some hundredths; its variance and that which is lost still add up to 1.
 */
template <typename Real>
FilteredTexture<Real> filteredGardnerTexture(const Point3<Real>& p, const TextureFootprint<Real>& footprint)
{
  FilteredTexture<Real> result;
  Real amplitude = Real(gardnerAmplitude);
  for (int i = 0; i < numberOfGardnerTerms; ++i, amplitude *= Real(gardnerRatio))
  {
    const Point3<Real> wave = gardnerWave<Real>(i);
    const Real chi = (wave[1] * p[0] - wave[0] * p[1]) / 2;
    const Real slope = std::cos(chi);
    const Point3<Real> local{ { wave[0] + wave[1] * slope, wave[1] - wave[0] * slope, wave[2] } };
    const Real kept = amplitude * std::exp(-footprint.PhaseVariance(local) / 2);
    result.Mean += kept * std::cos(dot(wave, p) + 2 * std::sin(chi));
    result.Lost += (amplitude * amplitude - kept * kept) / 2;
    result.Fourth += kept * kept * kept * kept;
  }
  return result;
}

/** Bessel function J_k(x), whole k, from its integral; to rounding for |x| < 60. */
inline double besselJ(int k, double x)
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

/**
 * Exactly, for a Gaussian filter: cos(theta + 2 sin chi) is the sum over k of J_k(2) cos(theta + k chi), plane waves, each of which
 * the filter damps by exp(-(phase variance) / 2).
 */
inline FilteredTexture<double> exactlyFilteredGardnerTexture(
  const Point3<double>& p, const TextureFootprint<double>& footprint)
{
  constexpr int highest = 12;
  FilteredTexture<double> result;
  double amplitude = gardnerAmplitude;
  for (int i = 0; i < numberOfGardnerTerms; ++i, amplitude *= gardnerRatio)
  {
    const Point3<double> wave = gardnerWave<double>(i);
    double keptVariance = 0;
    for (int k = -highest; k <= highest; ++k)
    {
      const Point3<double> partial{ { wave[0] + k * wave[1] / 2, wave[1] - k * wave[0] / 2, wave[2] } };
      const double bessel = besselJ(k, 2);
      const double damping = std::exp(-footprint.PhaseVariance(partial) / 2);
      result.Mean += amplitude * bessel * damping * std::cos(dot(partial, p));
      keptVariance += bessel * bessel * damping * damping;
    }
    result.Lost += amplitude * amplitude / 2 * (1 - keptVariance);
    result.Fourth += amplitude * amplitude * amplitude * amplitude * keptVariance * keptVariance;
  }
  return result;
}

/** The fourth powers of all amplitudes, unfiltered. */
constexpr double gardnerFourth()
{
  double sum = 0;
  double amplitude = gardnerAmplitude;
  for (int i = 0; i < numberOfGardnerTerms; ++i, amplitude *= gardnerRatio)
  {
    sum += amplitude * amplitude * amplitude * amplitude;
  }
  return sum;
}

/**
 * Where a set of texture coordinates reads the texture. Set 0 reads it at p, set 1 mirrored and shifted: its waves have other
 * directions, so that the two are independent even where their coordinates agree, in calm air.
 */
template <typename Real>
Point3<Real> placeInSet(int set, const Point3<Real>& p)
{
  return set == 0 ? p : Point3<Real>{ { p[0] + Real(0.37), Real(0.61) - p[1], p[2] + Real(0.29) } };
}

/**
 * The two sets together, before any threshold: independent textures of equal variance keep it when the sum is divided by the root of the
 * sum of squared weights. Weights >= 0, not both 0.
 */
template <typename Real>
FilteredTexture<Real> blendTextures(
  const FilteredTexture<Real>& first, const FilteredTexture<Real>& second, Real firstWeight, Real secondWeight)
{
  const Real norm = std::sqrt(firstWeight * firstWeight + secondWeight * secondWeight);
  const Real w1 = firstWeight / norm;
  const Real w2 = secondWeight / norm;
  FilteredTexture<Real> result;
  result.Mean = w1 * first.Mean + w2 * second.Mean;
  result.Lost = w1 * w1 * first.Lost + w2 * w2 * second.Lost;
  result.Fourth = w1 * w1 * w1 * w1 * first.Fourth + w2 * w2 * w2 * w2 * second.Fourth;
  return result;
}

} // namespace nephoscope

#endif
