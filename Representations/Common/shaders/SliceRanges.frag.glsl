//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The depth ranges of a pair of slices, as those of a peel (see PeelRanges).
//   in:  source: the opaque depth; with ofPeel the two ranges of a peel. slice: near and far depth of the first and of the second slice;
//        spans: the depths outside which a ray is not divided (see SliceSpans), where there are such
//   out: the part of the first range in the first slice, of the second in the second; as depth, a little less than the nearest of them, or
//        with farthestDepth a little more than the farthest
uniform sampler2D source;
uniform bool ofPeel;
uniform vec4 slice;
uniform sampler2D spans;
uniform bool haveSpans;
uniform bool farthestDepth;
const vec2 nothing = vec2(1.0, 0.0);
const float depthMargin = 1.0e-5; // more than a rasterizer errs in depth

vec2 both(vec2 a, vec2 b)
{
  vec2 range = vec2(max(a.x, b.x), min(a.y, b.y));
  return range.x < range.y ? range : nothing;
}

// The first slice begins and the last one ends where rays do.
float inSpan(float depth, vec2 span)
{
  return depth <= 0.0 || depth >= 1.0 ? depth : clamp(depth, span.x, span.y);
}

void main()
{
  vec2 span = haveSpans ? texelFetch(spans, ivec2(gl_FragCoord.xy), 0).xy : vec2(0.0, 1.0);
  vec4 between = vec4(inSpan(slice.x, span), inSpan(slice.y, span), inSpan(slice.z, span), inSpan(slice.w, span));
  vec4 texel = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
  vec4 ranges = ofPeel ? texel : vec4(0.0, texel.x, 0.0, texel.x);
  vec2 first = both(ranges.xy, between.xy);
  vec2 second = both(ranges.zw, between.zw);
  if (first == nothing && second == nothing)
  {
    discard;
  }
  gl_FragData[0] = vec4(first, second);
  float farthest = max(first == nothing ? 0.0 : first.y, second == nothing ? 0.0 : second.y);
  gl_FragDepth = farthestDepth ? farthest + depthMargin : min(first.x, second.x) - depthMargin;
}
