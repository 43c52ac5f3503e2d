//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The parallelogram around a splat's silhouette, and what its vector is drawn on.
//   in:  a splat: centre, Jacobian J of its cell, colour and extinction
//   out: coordinates st in the plane through the centre that the silhouette's cone cuts in a circle (cells, where the
//        kernel is a ball); position in view coordinates (VC); what the fragment shader needs of the splat
// In cell coordinates the eye sees a ball of the kernel's radius from the place -w: its silhouette cone cuts the plane through
// the centre at right angles to w in a circle, of radius R |w| / sqrt(|w|^2 - R^2). Any two unit vectors in that plane give a
// parallelogram around the ellipse in the world, all of the same area.
//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Constants
layout(points) in;
layout(triangle_strip, max_vertices = MAX_VERTICES) out;

uniform FloatArray splatColors; // colour, extinction per world length
uniform mat4 VCToDC;
uniform float kernelRadius; // cells
uniform vec2 pixelsPerDC;   // half the size of the viewport

//NEPHOSCOPE::Cell

flat in int splatVSOutput[]; // ~n: the vector of splat n, without its medium
#ifdef FADE
flat in float weightVSOutput[];
#endif
out vec2 stGSOutput;
out vec3 positionVCGSOutput;
flat out int kindGSOutput;
flat out vec4 colorGSOutput;
flat out vec2 splatGSOutput; // |w|^2, factor on the footprint
flat out vec3 centerVCGSOutput;
flat out vec4 vectorGSOutput; // streaks: direction on the plane that faces the eye, length of a unit vector there, phase
flat out vec4 detailGSOutput; // streaks: unit of length, strength, seed, pixel; segments: length and width in pixels
out vec3 rayGSOutput;         // near the eye: the ray in cells
flat out vec3 cellsGSOutput;  // and w

#ifdef DRAW_REGION
//NEPHOSCOPE::InRegion
flat out vec4 regionGSOutput;
#endif

#ifdef CAMERA_LIGHT // each pixel has its own direction: the colour is what haze adds
flat out int litSplatGSOutput;
flat out vec2 lightGSOutput; // scalar, fraction of the light that haze transmits
int litSplat;
vec2 lightOfSplat;
#endif

// What the corners of a splat have in common.
struct SplatLook
{
  int kind;
  vec4 color; // and extinction, or strength
  float factor;
  vec4 vector;
  vec4 detail;
  vec3 center; // of the splat, in VC
  bool small;  // about as small as a pixel
  vec2 ends;   // z of its near and of its far end, in VC
};

void emitCorner(vec2 st, vec3 positionVC, vec3 centerVC, float square, SplatLook look, vec4 positionDC)
{
  stGSOutput = st;
  positionVCGSOutput = positionVC;
  kindGSOutput = look.kind;
  colorGSOutput = look.color;
  splatGSOutput = vec2(square, look.factor);
  centerVCGSOutput = centerVC;
  vectorGSOutput = look.vector;
  detailGSOutput = look.detail;
  rayGSOutput = vec3(0.0);
  cellsGSOutput = vec3(0.0);
#ifdef CAMERA_LIGHT
  litSplatGSOutput = litSplat;
  lightGSOutput = lightOfSplat;
#endif
#ifdef DRAW_REGION
  regionGSOutput = inRegion(look.center, look.small);
#endif
  gl_Position = positionDC;
  gl_Position.z = testedDepth(look.ends.x, look.ends.y, gl_Position.w);
  EmitVertex();
}

void emitAt(vec2 st, vec3 positionVC, vec3 centerVC, float square, SplatLook look)
{
  emitCorner(st, positionVC, centerVC, square, look, VCToDC * vec4(positionVC, 1.0));
}

// Screen vector, in pixels, of a short vector at the centre.
vec2 toPixels(vec3 vectorVC, vec4 centerDC)
{
  vec4 v = VCToDC * vec4(vectorVC, 0.0);
  return (v.xy - centerDC.xy * (v.w / centerDC.w)) / centerDC.w * pixelsPerDC;
}

// A splat smaller than a pixel is spread over one, with its mass: the second moments of kernel and pixel are added.
// a and b are the splat's half axes for one cell; returns the factor on the footprint.
float spreadOverPixel(inout vec3 a, inout vec3 b, vec3 centerVC, vec4 centerDC, out bool isDot)
{
  isDot = false;
  vec2 p = toPixels(a, centerDC);
  vec2 q = toPixels(b, centerDC);
  float area = abs(p.x * q.y - p.y * q.x);
  float sum = dot(p, p) + dot(q, q);
  // the square of the smaller half axis of the ellipse, whatever the two directions are
  float smallest = 2.0 * area * area / (sum + sqrt(max(sum * sum - 4.0 * area * area, 0.0)));
  if (smallest > largeEnough * largeEnough)
  {
    return 1.0;
  }
  isDot = sum < dotSize;
  // covariance of the kernel on the screen, over its variance of one axis, plus that of the pixel
  vec3 covariance = vec3(p.x * p.x + q.x * q.x, p.x * p.y + q.x * q.y, p.y * p.y + q.y * q.y);
  covariance.xz += pixelVariance;
  float determinant = covariance.x * covariance.z - covariance.y * covariance.y;
  float edge = sqrt(covariance.x); // Cholesky's factor: columns (edge, y / edge) and (0, determinant^1/2 / edge)
  vec2 first = vec2(edge, covariance.y / edge);
  vec2 second = vec2(0.0, sqrt(determinant) / edge);
  // back from pixels to the plane that faces the eye
  float perPixelX = centerDC.w / (pixelsPerDC.x * VCToDC[0][0]);
  float perPixelY = centerDC.w / (pixelsPerDC.y * VCToDC[1][1]);
  a = vec3(first.x * perPixelX, first.y * perPixelY, 0.0);
  b = vec3(0.0, second.y * perPixelY, 0.0);
  return area / sqrt(determinant);
}

