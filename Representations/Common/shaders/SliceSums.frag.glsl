//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a volume adds to the sums of a pair of slices.
//   in:  its light in each, premultiplied by its opacity a
//   out: its optical depth -log(1 - a), and its colour times that, to be added
uniform sampler2D firstLight;
uniform sampler2D secondLight;
const float leastTransparency = 1.0e-7;

vec4 sums(vec4 light)
{
  float depth = -log(max(1.0 - light.a, leastTransparency));
  return vec4(light.a > 0.0 ? light.rgb * (depth / light.a) : light.rgb, depth);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  gl_FragData[0] = sums(texelFetch(firstLight, pixel, 0));
  gl_FragData[1] = sums(texelFetch(secondLight, pixel, 0));
}
