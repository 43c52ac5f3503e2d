//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one tetrahedron adds to one pixel: premultiplied colour and alpha.
//   in:  the back face (its corners in view coordinates, the vertex opposite), the eye's coordinates q, scalars
//   out: integral of emission and extinction between the front face and the back face, clipped to what lies
//        between the near plane and the opaque geometry, in front of the clipping planes
// u runs from the back face (0) towards the eye: a fraction of that way in perspective, a length in a parallel projection.
uniform vec4 eyeVC;            // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1

uniform mat4 VCDCMatrix;
uniform vec2 halfViewport;     // pixels

flat in vec3 cornerAGSOutput;
flat in vec3 cornerBGSOutput;
flat in vec3 cornerCGSOutput;
flat in int oppositeGSOutput;
flat in vec4 eyeBarycentricGSOutput;
flat in vec4 scalarsGSOutput;
flat in vec4 opacityScalarsGSOutput;
flat in int layerGSOutput;

//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction

// Where the pixel's ray passes the back face.
vec4 barycentric = vec4(0.0);
vec3 positionVC = vec3(0.0);

float cross2(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

// From the corners and the pixel: what rasterizers interpolate between corners errs by some 1/256 pixel, to which they round them.
// Outside the face by as much, its nearest point is taken. False where a face is seen edge-on: then nothing is a number.
bool findBackFace()
{
  vec2 place = gl_FragCoord.xy / halfViewport - 1.0;
  mat4 toDC = transpose(VCDCMatrix);
  vec4 planeX = toDC[0] - place.x * toDC[3]; // the ray is where the two planes meet
  vec4 planeY = toDC[1] - place.y * toDC[3];
  vec4 corners[3] = vec4[3](vec4(cornerAGSOutput, 1.0), vec4(cornerBGSOutput, 1.0), vec4(cornerCGSOutput, 1.0));
  vec2 a = vec2(dot(planeX, corners[0]), dot(planeY, corners[0]));
  vec2 b = vec2(dot(planeX, corners[1]), dot(planeY, corners[1]));
  vec2 c = vec2(dot(planeX, corners[2]), dot(planeY, corners[2]));
  vec3 weights = vec3(cross2(b, c), cross2(c, a), cross2(a, b));
  weights = clamp(weights / (weights.x + weights.y + weights.z), 0.0, 1.0);
  weights /= weights.x + weights.y + weights.z;
  positionVC = weights.x * cornerAGSOutput + weights.y * cornerBGSOutput + weights.z * cornerCGSOutput;
  barycentric = oppositeGSOutput == 0 ? vec4(0.0, weights) : oppositeGSOutput == 1 ? vec4(weights.x, 0.0, weights.yz)
    : oppositeGSOutput == 2 ? vec4(weights.xy, 0.0, weights.z) : vec4(weights, 0.0);
  return all(lessThanEqual(weights, vec3(1.0)));
}

// Where the ray reaches the first front face.
float frontParameter(vec4 slope)
{
  float u = 3.0e38;
  for (int i = 0; i < 4; ++i)
  {
    if (slope[i] < 0.0)
    {
      u = min(u, max(barycentric[i], 0.0) / -slope[i]);
    }
  }
  return u;
}

// Barycentric coordinates add up to 1, and slopes to 0, but for rounding, which a grazing ray magnifies. Written with differences of
// the scalars, a constant stays constant whatever the coordinates are.
float change(vec4 barycentricChange, vec4 values)
{
  return dot(barycentricChange.xyz, values.xyz - values.w);
}
float interpolate(vec4 coordinates, vec4 values)
{
  return values.w + change(coordinates, values);
}

// Where the ray has a depth, as a parameter from the back face towards the eye.
float parameterAt(float depth)
{
  float towardsEye = eyeVC.z - eyeVC.w * positionVC.z;
  return (zFromDepth(depth) - positionVC.z) / towardsEye;
}

// Light of the part of the ray between two parameters.
vec4 lightBetween(float uFront, float uBack, vec4 slope)
{
  // (colour, opacity)
  vec2 scalarAtFace = vec2(interpolate(barycentric, scalarsGSOutput),
    interpolate(barycentric, opacityScalarsGSOutput));
  vec2 scalarSlope = vec2(change(slope, scalarsGSOutput), change(slope, opacityScalarsGSOutput));
  vec3 towardsEye = eyeVC.xyz - eyeVC.w * positionVC;
  float opticalScale = (uFront - uBack) * length(towardsEye) * extinctionScale;
  if (useLayers && !contourLayers)
  {
    selectLayer(layerGSOutput);
  }
  vec4 light = integrateSegment(scalarAtFace + uFront * scalarSlope, scalarAtFace + uBack * scalarSlope, opticalScale);
#ifdef NEPHOSCOPE_HAZE
  light = hazedSegment(light, positionVC + uFront * towardsEye, positionVC + uBack * towardsEye);
#endif
  return light;
}

// The parameters that the clipping planes leave.
vec2 betweenPlanes()
{
#ifdef CLIPPING_PLANES
  return clippedRay(positionVC, eyeVC.xyz - eyeVC.w * positionVC);
#else
  return vec2(-3.0e38, 3.0e38);
#endif
}

void main()
{
  if (!findBackFace())
  {
    discard;
  }
  vec4 slope = eyeBarycentricGSOutput - eyeVC.w * barycentric;
  float opaque = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  vec2 between = betweenPlanes();
  float uFront = min(min(frontParameter(slope), between.y), parameterAt(0.0));
  float uBack = max(max(0.0, between.x), parameterAt(opaque));
  if (!(uFront > uBack))
  {
    discard;
  }
  gl_FragData[0] = lightBetween(uFront, uBack, slope);
}
