// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A segment in several media at one place, as MixedSegment.h has it.
//   in:  sums over the media at both ends: emission (source colour times extinction) and extinction, times the length of the segment;
//        emission in its middle
//   out: premultiplied colour and alpha

// Integral of t (1 - t) exp(-A(t)) over the segment.
float bulgeWeight(float tauFront, float tauBack)
{
  float difference = tauBack - tauFront;
  if (max(tauFront, tauBack) <= 1.0)
  {
    vec4 t = vec4(0.069431844202973714, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629);
    vec4 weights = vec4(0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693);
    return dot(weights * t * (1.0 - t), exp(-t * (tauFront + 0.5 * difference * t)));
  }
  float discriminant = tauFront * tauFront + 36.0 * difference;
  float end = discriminant > 0.0 ? min(1.0, 36.0 / (tauFront + sqrt(discriminant))) : 1.0;
  ivec2 rule = max(tauFront, tauBack) <= 10.0 ? ivec2(0, 10) : ivec2(10, 16);
  float weight = 0.0;
  for (int i = rule.x; i < rule.x + rule.y; ++i)
  {
    float t = end * quadratureNodes[i].x;
    weight += quadratureNodes[i].y * t * (1.0 - t) * exp(-t * (tauFront + 0.5 * difference * t));
  }
  return weight * end;
}

vec4 integrateMixed(vec4 front, vec4 back, vec3 middle)
{
  vec2 weights = segmentWeights(front.a, back.a);
  vec3 colorFront = front.a > 0.0 ? front.rgb / front.a : vec3(0.0);
  vec3 colorBack = back.a > 0.0 ? back.rgb / back.a : vec3(0.0);
  vec3 bulge = 4.0 * middle - (front.a + back.a) * (colorFront + colorBack);
  return vec4(weights.x * colorFront + weights.y * colorBack + bulgeWeight(front.a, back.a) * bulge, weights.x + weights.y);
}
