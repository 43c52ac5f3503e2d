//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The depths that the ranges of a square of pixels span together, so that what lies outside can be skipped at once.
//   in:  two ranges per pixel (see PeelRanges)
//   out: nearest near and farthest far depth per tile of tileSize x tileSize pixels; (2, -1) where all ranges are empty
uniform sampler2D ranges;
uniform int tileSize;

void main()
{
  ivec2 corner = ivec2(gl_FragCoord.xy) * tileSize;
  ivec2 last = min(corner + tileSize, textureSize(ranges, 0));
  vec2 span = vec2(2.0, -1.0);
  for (int y = corner.y; y < last.y; ++y)
  {
    for (int x = corner.x; x < last.x; ++x)
    {
      vec4 pair = texelFetch(ranges, ivec2(x, y), 0);
      if (pair.x < pair.y)
      {
        span = vec2(min(span.x, pair.x), max(span.y, pair.y));
      }
      if (pair.z < pair.w)
      {
        span = vec2(min(span.x, pair.z), max(span.y, pair.w));
      }
    }
  }
  gl_FragData[0] = vec4(span, 0.0, 1.0);
}
