// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Between which depths a pixel is seen.
// Constant: useDepthRanges.
uniform sampler2D depthRanges; // where VTK peels surfaces: near and far depth of two ranges, empty where near >= far
uniform int rangeNumber;       // the one to draw

vec2 visibleDepths()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (useDepthRanges)
  {
    vec4 ranges = texelFetch(depthRanges, pixel, 0);
    return rangeNumber == 0 ? ranges.xy : ranges.zw;
  }
  else
  {
    return vec2(0.0, texelFetch(opaqueDepth, pixel, 0).r);
  }
}
