//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The back faces of one tetrahedron: each pixel that the tetrahedron covers is covered by exactly one of them.
//   in:  the number of the tetrahedron
//   out: per vertex, barycentric coordinates and position in view coordinates (VC);
//        per tetrahedron, its number, layer and scalars, and the coordinates q of the eye (TetrahedronRay.h)
//NEPHOSCOPE::Constants
//NEPHOSCOPE::TetrahedronInput
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

uniform mat4 VCDCMatrix;

flat in int tetrahedronVSOutput[];
out vec4 barycentricGSOutput;
out vec3 positionVCGSOutput;
flat out vec4 eyeBarycentricGSOutput;
flat out vec4 scalarsGSOutput;
flat out vec4 opacityScalarsGSOutput;
flat out vec4 contourScalarsGSOutput;
flat out ivec2 tetrahedronGSOutput;

void emitVertex(int i)
{
  barycentricGSOutput = vec4(equal(ivec4(i), ivec4(0, 1, 2, 3)));
  positionVCGSOutput = positionVC[i].xyz;
  eyeBarycentricGSOutput = eyeBarycentric;
  scalarsGSOutput = scalars;
  opacityScalarsGSOutput = secondScalars;
  contourScalarsGSOutput = thirdScalars;
  tetrahedronGSOutput = tetrahedronAndLayer;
  gl_Position = VCDCMatrix * positionVC[i];
  EmitVertex();
}

void emitBackFace(float q, int a, int b, int c)
{
  if (q > 0.0)
  {
    emitVertex(a);
    emitVertex(b);
    emitVertex(c);
    EndPrimitive();
  }
}

void main()
{
  if (!readTetrahedron(tetrahedronVSOutput[0]))
  {
    return;
  }
  emitBackFace(eyeBarycentric[0], 1, 2, 3);
  emitBackFace(eyeBarycentric[1], 0, 2, 3);
  emitBackFace(eyeBarycentric[2], 0, 1, 3);
  emitBackFace(eyeBarycentric[3], 0, 1, 2);
}
