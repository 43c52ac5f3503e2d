// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the fragment shaders of splats share: the footprint, and how much of a kernel is seen between opaque geometry, peeled surfaces and
// clipping planes.
uniform sampler2D opaqueDepth;
uniform sampler2D depthRanges; // where VTK peels surfaces: near and far depth of two ranges, empty where near >= far
uniform vec4 rayOfPixel; // X = x + z px, Y = y + w py of the ray (X, Y, -1) through a pixel; of its place in a parallel projection
uniform vec4 depthToVC; // z in VC = (x + y e) / (z + w e) with e = 1 - depth
uniform float kernelRadius; // cells

// The line integral of the kernel as a function of q = (distance / radius)^2, in [0, 1].
float footprint(float q)
{
  if (kernel == 0) // SplatKernel.h: the polynomial of footprintCoefficients, in an order with few steps one after the other
  {
    float rest = 1.0 - q;
    float x = q - rest;
    float square = x * x;
    float fourth = square * square;
    float low = (CUBIC0 + CUBIC1 * x) + (CUBIC2 + CUBIC3 * x) * square;
    float middle = (CUBIC4 + CUBIC5 * x) + (CUBIC6 + CUBIC7 * x) * square;
    float high = (CUBIC8 + CUBIC9 * x) + (CUBIC10 + CUBIC11 * x) * square;
    return (rest * rest * rest) * (low + fourth * (middle + fourth * high));
  }
  if (kernel == 1)
  {
    float rho = kernelRadius * sqrt(q);
    return rho <= QUADRATIC_INNER_RADIUS
      ? QUADRATIC_INNER * (QUADRATIC_INNER_RADIUS * kernelRadius - rho * rho)
      : QUADRATIC_OUTER * (kernelRadius - rho) * (kernelRadius - rho);
  }
  return GAUSSIAN_PEAK * exp(-GAUSSIAN_DECAY * q);
}

const float farAway = 1.0e37;

// z of a depth. Where the near and the far plane cut splats, they are among the clipping planes.
float zOfDepth(float depth)
{
  float e = 1.0 - depth;
  return depth <= 0.0 ? farAway : e > 0.0 ? (depthToVC.x + depthToVC.y * e) / (depthToVC.z + depthToVC.w * e) : -farAway;
}

#ifdef CLIPPING_PLANES
const bool clipped = true;
vec2 clippedZ()
{
  vec2 ray = rayOfPixel.xy + rayOfPixel.zw * gl_FragCoord.xy;
  return -(parallelRays ? clippedRay(vec3(ray, 0.0), vec3(0.0, 0.0, -1.0)) : clippedRay(vec3(0.0), vec3(ray, -1.0)));
}
#else
const bool clipped = false;
vec2 clippedZ()
{
  return vec2(farAway, -farAway);
}
#endif

// Where splats are seen in a pixel: near and far z of two ranges between peeled surfaces, or of one in front of what is opaque; empty where
// near <= far.
vec4 seenRanges()
{
  vec4 range = vec4(farAway, -farAway, -farAway, farAway);
  if (peeled)
  {
    vec4 depths = texelFetch(depthRanges, ivec2(gl_FragCoord.xy), 0);
    range = vec4(zOfDepth(depths.x), zOfDepth(depths.y), zOfDepth(depths.z), zOfDepth(depths.w));
  }
  else if (cutByOpaque)
  {
    range.y = zOfDepth(texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r);
  }
  vec2 clip = clippedZ();
  range.xz = min(range.xz, vec2(clip.x));
  range.yw = max(range.yw, vec2(clip.y));
  return range;
}

// SplatKernel.h: cubic_kernel::LineMoments
vec4 lineMoments(float square, float z)
{
  float r = sqrt(square + z * z);
  float first = 0.5 * (z * r + square * log((z + r) * inversesqrt(max(square, 1.0e-12))));
  return vec4(z, first, z * (z * z / 3.0 + square), 0.25 * (z * r * r * r + 3.0 * square * first));
}

