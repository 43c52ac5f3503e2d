//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Of the boundary faces through which a pixel's ray enters the mesh, the next one behind the last.
//   out: number of the face, depth; the depth test keeps the nearest, and the lowest number of those at one depth: where parts of the
//        mesh overlap, their faces may lie in the same place
uniform sampler2D lastEntries;

in float depthVSOutput;

void main()
{
  vec2 last = texelFetch(lastEntries, ivec2(gl_FragCoord.xy), 0).rg;
  float number = float(gl_PrimitiveID);
  if (depthVSOutput < last.y || (depthVSOutput == last.y && number <= last.x))
  {
    discard;
  }
  gl_FragData[0] = vec4(number, depthVSOutput, 0.0, 0.0);
  gl_FragDepth = depthVSOutput;
}
