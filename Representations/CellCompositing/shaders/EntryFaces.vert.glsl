//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices of the mesh's boundary.
//   in:  number of the point, number of the face
//   out: number of the face, distance from the eye's plane
// Not every driver gives gl_PrimitiveID to a fragment shader without a geometry shader: the face comes with its vertices.
//NEPHOSCOPE::Arrays
//NEPHOSCOPE::FaceNumber
in ivec2 pointAndFace;
uniform FloatArray points; // position, scalar
uniform mat4 MCVCMatrix;
uniform mat4 VCDCMatrix;
uniform vec2 depthRange; // distances that become 0 and 1

out float depthVSOutput;
flat out float faceVSOutput;

void main()
{
  vec4 positionVC = MCVCMatrix * vec4(element(points, pointAndFace.x).xyz, 1.0);
  faceVSOutput = floatOfFace(pointAndFace.y);
  depthVSOutput = (-positionVC.z - depthRange.x) / (depthRange.y - depthRange.x);
  gl_Position = VCDCMatrix * positionVC;
}
