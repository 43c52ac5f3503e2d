// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The texture of clouds: a sum of cosines whose phases are shifted to and fro (Gardner1985, as in
 * MaxCrawfisBecker1993 section 4):
 * GardnerWaves.h. The variance of the sum is 1, its mean 0.
 */
#ifndef nephoscope_GardnerTexture_h
#define nephoscope_GardnerTexture_h

#include "CoverageThreshold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

template <typename Real>
Real Dot(const Point3<Real>& a, const Point3<Real>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** In radians per unit. */
template <typename Real>
Point3<Real> Radians(const Point3<double>& turns)
{
  return { { Real(2 * gardnerPi * turns[0]), Real(2 * gardnerPi * turns[1]),
    Real(2 * gardnerPi * turns[2]) } };
}

/**
 * A pixel on the texture: how far (u, v, w) change over one standard deviation of the pixel's
 * filter, across and up.
 */
template <typename Real>
struct TextureFootprint
{
  Point3<Real> Across{ { 0, 0, 0 } };
  Point3<Real> Up{ { 0, 0, 0 } };

  /** Variance of the phase of a wave inside the footprint. */
  Real PhaseVariance(const Point3<Real>& wave) const
  {
    const Real x = Dot(wave, this->Across);
    const Real y = Dot(wave, this->Up);
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
Real GardnerTexture(const Point3<Real>& p, const GardnerWaves& waves = PaperWaves())
{
  Real sum = 0;
  for (const GardnerWave& wave : waves)
  {
    const Real shift = Real(wave.Shift) * std::sin(Dot(Radians<Real>(wave.ShiftFrequency), p));
    sum += Real(wave.Amplitude) *
      std::cos(Dot(Radians<Real>(wave.Frequency), p) + Real(2 * gardnerPi * wave.Phase) + shift);
  }
  return sum;
}

/**
 * With each term taken as a wave of the frequency that it has at p. Over footprints of a wave
 * length and more the mean differs from the exact one by some hundredths; its variance and that
 * which is lost still add up to 1.
 */
template <typename Real>
FilteredTexture<Real> FilteredGardnerTexture(const Point3<Real>& p,
  const TextureFootprint<Real>& footprint, const GardnerWaves& waves = PaperWaves())
{
  FilteredTexture<Real> result;
  for (const GardnerWave& wave : waves)
  {
    Point3<Real> local = Radians<Real>(wave.Frequency);
    const Point3<Real> across = Radians<Real>(wave.ShiftFrequency);
    const Real chi = Dot(across, p);
    const Real phase =
      Dot(local, p) + Real(2 * gardnerPi * wave.Phase) + Real(wave.Shift) * std::sin(chi);
    for (int c = 0; c < 3; ++c)
    {
      local[c] += Real(wave.Shift) * std::cos(chi) * across[c];
    }
    const Real amplitude = Real(wave.Amplitude);
    const Real kept = amplitude * std::exp(-footprint.PhaseVariance(local) / 2);
    result.Mean += kept * std::cos(phase);
    result.Lost += (amplitude * amplitude - kept * kept) / 2;
    result.Fourth += kept * kept * kept * kept;
  }
  return result;
}

/**
 * Exactly, for a Gaussian filter: cos(theta + s sin chi) is the sum over k of J_k(s) cos(theta + k
 * chi), plane waves, each of which the filter damps by exp(-(phase variance) / 2).
 */
inline FilteredTexture<double> ExactlyFilteredGardnerTexture(const Point3<double>& p,
  const TextureFootprint<double>& footprint, const GardnerWaves& waves = PaperWaves())
{
  constexpr int highest = 12;
  FilteredTexture<double> result;
  for (const GardnerWave& wave : waves)
  {
    const double amplitude = wave.Amplitude;
    const Point3<double> across = Radians<double>(wave.ShiftFrequency);
    double keptVariance = 0;
    for (int k = -highest; k <= highest; ++k)
    {
      Point3<double> partial = Radians<double>(wave.Frequency);
      for (int c = 0; c < 3; ++c)
      {
        partial[c] += k * across[c];
      }
      const double bessel = BesselJ(k, wave.Shift);
      const double damping = std::exp(-footprint.PhaseVariance(partial) / 2);
      result.Mean +=
        amplitude * bessel * damping * std::cos(Dot(partial, p) + 2 * gardnerPi * wave.Phase);
      keptVariance += bessel * bessel * damping * damping;
    }
    result.Lost += amplitude * amplitude / 2 * (1 - keptVariance);
    result.Fourth += amplitude * amplitude * amplitude * amplitude * keptVariance * keptVariance;
  }
  return result;
}

/**
 * Where a set of texture coordinates reads the texture. Set 0 reads it at p, set 1 mirrored and
 * shifted: its waves have other directions, so that the two are independent even where their
 * coordinates agree, in calm air.
 */
template <typename Real>
Point3<Real> PlaceInSet(int set, const Point3<Real>& p)
{
  return set == 0 ? p : Point3<Real>{ { p[0] + Real(0.37), Real(0.61) - p[1], p[2] + Real(0.29) } };
}

/**
 * The two sets together, before any threshold: independent textures of equal variance keep it when
 * the sum is divided by the root of the sum of squared weights. Weights >= 0, not both 0.
 */
template <typename Real>
FilteredTexture<Real> BlendTextures(const FilteredTexture<Real>& first,
  const FilteredTexture<Real>& second, Real firstWeight, Real secondWeight)
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

/** Cumulative normal distribution. */
template <typename Real>
Real NormalShare(Real x)
{
  return std::erfc(-x * Real(0.70710678118654752)) / 2;
}

/**
 * Cloudy fraction of a pixel, 0 ... 1. Its mean over the texture is the cover, at every distance
 * and for every blend. "softness" is the standard deviation of the soft edge, in units of the
 * texture.
 */
inline double CloudShare(const CoverageThresholds& thresholds,
  const FilteredTexture<double>& texture, double cover, double softness)
{
  if (cover <= 0 || cover >= 1)
  {
    return cover <= 0 ? 0 : 1;
  }
  const double threshold =
    ThresholdOfCover(thresholds, cover, softness, texture.Fourth / GardnerFourth());
  const double width = std::sqrt(std::max(texture.Lost, 0.0) + softness * softness);
  return width > 0 ? NormalShare((texture.Mean - threshold) / width)
                   : double(texture.Mean > threshold);
}

} // namespace nephoscope

#endif
