//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface for its layers: positions, depths from the eye and densities only. Constant: hasDensity.
//NEPHOSCOPE::Constants
in vec4 vertexMC;
in vec3 cloudPlace;
in float cloudDensity;
uniform mat4 MCDCMatrix;
uniform mat4 placeToView;
out float depthVSOutput;
out float densityVSOutput;

void main()
{
  gl_Position = MCDCMatrix * vertexMC;
  depthVSOutput = -(placeToView * vec4(cloudPlace, 1.0)).z;
  densityVSOutput = hasDensity ? cloudDensity : 1.0;
}
