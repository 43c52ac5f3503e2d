//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one tetrahedron adds to one pixel, from the fan around its thick vertex: premultiplied colour and alpha.
//   linearOpacity: colour and opacity as interpolated from the corners of the triangle (ShirleyTuchman1990);
//   else:          mean colour of front and back, opacity 1 - exp(-u) from the table (SteinBeckerMax1994)
// The segment is cut at the near plane and at the opaque geometry.
uniform vec4 eyeVC; // (position, 1) or (direction towards the eye, 0)

in vec2 depthGSOutput;
in vec2 slopeGSOutput;
in vec4 frontGSOutput;
in vec4 backGSOutput;

//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpacityTable

void main()
{
  bool perspective = eyeVC.w > 0.0;
  float inverseFront = perspective ? depthGSOutput.x : 1.0;
  float inverseBack = perspective ? depthGSOutput.x - depthGSOutput.y : 1.0;
  float zFront = perspective ? 1.0 / inverseFront : depthGSOutput.x;
  float zDifference = depthGSOutput.y / (inverseFront * inverseBack);
  float stretch = perspective ? sqrt(1.0 + dot(slopeGSOutput, slopeGSOutput)) : length(eyeVC.xyz) / abs(eyeVC.z);

  float opaque = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  vec2 limits = eyeVC.w * eyeVC.z - vec2(zFromDepth(0.0), zFromDepth(opaque));
  vec2 visible = clamp((limits - zFront) / zDifference, 0.0, 1.0); // from front (0) to back (1)
  float share = visible.y - visible.x;
  // A triangle that is seen edge-on may be too narrow for a rasteriser to interpolate over: then nothing is a number.
  bool interpolated = all(lessThan(abs(frontGSOutput), vec4(1.0e30))) && all(lessThan(abs(backGSOutput), vec4(1.0e30)));
  if (!(share > 0.0) || !interpolated)
  {
    discard;
  }
  if (linearOpacity)
  {
    vec4 value = clamp(frontGSOutput, 0.0, 1.0); // over narrow triangles interpolation becomes extrapolation
    float alpha = share < 1.0 ? 1.0 - pow(1.0 - value.a, share) : value.a;
    gl_FragData[0] = vec4(value.rgb * alpha, alpha);
    return;
  }
  vec4 front = frontGSOutput / inverseFront, back = backGSOutput / inverseBack;
  vec4 mean = mix(front, back, 0.5 * (visible.x + visible.y));
  float alpha = lookUpOpacity(mean.a * share * zDifference * stretch);
  gl_FragData[0] = vec4(max(mean.rgb, 0.0) * alpha, alpha);
}
