//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The back faces of one tetrahedron: each pixel that the tetrahedron covers is covered by exactly one of them.
//   in:  the number of the tetrahedron
//   out: per face, its corners in view coordinates (VC) and the vertex opposite;
//        per tetrahedron, its layer and scalars, and the coordinates q of the eye (TetrahedronRay.h)
//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Constants
//NEPHOSCOPE::TetrahedronInput
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

uniform mat4 VCDCMatrix;

flat in int tetrahedronVSOutput[];
flat out vec3 cornerAGSOutput;
flat out vec3 cornerBGSOutput;
flat out vec3 cornerCGSOutput;
flat out int oppositeGSOutput;
flat out vec4 eyeBarycentricGSOutput;
flat out vec4 scalarsGSOutput;
flat out vec4 opacityScalarsGSOutput;
flat out int layerGSOutput;

vec4 positionDC[4];

void emitVertex(int i, ivec4 face)
{
  cornerAGSOutput = positionVC[face.x].xyz;
  cornerBGSOutput = positionVC[face.y].xyz;
  cornerCGSOutput = positionVC[face.z].xyz;
  oppositeGSOutput = face.w;
  eyeBarycentricGSOutput = eyeBarycentric;
  scalarsGSOutput = scalars;
  opacityScalarsGSOutput = secondScalars;
  layerGSOutput = layer;
  gl_Position = positionDC[i];
  EmitVertex();
}

// Three corners, and the vertex opposite.
void emitBackFace(float q, ivec4 face)
{
  if (q > 0.0)
  {
    emitVertex(face.x, face);
    emitVertex(face.y, face);
    emitVertex(face.z, face);
    EndPrimitive();
  }
}

void main()
{
  if (!readTetrahedron(tetrahedronVSOutput[0]))
  {
    return;
  }
  for (int i = 0; i < 4; ++i)
  {
    positionDC[i] = VCDCMatrix * positionVC[i];
  }
  emitBackFace(eyeBarycentric[0], ivec4(1, 2, 3, 0));
  emitBackFace(eyeBarycentric[1], ivec4(0, 2, 3, 1));
  emitBackFace(eyeBarycentric[2], ivec4(0, 1, 3, 2));
  emitBackFace(eyeBarycentric[3], ivec4(0, 1, 2, 3));
}
