// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Numbers of the headers for GardnerTexture.glsl. */
#ifndef nephoscope_GardnerShaderConstants_h
#define nephoscope_GardnerShaderConstants_h

#include "CoverageThreshold.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace nephoscope
{

/**
 * A macro that calls another one for each wave: frequencies and amplitude, frequencies of what
 * shifts the phase and phase, by how many turns it shifts. No loop over arrays: software OpenGL
 * unrolls loops in some shaders only, and an array that it indexes costs as much as the cosines.
 */
inline std::string ForEachWave(const GardnerWaves& waves)
{
  std::ostringstream result;
  result << std::scientific << std::setprecision(9) << "#define forEachWave(visit)";
  const auto vector = [&](const Point3<double>& frequency, double fourth) {
    result << "vec4(" << frequency[0] << ", " << frequency[1] << ", " << frequency[2] << ", "
           << fourth << "), ";
  };
  for (const GardnerWave& wave : waves)
  {
    result << " visit(";
    vector(wave.Frequency, wave.Amplitude);
    vector(wave.ShiftFrequency, wave.Phase);
    result << wave.Shift / (2 * gardnerPi) << ")";
  }
  result << "\n";
  return result.str();
}

inline std::string GardnerConstants(const GardnerWaves& waves)
{
  double largest = 0;
  for (const GardnerWave& wave : waves)
  {
    largest = std::max(largest, std::abs(wave.Amplitude));
  }
  std::ostringstream result;
  result << std::scientific << std::setprecision(9);
  result << ForEachWave(waves) << "const float gardnerFourth = " << GardnerFourth(waves) << ";\n"
         << "const float largestAmplitude = " << largest << ";\n"
         << "const float thresholdColumns = " << double(CoverageThresholds::columns) << ";\n"
         << "const float thresholdRows = " << double(CoverageThresholds::rows) << ";\n";
  return result.str();
}

} // namespace nephoscope

#endif
