//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a volume adds to the sums of slices.
//   in:  slices: its light in each, premultiplied by its opacity a
//   out: its optical depth -log(1 - a), and its colour times that, to be added
uniform sampler2D slices[SLICES];
const float leastTransparency = 1.0e-7;

vec4 sumsOf(vec4 light)
{
  float depth = -log(max(1.0 - light.a, leastTransparency));
  return vec4(light.a > 0.0 ? light.rgb * (depth / light.a) : light.rgb, depth);
}

void main()
{
  vec4 sums[SLICES];
#define ADD_SUM(i) sums[i] = sumsOf(texelFetch(slices[i], ivec2(gl_FragCoord.xy), 0));
  EACH_SLICE(ADD_SUM)
  PUT_SLICES(sums)
}
