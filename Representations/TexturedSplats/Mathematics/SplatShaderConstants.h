// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The numbers of SplatKernel.h and VectorTexture.h that their shaders need, as definitions in front
// of SplatFootprint.glsl and VectorTexture.glsl. Plain C++17.
#ifndef nephoscope_SplatShaderConstants_h
#define nephoscope_SplatShaderConstants_h

#include "SplatKernel.h"
#include "VectorTexture.h"

#include <cmath>
#include <iterator>
#include <sstream>
#include <string>

namespace nephoscope
{
class ShaderConstants
{
public:
  ShaderConstants() { this->Text.precision(9); }

  void Add(const std::string& name, double value)
  {
    this->Text << std::showpoint << "#define " << name << " (" << value << ")\n";
  }
  template <typename List>
  void AddList(const std::string& name, const List& values)
  {
    for (std::size_t i = 0; i < std::size(values); ++i)
    {
      this->Add(name + std::to_string(i), values[i]);
    }
  }
  std::string Get() const { return this->Text.str(); }

private:
  std::ostringstream Text;
};

inline std::string KernelConstants()
{
  ShaderConstants constants;
  constants.AddList("CUBIC", cubic_kernel::footprintCoefficients);
  constants.AddList("SHARE", cubic_kernel::shareCoefficients);
  constants.Add("CUBIC_RADIUS", cubic_kernel::radius);
  constants.Add("CUBIC_INNER_RADIUS", cubic_kernel::innerRadius);
  constants.AddList("CUBIC_INNER", cubic_kernel::inner);
  constants.AddList("CUBIC_OUTER", cubic_kernel::outerPowers);
  constants.Add("QUADRATIC_INNER_RADIUS", quadratic_kernel::innerRadius);
  constants.Add("QUADRATIC_INNER", quadratic_kernel::inner);
  constants.Add("QUADRATIC_OUTER", quadratic_kernel::outer);
  constants.Add("GAUSSIAN_PEAK", gaussian_kernel::Footprint(0.0));
  constants.Add("GAUSSIAN_DECAY",
    0.5 * gaussian_kernel::radius * gaussian_kernel::radius / gaussian_kernel::variance);
  constants.Add("GAUSSIAN_DEPTH", std::sqrt(2.0 * gaussian_kernel::variance));
  return constants.Get();
}

// `spacing` is the distance from row to row of streaks, in units of the vectors.
inline std::string VectorTextureConstants(double spacing)
{
  ShaderConstants constants;
  constants.Add("STREAK_SPACING", spacing);
  constants.Add("STREAK_GOLDEN", streaks::golden);
  constants.Add("STREAK_TAIL_END", streaks::tailEnd);
  constants.Add("STREAK_NOSE", streaks::nose);
  constants.Add("STREAK_ROUND_DOT", streaks::roundDot);
  constants.Add("STREAK_COARSE", streaks::coarse);
  constants.Add("STREAK_FINE", streaks::fine);
  constants.Add("STREAK_STEEP", streaks::steep);
  constants.Add("STREAK_FLAT", streaks::flat);
  constants.Add("SEGMENT_FILTER", LineSegment().FilterWidth);
  constants.Add("SEGMENT_FADE", segmentFade);
  return constants.Get();
}
}

#endif
