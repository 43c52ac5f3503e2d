//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The back faces of one tetrahedron: each pixel that the tetrahedron covers is covered by exactly one of them.
//   in:  the number of the tetrahedron
//   out: per face, its corners in view coordinates (VC) and the vertex opposite;
//        per tetrahedron, its number, layer and scalars, and the coordinates q of the eye (TetrahedronRay.h)
//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Constants
//NEPHOSCOPE::TetrahedronInput
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

uniform mat4 VCDCMatrix;
uniform sampler2D tileRanges; // with depth ranges: nearest and farthest depth that is wanted in a tile of pixels
uniform vec2 tilesPerUnit;    // tiles per unit of device coordinates

flat in int tetrahedronVSOutput[];
flat out vec3 cornerAGSOutput;
flat out vec3 cornerBGSOutput;
flat out vec3 cornerCGSOutput;
flat out int oppositeGSOutput;
flat out vec4 eyeBarycentricGSOutput;
flat out vec4 scalarsGSOutput;
flat out vec4 opacityScalarsGSOutput;
flat out vec4 contourScalarsGSOutput;
flat out ivec2 tetrahedronGSOutput;

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
  contourScalarsGSOutput = thirdScalars;
  tetrahedronGSOutput = tetrahedronAndLayer;
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
  if (useDepthRanges && isOutsideRanges())
  {
    return;
  }
  emitBackFace(eyeBarycentric[0], ivec4(1, 2, 3, 0));
  emitBackFace(eyeBarycentric[1], ivec4(0, 2, 3, 1));
  emitBackFace(eyeBarycentric[2], ivec4(0, 1, 3, 2));
  emitBackFace(eyeBarycentric[3], ivec4(0, 1, 2, 3));
}
