// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#version 150
#extension GL_ARB_shader_image_load_store : require
#extension GL_ARB_shading_language_420pack : require
// Replaces the densities in the lists of faces by optical depths along the way through a density volume, once per picture: the surface's own triangles are often smaller than the blocks of pixels that processors run together, and peels draw them many times.
// One face of each list and one part of its way in a drawing: Mesa ends every loop of a shader when they have made 65,535 iterations in all.
//   in:  heads and nodes, as SurfaceLists.frag.glsl has written them
//   out: nodes, with the optical depth of the cloud that starts at the face; noThickness if none starts there, or nothing ends it
//        heads: in the first row above the number of nodes, the length of the longest list; in the next, `parts` if a loop was ended in a way
layout(binding = 0, r32ui) uniform uimage2D heads;
layout(binding = 1, rgba32f) uniform image2D nodes;
uniform mat4 deviceToView;
uniform int face; // in its list, from 0
uniform int part; // of the way, which has this many:
uniform int parts;
uniform int rowOfNumber;
in vec2 texCoord;

#define headOfPixel(pixel) imageLoad(heads, pixel).r
#define nodeAt(place) imageLoad(nodes, place)
//NEPHOSCOPE::Constants
//NEPHOSCOPE::Thickness

void measureList(uint node)
{
  uint length = 0u;
  for (; node != 0u; node = uint(nodeAt(placeOfNode(node)).w))
  {
    ++length;
  }
  ivec2 longest = ivec2(0, rowOfNumber + 1);
  if (length > imageLoad(heads, longest).r)
  {
    imageAtomicMax(heads, longest, length);
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint node = headOfPixel(pixel);
  if (face == 0 && part == 0)
  {
    measureList(node);
  }
  for (int i = 0; i < face && node != 0u; ++i)
  {
    node = uint(nodeAt(placeOfNode(node)).w);
  }
  if (node == 0u)
  {
    discard;
  }
  ivec2 place = placeOfNode(node);
  vec4 start = nodeAt(place);
  bool isFront = start.y > 0.5;
  vec4 near = deviceToView * vec4(2.0 * texCoord - 1.0, -1.0, 1.0);
  vec3 view = placeOnRay(near.xyz / near.w, start.x);
  float before = part > 0 ? start.z : 0.0;
  if (before < cloudEnough)
  {
    bool starts = findCloud(view, 1.0, isFront) && cloudEnds.y < noThickness;
    cloudEnds = starts ? mix(cloudEnds.xx, cloudEnds.yy, vec2(part, part + 1) / float(parts)) : vec2(noThickness);
    start.z = before + cloudDepth(view, 1.0, isFront, true, noThickness);
    imageStore(nodes, place, start);
    if (cloudIsCut)
    {
      imageStore(heads, ivec2(0, rowOfNumber + 2), uvec4(parts));
    }
  }
}
