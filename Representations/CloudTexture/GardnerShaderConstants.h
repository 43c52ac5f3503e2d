// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Numbers of the headers for GardnerTexture.glsl. */
#ifndef GardnerShaderConstants_h
#define GardnerShaderConstants_h

#include "CoverageThreshold.h"
#include "GardnerTexture.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace nephoscope
{

/** Numbers that differ from term to term, as elements of an array. */
template <typename Value>
std::string listOfTerms(const Value& value)
{
  std::ostringstream result;
  result << std::scientific << std::setprecision(9);
  for (int i = 0; i < numberOfGardnerTerms; ++i)
  {
    result << (i ? ", " : "");
    value(result, i);
  }
  return result.str();
}

inline std::string gardnerConstants()
{
  const std::string waves = listOfTerms([](std::ostream& os, int i) {
    const auto wave = gardnerWave<double>(i);
    const double turn = 2 * gardnerPi;
    os << "vec3(" << wave[0] / turn << ", " << wave[1] / turn << ", " << wave[2] / turn << ")";
  });
  const std::string amplitudes =
    listOfTerms([](std::ostream& os, int i) { os << gardnerAmplitude * std::pow(gardnerRatio, i); });
  std::ostringstream result;
  result << std::scientific << std::setprecision(9);
  result << "const vec3 gardnerWaves[7] = vec3[7](" << waves << ");\n"
         << "const float gardnerAmplitudes[7] = float[7](" << amplitudes << ");\n"
         << "const float gardnerFourth = " << gardnerFourth() << ";\n"
         << "const float thresholdColumns = " << double(CoverageThresholds::columns) << ";\n"
         << "const float thresholdRows = " << double(CoverageThresholds::rows) << ";\n";
  return result.str();
}

} // namespace nephoscope

#endif