// cubic_kernel::FootprintUpTo, of the square of the distance
float footprintUpTo(float square, float z)
{
  const vec4 outer = vec4(CUBIC_OUTER0, CUBIC_OUTER1, CUBIC_OUTER2, CUBIC_OUTER3);
  const vec4 inner = vec4(CUBIC_INNER0, CUBIC_INNER1, CUBIC_INNER2, CUBIC_INNER3);
  float halfChord = sqrt(max(CUBIC_RADIUS * CUBIC_RADIUS - square, 0.0));
  float halfCore = sqrt(max(CUBIC_INNER_RADIUS * CUBIC_INNER_RADIUS - square, 0.0));
  return dot(outer, lineMoments(square, min(z, halfChord))) + dot(inner - outer, lineMoments(square, min(z, halfCore)));
}

// Abramowitz and Stegun 7.1.26, to 1.5e-7, of x >= 0
float errorFunction(float x)
{
  float t = 1.0 / (1.0 + 0.3275911 * x);
  return 1.0 - t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)))) * exp(-x * x);
}

// The share of the kernel along a ray that lies before z, in cells from the point nearest to the centre; q as in the footprint.
float exactShareBefore(float z, float q) // KernelShareBefore
{
  float part;
  if (kernel == 2)
  {
    part = errorFunction(min(abs(z) / GAUSSIAN_DEPTH, 9.0));
  }
  else
  {
    float square = CUBIC_RADIUS * CUBIC_RADIUS * q;
    float whole = footprintUpTo(square, CUBIC_RADIUS);
    float ahead = abs(z) * CUBIC_RADIUS / kernelRadius;
    bool all = !(ahead * ahead < CUBIC_RADIUS * CUBIC_RADIUS - square); // and without a quotient of two small numbers
    part = all || !(whole > 0.0) ? 1.0 : clamp(footprintUpTo(square, ahead) / whole, 0.0, 1.0);
  }
  return z < 0.0 ? 0.5 - 0.5 * part : 0.5 + 0.5 * part;
}

// The same as a polynomial, by a fifth of the time; of the cubic kernel to 8e-4 of a splat's peak (cubic_kernel::ShareBefore).
float quickShareBefore(float z, float q)
{
  float x = min(abs(z) * inversesqrt(1.0 - q) / kernelRadius, 1.0);
  float rest = 1.0 - x;
  float behind = rest * rest * rest * (0.5 + x * (SHARE0 + SHARE1 * q + x * (SHARE2 + SHARE3 * q)));
  return z < 0.0 ? behind : 1.0 - behind;
}

// Planes are exact. In front of surfaces there is less time, and peels end in 8 bits.
float shareBefore(float z, float q)
{
  return clipped ? exactShareBefore(z, q) : quickShareBefore(z, q);
}

// The share that is seen of a kernel, in each of two ranges (the second is empty where nothing is peeled). middle: z of the ray's
// point nearest to the centre; cell: how far z goes on along a cell; from: z where it begins to be seen.
vec2 seenShares(float middle, float cell, float q, float from)
{
  if (!cutByOpaque && !peeled && !clipped)
  {
    return vec2(from < farAway ? 1.0 - shareBefore((middle - from) / cell, q) : 1.0, 0.0);
  }
  vec4 range = seenRanges();
  range.xz = min(range.xz, vec2(from));
  vec2 shares = vec2(0.0);
  for (int i = 0; i < (peeled ? 2 : 1); ++i)
  {
    float near = range[2 * i], far = range[2 * i + 1];
    if (near > far)
    {
      float before = near < farAway ? shareBefore((middle - near) / cell, q) : 0.0;
      shares[i] = max(0.0, (far > -farAway ? shareBefore((middle - far) / cell, q) : 1.0) - before);
    }
  }
  return shares;
}

// The light of two optical depths, one for each range.
void putLight(vec2 opticalDepths, vec3 color)
{
  vec2 alpha = 1.0 - exp(-opticalDepths);
  gl_FragData[0] = vec4(alpha.x * color, alpha.x);
  if (peeled)
  {
    gl_FragData[1] = vec4(alpha.y * color, alpha.y);
  }
}
