//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices of the mesh's boundary.
//   in:  number of the point, as vertex number
//   out: distance from the eye's plane
uniform samplerBuffer points; // position, scalar
uniform mat4 MCVCMatrix;
uniform mat4 VCDCMatrix;
uniform vec2 depthRange; // distances that become 0 and 1

out float depthVSOutput;

void main()
{
  vec4 positionVC = MCVCMatrix * vec4(texelFetch(points, gl_VertexID).xyz, 1.0);
  depthVSOutput = (-positionVC.z - depthRange.x) / (depthRange.y - depthRange.x);
  gl_Position = VCDCMatrix * positionVC;
}
