// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Numbers of the headers for GardnerTexture.glsl. */
#ifndef GardnerShaderConstants_h
#define GardnerShaderConstants_h

#include "CoverageThreshold.h"
#include "GardnerTexture.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace nephoscope
{

inline std::string gardnerConstants()
{
  return "const int mostWaves = " + std::to_string(mostGardnerWaves) + ";\n" +
    "const float thresholdColumns = " + std::to_string(CoverageThresholds::columns) + ".0;\n" +
    "const float thresholdRows = " + std::to_string(CoverageThresholds::rows) + ".0;\n";
}

inline void setGardnerUniforms(vtkShaderProgram* program, const GardnerWaves& given)
{
  std::array<float[4], mostGardnerWaves> waves{}, shifts{};
  std::array<float, mostGardnerWaves> turns{};
  const std::size_t count = std::min<std::size_t>(given.size(), mostGardnerWaves);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const GardnerWave& wave = given[i];
    std::copy(wave.Frequency.begin(), wave.Frequency.end(), waves[i]);
    std::copy(wave.ShiftFrequency.begin(), wave.ShiftFrequency.end(), shifts[i]);
    waves[i][3] = static_cast<float>(wave.Amplitude);
    shifts[i][3] = static_cast<float>(wave.Phase);
    turns[i] = static_cast<float>(wave.Shift / (2 * gardnerPi));
    largest = std::max(largest, std::abs(wave.Amplitude));
  }
  program->SetUniformi("numberOfWaves", static_cast<int>(count));
  program->SetUniform4fv("gardnerWaves", mostGardnerWaves, waves.data());
  program->SetUniform4fv("gardnerShifts", mostGardnerWaves, shifts.data());
  program->SetUniform1fv("gardnerTurns", mostGardnerWaves, turns.data());
  program->SetUniformf("gardnerFourth", static_cast<float>(gardnerFourth(given)));
  program->SetUniformf("largestAmplitude", static_cast<float>(largest));
}

} // namespace nephoscope

#endif
