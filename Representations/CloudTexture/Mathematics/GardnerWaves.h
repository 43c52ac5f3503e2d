// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The waves of the cloud texture. Each is
 *   a cos(2 pi (b u + c v + d w + p) + s sin(2 pi (e u + g v + h w))),
 * a wave of frequencies (b, c, d) per unit of the texture, whose phase p shifts to and fro along
 * another direction (e, g, h).
 *
 * With whole numbers b and e the texture has period 1 in u.
 */
#ifndef nephoscope_GardnerWaves_h
#define nephoscope_GardnerWaves_h

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace nephoscope
{

constexpr double gardnerPi = 3.14159265358979323846;
constexpr int mostGardnerWaves = 16;

template <typename Real>
using Point3 = std::array<Real, 3>;

struct GardnerWave
{
  double Amplitude = 0;
  Point3<double> Frequency{ { 0, 0, 0 } };
  double Shift = 0; ///< radians
  Point3<double> ShiftFrequency{ { 0, 0, 0 } };
  double Phase = 0; ///< turns
};

using GardnerWaves = std::vector<GardnerWave>;

/** Waves of the same proportions, and variance 1. Empty where there is no wave. */
inline GardnerWaves Normalized(GardnerWaves waves)
{
  double variance = 0;
  for (const GardnerWave& wave : waves)
  {
    variance += wave.Amplitude * wave.Amplitude / 2;
  }
  if (!(variance > 0) || !std::isfinite(variance))
  {
    return {};
  }
  for (GardnerWave& wave : waves)
  {
    wave.Amplitude /= std::sqrt(variance);
  }
  return waves;
}

/** b, c and d of each wave; amplitudes fall by 0.7, phases shift by 2. */
inline GardnerWaves WavesOfPaper(const std::vector<Point3<double>>& frequencies)
{
  GardnerWaves waves;
  double amplitude = 1;
  for (const Point3<double>& frequency : frequencies)
  {
    GardnerWave wave;
    wave.Amplitude = amplitude;
    wave.Frequency = frequency;
    wave.Shift = 2;
    waves.push_back(wave);
    amplitude *= 0.7;
  }
  return Normalized(waves);
}

/**
 * All directions, and frequencies and amplitudes from 2.4 and 1 to 66 and 0.05, chosen among 4000
 * sets for slices whose spectrum is the same all round. No wave may dominate; otherwise clouds are
 * stripes. Periods: 10; on longitudes 1 in u, where frequencies along u are rounded.
 */
inline GardnerWaves CloudWaves()
{
  constexpr double ratio = 0.7633;
  constexpr double values[][7] = { { -2, 0.8, 1.1, 0, -0.7, 0.6, 0.12 },
    { 0.6, -2.3, 2.2, 1, 0.9, 0.7, 0.7 }, { 0.4, -1.1, 4.3, 1, 1.1, 0.2, 0.36 },
    { 4.7, -3.1, 2, -1.2, -1.6, 0.4, 0.36 }, { -2.1, 1.2, 7.7, 1.9, -1.8, 0.8, 0.9 },
    { 1.3, -8, -7.4, 4.7, 0.2, 0.6, 0.69 }, { 11.9, -8.3, -2.9, 4.2, 5.2, 2.2, 0.47 },
    { -12.9, 11.4, -10.1, -4.7, -2.8, 2.8, 0.19 }, { -14.7, -17.8, -13.9, -11.9, 10.1, -0.4, 0.6 },
    { 34.6, 4.7, -10.3, 4.7, -3, 14.3, 0.78 }, { 16, -35.2, 30.3, 15.7, 6.6, -0.6, 0.86 },
    { -44.8, 1.9, -49, -22.4, 13, 21, 0.88 } };
  GardnerWaves waves;
  double amplitude = 1;
  for (const auto& v : values)
  {
    waves.push_back({ amplitude, { { v[0], v[1], v[2] } }, 3, { { v[3], v[4], v[5] } }, v[6] });
    amplitude *= ratio;
  }
  return Normalized(waves);
}

/**
 * Phases shift along the direction across the wave, (c, -b) / 2, as the text of
 * MaxCrawfisBecker1993 asks. Periods: 1 in u, 2 in v, 10 in w.
 */
inline GardnerWaves PaperWaves()
{
  GardnerWaves waves = WavesOfPaper({ { { 3, 2, 2.1 } }, { { -5, 4, -3.3 } }, { { 8, -6, 5.2 } },
    { { 11, 12, -7.9 } }, { { -19, 16, 11.3 } }, { { 27, -26, 15.1 } }, { { 41, 42, -22.7 } } });
  for (GardnerWave& wave : waves)
  {
    wave.ShiftFrequency = { { wave.Frequency[1] / 2, -wave.Frequency[0] / 2, 0 } };
  }
  return waves;
}

/**
 * As printed in MaxCrawfisBecker1993: the shift is 2 sin((b u - a v) / 2), with the amplitude a in
 * the place of a frequency (in radians). Every b is even, since half of it must be whole.
 */
inline GardnerWaves PrintedWaves()
{
  GardnerWaves waves = WavesOfPaper({ { { 4, 2, 2.1 } }, { { -6, 4, -3.3 } }, { { 8, -6, 5.2 } },
    { { 12, 12, -7.9 } }, { { -20, 16, 11.3 } }, { { 28, -26, 15.1 } }, { { 42, 42, -22.7 } } });
  for (GardnerWave& wave : waves)
  {
    wave.ShiftFrequency = { { wave.Frequency[0] / 2, -wave.Amplitude / (4 * gardnerPi), 0 } };
  }
  return waves;
}

/**
 * As in Gardner1985: along u and along v, frequencies doubled and amplitudes times 0.707 from
 * octave to octave; the phase shifts by pi / 2, with half the frequency of its wave, along the
 * other axes. His sums along u and v are multiplied, these are added.
 */
inline GardnerWaves GardnersWaves()
{
  constexpr int octaves = 5;
  GardnerWaves waves;
  double amplitude = 1;
  double frequency = 4;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.707, frequency *= 2)
  {
    GardnerWave alongU, alongV;
    alongU.Amplitude = alongV.Amplitude = amplitude;
    alongU.Shift = alongV.Shift = gardnerPi / 2;
    alongU.Frequency = { { frequency, 0, 0 } };
    alongV.Frequency = { { 0, frequency, 0 } };
    alongU.ShiftFrequency = { { 0, frequency / 2, frequency / 2 } };
    alongV.ShiftFrequency = { { frequency / 2, 0, frequency / 2 } };
    alongV.Phase =
      0.25; // else both have parts in common, which do not add up as independent waves do
    waves.push_back(alongU);
    waves.push_back(alongV);
  }
  return Normalized(waves);
}

