//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The back faces of one tetrahedron: each pixel that the tetrahedron covers is covered by exactly one of them.
//   in:  the number of the tetrahedron
//   out: per vertex, barycentric coordinates and position in view coordinates (VC);
//        per tetrahedron, its scalars and the coordinates q of the eye (TetrahedronRay.h)
// Positions in the buffers are model coordinates (MC) less the centre of the data.
//NEPHOSCOPE::Constants
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

uniform isamplerBuffer tetrahedra; // four point numbers
uniform samplerBuffer points;      // position, scalar
uniform samplerBuffer cellScalars;
uniform samplerBuffer opacityScalars; // where opacity comes from another array than colour
uniform vec4 eyeMC; // w = 1; or the direction towards the eye, w = 0, in a parallel projection
uniform mat4 MCVCMatrix;
uniform mat4 VCDCMatrix;
uniform sampler2D tileRanges; // with depth ranges: nearest and farthest depth that is wanted in a tile of pixels
uniform vec2 tilesPerUnit;    // tiles per unit of device coordinates

flat in int tetrahedronVSOutput[];
out vec4 barycentricGSOutput;
out vec3 positionVCGSOutput;
flat out vec4 eyeBarycentricGSOutput;
flat out vec4 scalarsGSOutput;
flat out vec4 opacityScalarsGSOutput;

vec3 positionMC[4];
vec4 positionVC[4];
vec4 positionDC[4];
vec4 eyeBarycentric = vec4(0.0);
vec4 scalars = vec4(0.0);
vec4 secondScalars = vec4(0.0);

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
  gl_Position = positionDC[i];
  EmitVertex();
}

// Whether the tetrahedron certainly lies outside the depth ranges of all pixels that it covers.
bool isOutsideRanges()
{
  const float margin = 1.0e-5;  // more than float arithmetic errs in depth
  const int largest = 4;        // tiles: larger tetrahedra are not worth the search
  vec3 low = vec3(3.0e38);
  vec3 high = vec3(-3.0e38);
  for (int i = 0; i < 4; ++i)
  {
    if (positionDC[i].w <= 0.0)
    {
      return false; // behind the eye
    }
    vec3 position = positionDC[i].xyz / positionDC[i].w;
    low = min(low, position);
    high = max(high, position);
  }
  vec2 depths = 0.5 + 0.5 * vec2(low.z, high.z);
  ivec2 limit = textureSize(tileRanges, 0) - 1;
  ivec2 first = ivec2(clamp((low.xy + 1.0) * tilesPerUnit - 0.01, vec2(0.0), vec2(limit)));
  ivec2 last = ivec2(clamp((high.xy + 1.0) * tilesPerUnit + 0.01, vec2(0.0), vec2(limit)));
  if (any(greaterThanEqual(last - first, ivec2(largest))))
  {
    return false;
  }
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      vec2 range = texelFetch(tileRanges, ivec2(x, y), 0).xy;
      if (depths[0] < range.y + margin && depths[1] > range.x - margin)
      {
        return false;
      }
    }
  }
  return true;
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
    positionDC[i] = VCDCMatrix * positionVC[i];
    scalars[i] = point.w;
    secondScalars[i] = separateOpacity ? texelFetch(opacityScalars, opacityOnCells ? tetrahedron : ids[i]).r : 0.0;
  }
  if (useDepthRanges && isOutsideRanges())
  {
    return;
  }
  if (useCellScalars)
  {
    scalars = vec4(texelFetch(cellScalars, tetrahedron).r);
  }
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
