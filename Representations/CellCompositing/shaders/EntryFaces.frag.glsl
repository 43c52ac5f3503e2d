//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Of the boundary faces through which a pixel's ray enters the mesh, the next one behind the last.
//   out: number of the face, depth; the depth test keeps the nearest
uniform sampler2D lastEntries;

in float depthVSOutput;

void main()
{
  float last = texelFetch(lastEntries, ivec2(gl_FragCoord.xy), 0).g;
  if (depthVSOutput <= last)
  {
    discard;
  }
  gl_FragData[0] = vec4(float(gl_PrimitiveID), depthVSOutput, 0.0, 0.0);
  gl_FragDepth = depthVSOutput;
}
