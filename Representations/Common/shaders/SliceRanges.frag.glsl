//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The depth ranges of slices that are drawn at once.
//   in:  source: the opaque depth; with ofPeel the two ranges of a peel, of which one is drawn. ends: near depth of the first slice, of the
//        second, and far depth of the last. spans: the depths outside which a ray is not divided (see SliceSpans), where there are such.
//        lightBefore: of the slices before
//   out: inPairs: near and far depth of both slices; otherwise of all together, and the depths between which a ray is divided (Slices.glsl).
//        Nothing where what lies before is opaque.
//        As depth, a little less than the near depth, or with farthestDepth a little more than the far one
uniform sampler2D source;
uniform bool ofPeel;
uniform int rangeOfPeel;
uniform bool inPairs;
uniform vec3 ends;
uniform sampler2D spans;
uniform bool haveSpans;
uniform sampler2D lightBefore;
uniform bool farthestDepth;
const float depthMargin = 1.0e-5; // more than a rasterizer errs in depth
const float opaque = 0.99999;     // what is behind adds less than 0.003/255

// The first slice begins and the last one ends where rays do.
float inSpan(float depth, vec2 span)
{
  return depth <= 0.0 || depth >= 1.0 ? depth : clamp(depth, span.x, span.y);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 span = haveSpans ? texelFetch(spans, pixel, 0).xy : vec2(0.0, 1.0);
  vec4 texel = texelFetch(source, pixel, 0);
  vec2 seen = !ofPeel ? vec2(0.0, texel.x) : rangeOfPeel == 0 ? texel.xy : texel.zw;
  vec3 depths = clamp(vec3(inSpan(ends.x, span), inSpan(ends.y, span), inSpan(ends.z, span)), seen.x, max(seen.x, seen.y));
  if (depths.x >= depths.z || seen.x >= seen.y || texelFetch(lightBefore, pixel, 0).a > opaque)
  {
    discard;
  }
  gl_FragData[0] = inPairs ? depths.xyyz : vec4(depths.xz, span);
  gl_FragDepth = farthestDepth ? depths.z + depthMargin : depths.x - depthMargin;
}