/** By the number that vtkCloudTextureMapper has for them. */
inline GardnerWaves PresetWaves(int preset)
{
  return preset == 1 ? PaperWaves()
    : preset == 2    ? PrintedWaves()
    : preset == 3    ? GardnersWaves()
                     : CloudWaves();
}

/** Frequencies along u become whole numbers, because the texture wraps around in longitude. */
inline void CloseOnLongitudes(GardnerWaves& waves)
{
  for (GardnerWave& wave : waves)
  {
    wave.Frequency[0] = std::round(wave.Frequency[0]);
    wave.ShiftFrequency[0] = std::round(wave.ShiftFrequency[0]);
  }
}

/** Amplitude, frequencies, shift, its frequencies, phase. */
inline void ListWave(const GardnerWaves& waves, int i, double values[9])
{
  const GardnerWave none;
  const GardnerWave& wave =
    i >= 0 && i < static_cast<int>(waves.size()) ? waves[static_cast<std::size_t>(i)] : none;
  values[0] = wave.Amplitude;
  std::copy(wave.Frequency.begin(), wave.Frequency.end(), values + 1);
  values[4] = wave.Shift;
  std::copy(wave.ShiftFrequency.begin(), wave.ShiftFrequency.end(), values + 5);
  values[8] = wave.Phase;
}

/** Empty, or why they are no texture. */
inline std::string DescribeUnusable(const GardnerWaves& waves)
{
  const std::string remedy = " The waves of Clouds are drawn instead.";
  for (std::size_t i = 0; i < waves.size(); ++i)
  {
    double values[9];
    ListWave(waves, static_cast<int>(i), values);
    const std::string wave = "Custom wave " + std::to_string(i);
    if (!std::all_of(values, values + 9, [](double x) { return std::abs(x) <= 1e6; }))
    {
      return wave + " has numbers that are not finite, or larger than 1e6: change them." + remedy;
    }
    if (values[0] != 0 && values[1] == 0 && values[2] == 0 && values[3] == 0)
    {
      return wave + " has no frequency: set b, c or d." + remedy;
    }
  }
  return Normalized(waves).empty()
    ? "Custom waves need at least one amplitude that is not 0." + remedy
    : std::string();
}

} // namespace nephoscope

#endif
