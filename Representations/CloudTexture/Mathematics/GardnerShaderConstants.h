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
 * Constants, not uniforms: software OpenGL fetches those anew for every pixel, at the cost of a
 * texture.
 */
template <typename Value>
std::string ArrayOfWaves(
  const std::string& type, const std::string& name, const GardnerWaves& waves, const Value& value)
{
  std::ostringstream result;
  result << std::scientific << std::setprecision(9);
  const std::string array = type + "[" + std::to_string(waves.size()) + "]";
  result << "const " << type << " " << name << "[" << waves.size() << "] = " << array << "(";
  for (std::size_t i = 0; i < waves.size(); ++i)
  {
    result << (i ? ", " : "");
    value(result, waves[i]);
  }
  result << ");\n";
  return result.str();
}

inline std::string GardnerConstants(const GardnerWaves& waves)
{
  const auto vector = [](std::ostream& os, const Point3<double>& frequency, double fourth) {
    os << "vec4(" << frequency[0] << ", " << frequency[1] << ", " << frequency[2] << ", " << fourth
       << ")";
  };
  double largest = 0;
  for (const GardnerWave& wave : waves)
  {
    largest = std::max(largest, std::abs(wave.Amplitude));
  }
  std::ostringstream result;
  result << std::scientific << std::setprecision(9);
  result << "const int numberOfWaves = " << waves.size() << ";\n"
         << ArrayOfWaves("vec4", "gardnerWaves", waves,
              [&](std::ostream& os, const GardnerWave& wave) {
                vector(os, wave.Frequency, wave.Amplitude);
              })
         << ArrayOfWaves("vec4", "gardnerShifts", waves,
              [&](std::ostream& os, const GardnerWave& wave) {
                vector(os, wave.ShiftFrequency, wave.Phase);
              })
         << ArrayOfWaves("float", "gardnerTurns", waves,
              [](std::ostream& os, const GardnerWave& wave) { os << wave.Shift / (2 * gardnerPi); })
         << "const float gardnerFourth = " << GardnerFourth(waves) << ";\n"
         << "const float largestAmplitude = " << largest << ";\n"
         << "const float thresholdColumns = " << double(CoverageThresholds::columns) << ";\n"
         << "const float thresholdRows = " << double(CoverageThresholds::rows) << ";\n";
  return result.str();
}

} // namespace nephoscope

#endif
