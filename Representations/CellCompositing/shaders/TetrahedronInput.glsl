// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a geometry shader reads of one tetrahedron. Positions in the buffers are model coordinates (MC) less the centre of the data.
// Constants: useCellScalars, separateOpacity, opacityOnCells, useLayers, contourLayers.
uniform IntegerArray tetrahedra; // four point numbers
uniform FloatArray points;      // position, scalar
uniform FloatArray cellScalars;
uniform FloatArray opacityScalars; // where opacity comes from another array than colour
uniform IntegerArray tetrahedronLayers;
uniform vec4 eyeMC; // w = 1; or the direction towards the eye, w = 0, in a parallel projection
uniform mat4 MCVCMatrix;

vec4 positionVC[4];
vec4 eyeBarycentric = vec4(0.0); // coordinates q of the eye (TetrahedronRay.h)
vec4 scalars = vec4(0.0);
vec4 secondScalars = vec4(0.0); // for opacity
int layer = 0;

// q of the vertex v opposite face (a, b, c)
float eyeCoordinate(vec3 v, vec3 a, vec3 b, vec3 c)
{
  vec3 normal = cross(b - a, c - a);
  return dot(normal, eyeMC.xyz - eyeMC.w * a) / dot(normal, v - a);
}

// False: no volume in float arithmetic.
bool readTetrahedron(int tetrahedron)
{
  vec3 positionMC[4];
  ivec4 ids = element(tetrahedra, tetrahedron);
  for (int i = 0; i < 4; ++i)
  {
    vec4 point = element(points, ids[i]);
    positionMC[i] = point.xyz;
    positionVC[i] = MCVCMatrix * vec4(point.xyz, 1.0);
    scalars[i] = point.w;
    secondScalars[i] = separateOpacity ? element(opacityScalars, opacityOnCells ? tetrahedron : ids[i]).r : 0.0;
  }
  if (useCellScalars)
  {
    scalars = vec4(element(cellScalars, tetrahedron).r);
  }
  layer = useLayers && !contourLayers ? element(tetrahedronLayers, tetrahedron).r : 0;
  vec3 a = positionMC[0], b = positionMC[1], c = positionMC[2], d = positionMC[3];
  eyeBarycentric = vec4(eyeCoordinate(a, b, c, d), eyeCoordinate(b, a, c, d), eyeCoordinate(c, a, b, d),
    eyeCoordinate(d, a, b, c));
  return !any(isnan(eyeBarycentric)) && !any(isinf(eyeBarycentric));
}
