//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A splat that is not too near as one point: a square of pixels around its silhouette, without a geometry shader and without the
// diagonal of two triangles.
//   in:  the splat to draw, its weight where there are weights
//   out: what the fragment shader needs to have the line integral along a pixel's ray from the pixel's offset p to the centre
// In cell coordinates the ray through the centre is k0 (per unit of depth) and that through the pixel k0 + D p. The offset across k0
// gives the ellipse q0 = |k0 x D p|^2, the one along it h = k0 . D p / |k0|^2, and nothing else enters: |k|^2 = |k0|^2 ((1 + h)^2 + e q0).
//NEPHOSCOPE::Arrays
in int splatNumber;
in float splatWeight; // of the extinction, where levels of the hierarchy fade into each other
uniform FloatArray splatColors; // colour, extinction per world length
uniform mat4 VCToDC;
uniform float kernelRadius; // cells
uniform vec2 pixelsPerDC;   // half the size of the viewport
uniform vec2 withinMargin;  // size of the viewport over that with a margin, in which no point's centre is clipped
uniform float extinctionScale;

//NEPHOSCOPE::Constants

//NEPHOSCOPE::Cell

#ifdef DRAW_REGION
//NEPHOSCOPE::InRegion
flat out vec4 regionVSOutput;
#endif

#ifdef CAMERA_LIGHT
//NEPHOSCOPE::Light
#endif

flat out vec4 colorVSOutput;   // colour, optical depth in the middle for a footprint of 1, times log2(e)
flat out vec4 ellipseVSOutput; // p to the unit circle of q0 (upper triangular matrix), e
flat out vec4 placeVSOutput;   // centre in pixels, gradient of h
flat out vec4 depthVSOutput;   // z of the centre in VC, how far z goes on along a cell; gradient of the optical depth in first order

// Second moments of the kernel on the screen, over its variance along an axis in cells; smaller ones than a pixel are spread over one, with
// their mass. Returns the factor on the footprint.
float spreadOverPixel(inout vec3 covariance, float area)
{
  float trace = covariance.x + covariance.z;
  float smallest = 2.0 * area * area / (trace + sqrt(max(trace * trace - 4.0 * area * area, 0.0)));
  if (smallest > largeEnough * largeEnough)
  {
    return 1.0;
  }
  covariance.xz += pixelVariance;
  return area / sqrt(covariance.x * covariance.z - covariance.y * covariance.y);
}

void main()
{
  vec3 center;
  mat3 J;
  readSplat(splatNumber, center, J);
  if (outsideSlice(center, J, kernelRadius))
  {
    gl_PointSize = 1.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  mat3 cofactors = mat3(cross(J[1], J[2]), cross(J[2], J[0]), cross(J[0], J[1]));
  mat3 inverseJ = transpose(cofactors) / dot(J[0], cofactors[0]);
  float depth = parallelRays ? 1.0 : -center.z;
  vec3 ray = parallelRays ? vec3(0.0, 0.0, -1.0) : center / depth;
  vec3 k = inverseJ * ray;
  float square = dot(k, k);
  vec3 dx = inverseJ[0] / (pixelsPerDC.x * VCToDC[0][0]);
  vec3 dy = inverseJ[1] / (pixelsPerDC.y * VCToDC[1][1]);
  vec3 across = depth * inversesqrt(square) * k;
  vec3 x = cross(across, dx);
  vec3 y = cross(across, dy);
  float area = 1.0 / (depth * abs(dot(across, cross(dx, dy)))); // of a cell on the screen
  vec3 covariance = area * area * vec3(dot(y, y), -dot(x, y), dot(x, x));
  float size = covariance.x + covariance.z;
  float mass = spreadOverPixel(covariance, area);
  float determinant = covariance.x * covariance.z - covariance.y * covariance.y;
  determinant = mass < 1.0 ? determinant : area * area; // without cancellation
  float edge = sqrt(covariance.z / determinant);
  vec2 h = vec2(dot(k, dx), dot(k, dy)) / square;
  float e = parallelRays ? 0.0 : kernelRadius * kernelRadius / (square * depth * depth);
  // (1 + h)^2 + e q0 = q0 on the silhouette; h is at most `lean` times the root of q0
  float lean = parallelRays ? 0.0 : kernelRadius * sqrt(max(h.x * h.x * covariance.x + 2.0 * h.x * h.y * covariance.y + h.y * h.y * covariance.z, 0.0));
  float reach = kernelRadius * sqrt(max(covariance.x, covariance.z)) / max(sqrt(max(1.0 - e, 0.0)) - lean, 0.1);
  vec4 centerDC = VCToDC * vec4(center, 1.0);
  vec2 place = centerDC.xy / centerDC.w;
  vec4 color = element(splatColors, splatNumber);
#ifdef CAMERA_LIGHT
  color.rgb = colorTowardsCamera(color.r, splatNumber, ray);
#endif
#ifdef NEPHOSCOPE_HAZE
  color.rgb = hazedColor(color.rgb, center); // a splat is small, and so is what haze changes across it
#endif
#ifdef FADE
  color.a *= splatWeight;
#endif
  float thickness = inversesqrt(square) * (firstOrder ? length(ray) : 1.0);
  colorVSOutput = vec4(color.rgb, 1.4426950408889634 * extinctionScale * color.a * mass * thickness);
  ellipseVSOutput = vec4(vec3(edge, -covariance.y / (determinant * edge), inversesqrt(determinant) / edge) / kernelRadius, e);
  placeVSOutput = vec4((place + 1.0) * pixelsPerDC, h);
  vec2 rayGradient = ray.xy / (dot(ray, ray) * pixelsPerDC * vec2(VCToDC[0][0], VCToDC[1][1])); // of the ray's length, over it
  depthVSOutput = vec4(center.z, inversesqrt(square), colorVSOutput.a * (rayGradient - h));
#ifdef DRAW_REGION
  regionVSOutput = inRegion(center, mass < 1.0 && size < dotSize);
#endif
  gl_PointSize = 2.0 * reach + 0.05;
  float alongZ = reachAlongZ(J, kernelRadius);
  gl_Position = parallelRays || center.z < 0.0 ? vec4(place * withinMargin, testedDepth(center.z + alongZ, center.z - alongZ, 1.0), 1.0)
                                               : vec4(2.0, 2.0, 2.0, 1.0);
}
