//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The back faces of one tetrahedron: each pixel that the tetrahedron covers is covered by exactly one of them.
//   in:  the number of the tetrahedron
//   out: per vertex, barycentric coordinates and position in view coordinates (VC);
//        per tetrahedron, its number, layer and scalars, and the coordinates q of the eye (TetrahedronRay.h)
// Positions in the buffers are model coordinates (MC) less the centre of the data.
//NEPHOSCOPE::Constants
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

uniform isamplerBuffer tetrahedra; // four point numbers
uniform samplerBuffer points;      // position, scalar
uniform samplerBuffer cellScalars;
uniform samplerBuffer opacityScalars; // where opacity comes from another array than colour
uniform samplerBuffer contourScalars; // where contours are of another array than colour
uniform isamplerBuffer tetrahedronLayers;
uniform vec4 eyeMC; // w = 1; or the direction towards the eye, w = 0, in a parallel projection
uniform mat4 MCVCMatrix;
uniform mat4 VCDCMatrix;

flat in int tetrahedronVSOutput[];
out vec4 barycentricGSOutput;
out vec3 positionVCGSOutput;
flat out vec4 eyeBarycentricGSOutput;
flat out vec4 scalarsGSOutput;
flat out vec4 opacityScalarsGSOutput;
flat out vec4 contourScalarsGSOutput;
flat out ivec2 tetrahedronGSOutput;

vec3 positionMC[4];
vec4 positionVC[4];
vec4 eyeBarycentric = vec4(0.0);
vec4 scalars = vec4(0.0);
vec4 secondScalars = vec4(0.0);
vec4 thirdScalars = vec4(0.0);
ivec2 tetrahedronAndLayer = ivec2(0);

// q of the vertex v opposite face (a, b, c)
float eyeCoordinate(vec3 v, vec3 a, vec3 b, vec3 c)
{
  vec3 normal = cross(b - a, c - a);
  return dot(normal, eyeMC.xyz - eyeMC.w * a) / dot(normal, v - a);
}

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
  int tetrahedron = tetrahedronVSOutput[0];
  ivec4 ids = texelFetch(tetrahedra, tetrahedron);
  for (int i = 0; i < 4; ++i)
  {
    vec4 point = texelFetch(points, ids[i]);
    positionMC[i] = point.xyz;
    positionVC[i] = MCVCMatrix * vec4(point.xyz, 1.0);
    scalars[i] = point.w;
    secondScalars[i] = separateOpacity ? texelFetch(opacityScalars, opacityOnCells ? tetrahedron : ids[i]).r : 0.0;
    thirdScalars[i] = useContours && !contourOfColor ? texelFetch(contourScalars, ids[i]).r : 0.0;
  }
  if (useCellScalars)
  {
    scalars = vec4(texelFetch(cellScalars, tetrahedron).r);
  }
  if (useContours)
  {
    thirdScalars = contourOfColor ? scalars : thirdScalars;
    thirdScalars = any(isnan(thirdScalars)) ? vec4(0.0) : thirdScalars; // no surface where a value is missing
  }
  tetrahedronAndLayer = ivec2(tetrahedron, useLayers && !contourLayers ? texelFetch(tetrahedronLayers, tetrahedron).r : 0);
  vec3 a = positionMC[0], b = positionMC[1], c = positionMC[2], d = positionMC[3];
  eyeBarycentric = vec4(eyeCoordinate(a, b, c, d), eyeCoordinate(b, a, c, d), eyeCoordinate(c, a, b, d),
    eyeCoordinate(d, a, b, c));
  if (any(isnan(eyeBarycentric)) || any(isinf(eyeBarycentric)))
  {
    return; // no volume in float arithmetic
  }
  emitBackFace(eyeBarycentric[0], 1, 2, 3);
  emitBackFace(eyeBarycentric[1], 0, 2, 3);
  emitBackFace(eyeBarycentric[2], 0, 1, 3);
  emitBackFace(eyeBarycentric[3], 0, 1, 2);
}
