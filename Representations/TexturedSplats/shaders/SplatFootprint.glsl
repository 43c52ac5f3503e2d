// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the fragment shaders of splats share: the footprint, and how much of a kernel opaque geometry hides.
uniform sampler2D opaqueDepth;
uniform vec4 depthToVC; // z in VC = (x + y e) / (z + w e) with e = 1 - depth
uniform float kernelRadius; // cells

// The line integral of the kernel as a function of q = (distance / radius)^2, in [0, 1].
float footprint(float q)
{
  if (kernel == 0) // SplatKernel.h: cubic_kernel::FootprintPolynomial, in an order with few steps one after the other
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

// Where nothing opaque was drawn it is farther than any splat, so that the far plane does not cut any.
float opaqueZ()
{
  if (!cutByOpaque)
  {
    return -1.0e37;
  }
  float e = 1.0 - texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  return e > 0.0 ? (depthToVC.x + depthToVC.y * e) / (depthToVC.z + depthToVC.w * e) : -1.0e37;
}

// The share of the kernel along a ray that lies before a cut: from 0 at -1 to 1 at 1, in half chords. q as in the footprint: the
// distribution along a chord is not the same at all distances from the centre. Of the cubic kernel to 8e-4 of a splat's peak.
float shareBefore(float cut, float q)
{
  float x = min(abs(cut), 1.0);
  float rest = 1.0 - x;
  float behind = rest * rest * rest * (0.5 + x * (SHARE0 + SHARE1 * q + x * (SHARE2 + SHARE3 * q)));
  return cut < 0.0 ? behind : 1.0 - behind;
}
