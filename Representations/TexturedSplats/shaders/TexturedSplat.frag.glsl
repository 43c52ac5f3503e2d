//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one splat adds to one pixel: premultiplied colour and alpha = 1 - exp(-extinction * footprint).
//   in:  st, a point of the ray in the plane through the centre, in cells; w, the centre seen from the eye in cells
//   out: the exact integral along the ray of the kernel in the shape of the cell (EllipsoidSplat.h): with k = w + st, at right
//        angles to each other, the ray passes the centre at the distance |st| |w| / |k|, and a cell is |ray| / |k| thick
// What lies behind opaque geometry is left out: the share of the kernel in front of it along the ray is taken as a polynomial
// of the place where it is cut.
uniform sampler2D opaqueDepth;
uniform vec4 depthToVC; // z in VC = (x + y e) / (z + w e) with e = 1 - depth
uniform bool parallelRays;
uniform float kernelRadius;
uniform float extinctionScale;

//NEPHOSCOPE::Constants

in vec2 stGSOutput;
in vec3 positionVCGSOutput;
flat in vec4 colorGSOutput;
flat in vec2 splatGSOutput;

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

float opaqueZ()
{
  float e = 1.0 - texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  return (depthToVC.x + depthToVC.y * e) / (depthToVC.z + depthToVC.w * e);
}

void main()
{
  float inPlane = dot(stGSOutput, stGSOutput);
  float square = splatGSOutput.x; // |w|^2
  float along = parallelRays ? square : square + inPlane; // |k|^2
  float q = inPlane * square / (along * kernelRadius * kernelRadius);
  if (q >= 1.0)
  {
    discard;
  }
  float ray = parallelRays ? 1.0 : length(positionVCGSOutput);
  float cell = inversesqrt(along); // 1 / |k|
  // Depth of the point nearest to the centre, and half the chord through the kernel, as z in view coordinates.
  float slope = parallelRays ? 1.0 : -positionVCGSOutput.z;
  float middle = parallelRays ? positionVCGSOutput.z : positionVCGSOutput.z * square / along;
  float halfChord = slope * kernelRadius * sqrt(1.0 - q) * cell;
  float cut = clamp((middle - opaqueZ()) / halfChord, -1.0, 1.0); // 1: all of it is in front
  float share = 0.5 + cut * (0.9375 + cut * cut * (-0.625 + 0.1875 * cut * cut));
  float opticalDepth = extinctionScale * colorGSOutput.a * splatGSOutput.y * share * footprint(q) * ray * cell;
  float alpha = 1.0 - exp(-opticalDepth);
  gl_FragData[0] = vec4(alpha * colorGSOutput.rgb, alpha);
}
