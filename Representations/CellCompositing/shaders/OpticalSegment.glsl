// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The optical model of a ray segment, as OpticalSegment.h has it (the nodes come from there).
//   in:  optical depths of the segment, extinction at its ends times its length, >= 0
//   out: weights (front, back) of the source colours at the two ends; their sum is alpha = 1 - T
// Constant: averageIntegration.
uniform vec2 quadratureNodes[26];

// Series for thin segments, without cancellation: OpticalSegment.h.
vec2 thinSegmentWeights(float tauFront, float tauBack)
{
  float z = 0.25 * (tauFront + tauBack);
  float d = 0.5 * (tauBack - tauFront);
  float q = z * z;
  float h = exp(-z);
  float halfAlpha = h * z * (1.0 + q * (1.0 / 6.0 + q * (1.0 / 120.0 + q / 5040.0)));
  float p0 = q * (1.0 / 3.0 + q * (1.0 / 30.0 + q * (1.0 / 840.0 + q / 45360.0)));
  float p1 = 1.0 / 6.0 + q * (1.0 / 60.0 + q * (1.0 / 1680.0 + q / 90720.0));
  float p2 = 1.0 / 60.0 + q * (1.0 / 840.0 + q / 30240.0);
  float p3 = 1.0 / 840.0 + q / 15120.0;
  float excess = h * (p0 - d * (p1 + d * (p2 + d * (p3 + d / 15120.0))));
  return vec2(halfAlpha + excess, halfAlpha - excess);
}

vec2 thickSegmentWeights(float tauFront, float tauBack)
{
  float difference = tauBack - tauFront;
  float discriminant = tauFront * tauFront + 36.0 * difference;
  float end = discriminant > 0.0 ? min(1.0, 36.0 / (tauFront + sqrt(discriminant))) : 1.0;
  ivec2 rule = max(tauFront, tauBack) <= 10.0 ? ivec2(0, 10) : ivec2(10, 16);
  vec2 weights = vec2(0.0);
  for (int i = rule.x; i < rule.x + rule.y; ++i)
  {
    float t = end * quadratureNodes[i].x;
    float emitted = quadratureNodes[i].y * (tauFront + difference * t) * exp(-t * (tauFront + 0.5 * difference * t));
    weights += emitted * vec2(1.0 - t, t);
  }
  return weights * end;
}

vec2 exactSegmentWeights(float tauFront, float tauBack)
{
  return max(tauFront, tauBack) <= 1.0 ? thinSegmentWeights(tauFront, tauBack)
                                       : thickSegmentWeights(tauFront, tauBack);
}

vec2 averageSegmentWeights(float tauFront, float tauBack)
{
  float tau = 0.5 * (tauFront + tauBack);
  // 1 - exp(-tau) loses thin segments; its series does not.
  float alpha = tau < 0.02 ? tau * (1.0 - tau * (0.5 - tau * (1.0 / 6.0 - tau / 24.0))) : 1.0 - exp(-tau);
  return vec2(0.5 * alpha);
}

vec2 segmentWeights(float tauFront, float tauBack)
{
  return averageIntegration ? averageSegmentWeights(tauFront, tauBack)
                            : exactSegmentWeights(tauFront, tauBack);
}
