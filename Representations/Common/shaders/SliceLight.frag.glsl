//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of a pair of slices in which media are mixed evenly: (1 - exp(-d)) of their mean colour, where d is their optical depth.
//   in:  sums of optical depths, and of colours times these (see SliceSums)
//   out: the light of the first slice over the second; with ofPeel that of each. To be laid below what is there
uniform sampler2D firstSums;
uniform sampler2D secondSums;
uniform bool ofPeel;

vec4 light(vec4 sums)
{
  float opacity = 1.0 - exp(-sums.a);
  return vec4(sums.rgb * (sums.a > 1.0e-4 ? opacity / sums.a : 1.0 - 0.5 * sums.a), opacity);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 first = light(texelFetch(firstSums, pixel, 0));
  vec4 second = light(texelFetch(secondSums, pixel, 0));
  gl_FragData[0] = ofPeel ? first : first + (1.0 - first.a) * second;
  gl_FragData[1] = ofPeel ? second : vec4(0.0);
}
