//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The parallelogram around a splat's silhouette.
//   in:  a splat: centre, Jacobian J of its cell, colour and extinction
//   out: coordinates st in the plane through the centre that the silhouette's cone cuts in a circle (cells, where the
//        kernel is a ball); position in view coordinates (VC); what the fragment shader needs of the splat
// In cell coordinates the eye sees a ball of the kernel's radius from the place -w: its silhouette cone cuts the plane through
// the centre at right angles to w in a circle, of radius R |w| / sqrt(|w|^2 - R^2). Any two unit vectors in that plane give a
// parallelogram around the ellipse in the world, all of the same area.
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

uniform samplerBuffer splatColors; // colour, extinction per world length
uniform samplerBuffer splatVectors; // vector, phase
uniform float greatestSpeed;       // where vectors are fully drawn
uniform mat4 VCToDC;
uniform bool parallelRays;
uniform float kernelRadius; // cells
uniform vec2 pixelsPerDC;   // half the size of the viewport

//NEPHOSCOPE::Constants

//NEPHOSCOPE::Cell

flat in int splatVSOutput[];
out vec2 stGSOutput;
out vec3 positionVCGSOutput;
flat out vec4 colorGSOutput;
flat out vec2 splatGSOutput; // |w|^2, factor on the footprint
flat out vec3 centerVCGSOutput;
flat out vec4 vectorGSOutput; // axis along the vector on the screen, over the splat's size; sine of its angle with the ray; phase
flat out float strengthGSOutput; // of the vector, 0 to 1
out vec3 rayGSOutput;            // near the eye: the ray in cells
flat out vec3 cellsGSOutput;     // and w

void emit(vec2 st, vec3 positionVC, vec3 centerVC, vec4 color, vec2 splat, vec4 vector, float strength)
{
  stGSOutput = st;
  positionVCGSOutput = positionVC;
  colorGSOutput = color;
  splatGSOutput = splat;
  centerVCGSOutput = centerVC;
  vectorGSOutput = vector;
  strengthGSOutput = strength;
  gl_Position = VCToDC * vec4(positionVC, 1.0);
  gl_Position.z = 0.0; // the near and the far plane cut nothing
  EmitVertex();
}

// Screen vector, in pixels, of a short vector at the centre.
vec2 toPixels(vec3 vectorVC, vec4 centerDC)
{
  vec4 v = VCToDC * vec4(vectorVC, 0.0);
  return (v.xy - centerDC.xy * (v.w / centerDC.w)) / centerDC.w * pixelsPerDC;
}

// A splat smaller than a pixel is spread over one, with its mass: the second moments of kernel and pixel are added.
// a and b are the splat's half axes for one cell; returns the factor on the footprint.
float spreadOverPixel(inout vec3 a, inout vec3 b, vec3 centerVC, vec4 centerDC)
{
  vec2 p = toPixels(a, centerDC);
  vec2 q = toPixels(b, centerDC);
  float area = abs(p.x * q.y - p.y * q.x);
  float size = max(dot(p, p), dot(q, q));
  if (area > largeEnough * largeEnough && area * area > largeEnough * largeEnough * size)
  {
    return 1.0;
  }
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

// What the fragment shader needs of a splat's vector.
void findVector(int splat, vec3 centerVC, float size, out vec4 vector, out float strength)
{
  vector = vec4(0.0);
  strength = 0.0;
  if (!drawVectors)
  {
    return;
  }
  vec4 texel = texelFetch(splatVectors, splat);
  vec3 v = mat3(modelToVC) * texel.xyz;
  float speed = length(texel.xyz);
  float magnitude = length(v);
  strength = min(speed / greatestSpeed, 1.0);
  if (!(magnitude > 0.0))
  {
    strength = 0.0;
    return;
  }
  vec3 ray = parallelRays ? vec3(0.0, 0.0, -1.0) : normalize(centerVC);
  vec3 direction = v / magnitude;
  vec2 onScreen = parallelRays ? direction.xy : direction.xy - direction.z * centerVC.xy / centerVC.z;
  float across = length(direction - dot(direction, ray) * ray);
  vector = vec4(across > 1.0e-4 ? normalize(onScreen) / size : vec2(1.0 / size, 0.0), across, texel.w);
}

// Splats around and close to the eye are seen in the whole viewport.
void emitViewport(vec3 w, mat3 inverseJ, vec4 color)
{
  for (int corner = 0; corner < 4; ++corner)
  {
    vec2 place = vec2(corner % 2 == 0 ? -1.0 : 1.0, corner < 2 ? -1.0 : 1.0);
    vec3 ray = vec3((place.x + VCToDC[2][0]) / VCToDC[0][0], (place.y + VCToDC[2][1]) / VCToDC[1][1], -1.0);
    positionVCGSOutput = ray;
    rayGSOutput = inverseJ * ray;
    cellsGSOutput = w;
    colorGSOutput = color;
    gl_Position = vec4(place, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}

void main()
{
  vec3 center;
  mat3 J;
  readSplat(splatVSOutput[0], center, J);
  vec3 towards = parallelRays ? vec3(0.0, 0.0, -1.0) : center; // from the eye
  float determinant = dot(J[0], cross(J[1], J[2]));
  vec3 w = vec3(dot(towards, cross(J[1], J[2])), dot(towards, cross(J[2], J[0])), dot(towards, cross(J[0], J[1]))) / determinant;
  float square = dot(w, w);
  float radius = kernelRadius;
  if (nearEye)
  {
    emitViewport(w, inverse(J), texelFetch(splatColors, splatVSOutput[0]));
    return;
  }
  if (!parallelRays)
  {
    if (square <= kernelRadius * kernelRadius || center.z >= 0.0)
    {
      return; // behind the eye; those around it are drawn as near ones
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
  vec4 color = texelFetch(splatColors, splatVSOutput[0]);
  vec2 splat = vec2(square, spreadOverPixel(a, b, center, centerDC));
  vec4 vector;
  float strength;
  findVector(splatVSOutput[0], center, pow(abs(determinant), 1.0 / 3.0), vector, strength);
  a *= radius;
  b *= radius;
  emit(vec2(-radius, -radius), center - a - b, center, color, splat, vector, strength);
  emit(vec2(radius, -radius), center + a - b, center, color, splat, vector, strength);
  emit(vec2(-radius, radius), center - a + b, center, color, splat, vector, strength);
  emit(vec2(radius, radius), center + a + b, center, color, splat, vector, strength);
  EndPrimitive();
}
