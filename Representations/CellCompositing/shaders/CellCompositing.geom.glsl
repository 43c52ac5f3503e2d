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
uniform sampler2D tileRanges; // with depth ranges: nearest and farthest depth that is wanted in a tile of pixels
uniform vec2 tilesPerUnit;    // tiles per unit of device coordinates

flat in int tetrahedronVSOutput[];
out vec4 barycentricGSOutput;
out vec3 positionVCGSOutput;
flat out vec4 eyeBarycentricGSOutput;
flat out vec4 scalarsGSOutput;
flat out vec4 opacityScalarsGSOutput;
flat out vec4 contourScalarsGSOutput;
flat out ivec2 tetrahedronGSOutput;

vec4 positionDC[4];

void emitVertex(int i)
{
  barycentricGSOutput = vec4(equal(ivec4(i), ivec4(0, 1, 2, 3)));
  positionVCGSOutput = positionVC[i].xyz;
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
  for (int i = 0; i < 4; ++i)
  {
    positionDC[i] = VCDCMatrix * positionVC[i];
  }
  if (useDepthRanges && isOutsideRanges())
  {
    return;
  }
  emitBackFace(eyeBarycentric[0], 1, 2, 3);
  emitBackFace(eyeBarycentric[1], 0, 2, 3);
  emitBackFace(eyeBarycentric[2], 0, 1, 3);
  emitBackFace(eyeBarycentric[3], 0, 1, 2);
}