// The centre seen from the eye, in cells; in a parallel projection the direction of the rays.
vec3 inCells(vec3 center, mat3 J)
{
  vec3 towards = parallelRays ? vec3(0.0, 0.0, -1.0) : center;
  float determinant = dot(J[0], cross(J[1], J[2]));
  return vec3(dot(towards, cross(J[1], J[2])), dot(towards, cross(J[2], J[0])), dot(towards, cross(J[0], J[1]))) / determinant;
}

void emitKernel(vec3 center, mat3 J, SplatLook look)
{
  vec3 w = inCells(center, J);
  float square = dot(w, w);
  float radius = kernelRadius;
  float reach = reachAlongZ(J, kernelRadius);
  if (outsideSlice(center, J, kernelRadius))
  {
    return;
  }
  if (!parallelRays)
  {
    if (square <= kernelRadius * kernelRadius || center.z >= reach)
    {
      return; // around the eye, which is drawn in another way, or all of it behind the eye
    }
    radius *= inversesqrt(1.0 - kernelRadius * kernelRadius / square);
  }
  vec3 axis = abs(w.x) < abs(w.y) ? (abs(w.x) < abs(w.z) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0))
                                  : (abs(w.y) < abs(w.z) ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
  vec3 u = normalize(cross(w, axis));
  vec3 v = cross(w, u) * inversesqrt(square);
  vec3 a = J * u;
  vec3 b = J * v;
  vec4 centerDC = VCToDC * vec4(center, 1.0);
  if (parallelRays || center.z < -reach) // otherwise it is large
  {
    look.factor = spreadOverPixel(a, b, center, centerDC, look.small);
  }
  look.ends = vec2(center.z + reach, center.z - reach);
  look.detail.w = centerDC.w / (pixelsPerDC.y * VCToDC[1][1]);
  a *= radius;
  b *= radius;
  emitAt(vec2(-radius, -radius), center - a - b, center, square, look);
  emitAt(vec2(radius, -radius), center + a - b, center, square, look);
  emitAt(vec2(-radius, radius), center - a + b, center, square, look);
  emitAt(vec2(radius, radius), center + a + b, center, square, look);
  EndPrimitive();
}

#ifdef DRAW_VECTORS
//NEPHOSCOPE::VectorSplat
#endif

// Splats around and close to the eye are seen in the whole viewport.
void emitViewport(vec3 center, vec3 w, mat3 inverseJ, vec4 color)
{
  for (int corner = 0; corner < 4; ++corner)
  {
    vec2 place = vec2(corner % 2 == 0 ? -1.0 : 1.0, corner < 2 ? -1.0 : 1.0);
    vec3 ray = vec3((place.x + VCToDC[2][0]) / VCToDC[0][0], (place.y + VCToDC[2][1]) / VCToDC[1][1], -1.0);
    positionVCGSOutput = ray;
    rayGSOutput = inverseJ * ray;
    cellsGSOutput = w;
    colorGSOutput = color;
    kindGSOutput = VIEWPORT;
#ifdef CAMERA_LIGHT
    litSplatGSOutput = litSplat;
    lightGSOutput = lightOfSplat;
#endif
#ifdef DRAW_REGION
    regionGSOutput = inRegion(center, false);
#endif
    gl_Position = vec4(place, testsFarEnds ? 1.0 : -1.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}

void emitMedium(vec3 center, mat3 J, vec4 color, int kind)
{
  vec3 w = inCells(center, J);
  if (!(color.a > 0.0))
  {
    return;
  }
  if (nearEye && dot(w, w) < 1.69 * kernelRadius * kernelRadius)
  {
    emitViewport(center, w, inverse(J), kind == HALF_MEDIUM ? vec4(color.rgb, 0.5 * color.a) : color);
  }
  else
  {
    emitKernel(center, J, SplatLook(kind, color, 1.0, vec4(0.0), vec4(0.0), center, false, vec2(0.0)));
  }
}

void main()
{
  bool vectorAlone = splatVSOutput[0] < 0;
  int splat = vectorAlone ? ~splatVSOutput[0] : splatVSOutput[0];
  vec3 center;
  mat3 J;
  readSplat(splat, center, J);
  vec4 color = element(splatColors, splat);
#ifdef CAMERA_LIGHT
  litSplat = splat;
  lightOfSplat = vec2(color.r, 1.0);
  color.rgb = vec3(0.0);
#ifdef NEPHOSCOPE_HAZE
  lightOfSplat.y = hazeBefore(center).a;
#endif
#endif
#ifdef NEPHOSCOPE_HAZE
  color.rgb = hazedColor(color.rgb, center); // a splat is small, and so is what haze changes across it
#endif
#ifdef FADE
  color.a *= weightVSOutput[0];
#endif
#ifdef DRAW_VECTORS
  SplatVector vector;
  if ((vectorAlone || !mediaApart || nearEye) && readVector(splat, vector)) // around the eye there are no layers
  {
#ifdef NEPHOSCOPE_HAZE
    vector.color.rgb = hazedColor(vector.color.rgb, center);
#endif
    // Half of the medium behind the vector, half in front (SplatOpacity.h), unless it is drawn apart.
#ifdef FADE
    vector.weight = weightVSOutput[0];
#endif
    vec4 half_ = vectorAlone ? vec4(0.0) : color;
    emitMedium(center, J, half_, HALF_MEDIUM);
    emitVector(vector, center, J);
    emitMedium(center, J, half_, HALF_MEDIUM);
    return;
  }
#endif
  if (!vectorAlone)
  {
    emitMedium(center, J, color, MEDIUM);
  }
}
