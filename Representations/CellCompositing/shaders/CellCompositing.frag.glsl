//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one tetrahedron adds to one pixel: premultiplied colour and alpha.
//   in:  a point of the back face (barycentric coordinates and view coordinates), the eye's coordinates q, scalars
//   out: integral of emission and extinction between the front face and the back face, clipped to what lies
//        between the near plane and the opaque geometry
// u runs from the back face (0) towards the eye: a fraction of that way in perspective, a length in a parallel projection.
uniform vec4 eyeVC;            // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1

in vec4 barycentricGSOutput;
in vec3 positionVCGSOutput;
flat in vec4 eyeBarycentricGSOutput;
flat in vec4 scalarsGSOutput;
flat in vec4 opacityScalarsGSOutput;

//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction

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

void main()
{
  vec3 towardsEye = eyeVC.xyz - eyeVC.w * positionVCGSOutput;
  vec4 slope = eyeBarycentricGSOutput - eyeVC.w * barycentricGSOutput;

  float opaque = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  float uNear = (zFromDepth(0.0) - positionVCGSOutput.z) / towardsEye.z;
  float uOpaque = (zFromDepth(opaque) - positionVCGSOutput.z) / towardsEye.z;
  float uFront = min(frontParameter(barycentricGSOutput, slope), uNear);
  float uBack = max(0.0, uOpaque);
  // A back face that is seen edge-on may be too narrow for a rasteriser to interpolate over: then nothing is a number.
  bool interpolated = all(lessThan(abs(barycentricGSOutput), vec4(1.0e30)));
  if (!(uFront > uBack) || !interpolated)
  {
    discard;
  }
  // (colour, opacity)
  vec2 scalarAtFace = vec2(interpolate(barycentricGSOutput, scalarsGSOutput),
    interpolate(barycentricGSOutput, opacityScalarsGSOutput));
  vec2 scalarSlope = vec2(change(slope, scalarsGSOutput), change(slope, opacityScalarsGSOutput));
  float opticalScale = (uFront - uBack) * length(towardsEye) * extinctionScale;
  gl_FragData[0] = integrateSegment(
    scalarAtFace + uFront * scalarSlope, scalarAtFace + uBack * scalarSlope, opticalScale);
}
