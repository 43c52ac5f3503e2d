//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one tetrahedron adds to one pixel: premultiplied colour and alpha.
//   in:  a point of the back face (barycentric coordinates and view coordinates), the eye's coordinates q, scalars
//   out: integral of emission and extinction between the front face and the back face, clipped to what lies
//        between the near plane and the opaque geometry, or in each of two depth ranges
// u runs from the back face (0) towards the eye: a fraction of that way in perspective, a length in a parallel projection.
uniform sampler2D depthRanges; // near and far depth of two ranges, empty where near >= far
uniform vec4 eyeVC;            // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1

in vec4 barycentricGSOutput;
in vec3 positionVCGSOutput;
flat in vec4 eyeBarycentricGSOutput;
flat in vec4 scalarsGSOutput;
flat in vec4 opacityScalarsGSOutput;
flat in vec4 contourScalarsGSOutput;
flat in ivec2 tetrahedronGSOutput; // number, layer

//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction
//NEPHOSCOPE::FaceScalars
//NEPHOSCOPE::ContourSurfaces

// Where the ray reaches the first front face.
float frontParameter(vec4 barycentric, vec4 slope)
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
float interpolate(vec4 barycentric, vec4 values)
{
  return values.w + change(barycentric, values);
}

// Colour, opacity and contour scalar at u; exactly those of a face if u is where the ray crosses it.
vec3 scalarsAt(float u, vec4 barycentric, vec4 slope)
{
  vec4 coordinates = barycentric + u * slope;
  vec3 s = vec3(interpolate(coordinates, scalarsGSOutput), interpolate(coordinates, opacityScalarsGSOutput),
    interpolate(coordinates, contourScalarsGSOutput));
  for (int i = 0; i < 4; ++i)
  {
    bool crossed = u > 0.0 ? slope[i] < 0.0 && max(barycentric[i], 0.0) / -slope[i] == u : barycentric[i] == 0.0;
    if (crossed)
    {
      return faceScalars(tetrahedronGSOutput.x, i, scalarsGSOutput, opacityScalarsGSOutput, contourScalarsGSOutput, s);
    }
  }
  return s;
}

// Where the ray has a depth, as a parameter from the back face towards the eye.
float parameterAt(float depth)
{
  float towardsEye = eyeVC.z - eyeVC.w * positionVCGSOutput.z;
  return (zFromDepth(depth) - positionVCGSOutput.z) / towardsEye;
}

// Light of the part of the ray between two parameters; without haze in front of it, but where there are contours.
vec4 clearLightBetween(float uFront, float uBack, vec4 slope)
{
  // (colour, opacity)
  vec2 scalarAtFace = vec2(interpolate(barycentricGSOutput, scalarsGSOutput),
    interpolate(barycentricGSOutput, opacityScalarsGSOutput));
  vec2 scalarSlope = vec2(change(slope, scalarsGSOutput), change(slope, opacityScalarsGSOutput));
  vec3 towardsEye = eyeVC.xyz - eyeVC.w * positionVCGSOutput;
  float opticalScale = (uFront - uBack) * length(towardsEye) * extinctionScale;
  vec2 front = scalarAtFace + uFront * scalarSlope;
  vec2 back = scalarAtFace + uBack * scalarSlope;
  vec2 contourEnds = vec2(0.0);
  if (consistentFaces)
  {
    vec3 atFront = scalarsAt(uFront, barycentricGSOutput, slope);
    vec3 atBack = scalarsAt(uBack, barycentricGSOutput, slope);
    front = atFront.xy;
    back = atBack.xy;
    contourEnds = vec2(atFront.z, atBack.z);
  }
  if (useContours)
  {
    ContourSegment segment = ContourSegment(tetrahedronGSOutput.x, contourScalarsGSOutput, contourEnds,
      barycentricGSOutput + uFront * slope, barycentricGSOutput + uBack * slope,
      positionVCGSOutput + uFront * towardsEye, positionVCGSOutput + uBack * towardsEye);
    return integrateSegmentWithContours(front, back, opticalScale, segment, tetrahedronGSOutput.y);
  }
  if (useLayers)
  {
    selectLayer(tetrahedronGSOutput.y);
  }
  return integrateSegment(front, back, opticalScale);
}

vec4 lightBetween(float uFront, float uBack, vec4 slope)
{
  vec4 light = clearLightBetween(uFront, uBack, slope);
#ifdef NEPHOSCOPE_HAZE
  if (!useContours)
  {
    vec3 towardsEye = eyeVC.xyz - eyeVC.w * positionVCGSOutput;
    light = hazedSegment(light, positionVCGSOutput + uFront * towardsEye, positionVCGSOutput + uBack * towardsEye);
  }
#endif
  return light;
}

// What lies in front of the opaque geometry.
void drawWhole(float uFace, vec4 slope)
{
  float opaque = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  float uFront = min(uFace, parameterAt(0.0));
  float uBack = max(0.0, parameterAt(opaque));
  if (!(uFront > uBack))
  {
    discard;
  }
  gl_FragData[0] = lightBetween(uFront, uBack, slope);
}

// What lies in each of the two ranges.
void drawRanges(float uFace, vec4 slope)
{
  vec4 depths = texelFetch(depthRanges, ivec2(gl_FragCoord.xy), 0);
  vec2 uFront = min(vec2(uFace), vec2(parameterAt(depths.x), parameterAt(depths.z)));
  vec2 uBack = max(vec2(0.0), vec2(parameterAt(depths.y), parameterAt(depths.w)));
  bvec2 inside = greaterThan(uFront, uBack);
  if (!any(inside))
  {
    discard;
  }
  gl_FragData[0] = gl_FragData[1] = vec4(0.0);
  // A loop and not two calls: few cells lie in both ranges, and the second integral costs only where one does.
  int range = inside[0] ? 0 : 1;
  int last = inside[1] ? 1 : 0;
  do
  {
    vec4 light = lightBetween(uFront[range], uBack[range], slope);
    if (range == 0)
    {
      gl_FragData[0] = light;
    }
    else
    {
      gl_FragData[1] = light;
    }
    ++range;
  } while (range <= last);
}

void main()
{
  vec4 slope = eyeBarycentricGSOutput - eyeVC.w * barycentricGSOutput;
  float uFace = frontParameter(barycentricGSOutput, slope);
  // A back face that is seen edge-on may be too narrow for a rasteriser to interpolate over: then nothing is a number.
  if (!all(lessThan(abs(barycentricGSOutput), vec4(1.0e30))))
  {
    discard;
  }
  if (useDepthRanges)
  {
    drawRanges(uFace, slope);
  }
  else
  {
    drawWhole(uFace, slope);
  }
}
