//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of slices in which media are mixed evenly: (1 - exp(-d)) of their mean colour, where d is their optical depth.
//   in:  slices: sums of optical depths, and of colours times these (see SliceSums)
//   out: the light of all slices, each over the next. To be laid below what is there
uniform sampler2D slices[SLICES];

vec4 lightOf(vec4 sum)
{
  float opacity = 1.0 - exp(-sum.a);
  return vec4(sum.rgb * (sum.a > 1.0e-4 ? opacity / sum.a : 1.0 - 0.5 * sum.a), opacity);
}

void main()
{
  vec4 light = vec4(0.0);
#define ADD_LIGHT(i) light += (1.0 - light.a) * lightOf(texelFetch(slices[i], ivec2(gl_FragCoord.xy), 0));
  EACH_SLICE(ADD_LIGHT)
  gl_FragData[0] = light;
}
