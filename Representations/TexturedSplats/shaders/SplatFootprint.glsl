// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the fragment shaders of splats share: the footprint, and how much of a kernel opaque geometry hides.
uniform sampler2D opaqueDepth;
uniform vec4 depthToVC; // z in VC = (x + y e) / (z + w e) with e = 1 - depth
uniform float kernelRadius; // cells

// The line integral of the kernel as a function of q = (distance / radius)^2, in [0, 1].
float footprint(float q)
{
  float rest = 1.0 - q;
  if (kernel == 0) // SplatKernel.h: cubic_kernel::Footprint, to 5e-5
  {
    return rest * rest * rest *
      (CUBIC0 + q * (CUBIC1 + q * (CUBIC2 + q * (CUBIC3 + q * (CUBIC4 + q * (CUBIC5 + q * (CUBIC6 + q * CUBIC7)))))));
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
  float e = 1.0 - texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  return e > 0.0 ? (depthToVC.x + depthToVC.y * e) / (depthToVC.z + depthToVC.w * e) : -1.0e37;
}

// The share of the kernel along a ray that lies before a cut: from 0 at -1 to 1 at 1, in half chords.
float shareBefore(float cut)
{
  float x = clamp(cut, -1.0, 1.0);
  return 0.5 + x * (0.9375 + x * x * (-0.625 + 0.1875 * x * x));
}
