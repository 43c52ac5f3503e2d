// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#version 150
#extension GL_ARB_shader_image_load_store : require
#extension GL_ARB_shading_language_420pack : require
// Replaces the densities in the lists of faces by optical depths along the way through a density volume. Here each pixel's rays are walked
// once: the surface's own triangles are often smaller than the blocks of pixels that processors run together, and peels draw them many times.
//   in:  heads and nodes, as SurfaceLists.frag.glsl has written them
//   out: nodes, with the optical depth of the cloud that starts at the face, noThickness where nothing ends it
layout(binding = 0, r32ui) uniform readonly uimage2D heads;
layout(binding = 1, rgba32f) uniform image2D nodes;
uniform mat4 deviceToView;
in vec2 texCoord;

#define headOfPixel(pixel) imageLoad(heads, pixel).r
#define nodeAt(place) imageLoad(nodes, place)
//NEPHOSCOPE::Constants
//NEPHOSCOPE::Thickness

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 near = deviceToView * vec4(2.0 * texCoord - 1.0, -1.0, 1.0);
  uint node = headOfPixel(pixel);
  while (node != 0u)
  {
    ivec2 place = placeOfNode(node);
    vec4 face = nodeAt(place);
    bool isFront = face.y > 0.5;
    vec3 view = placeOnRay(near.xyz / near.w, face.x);
    if (findCloud(view, 1.0, isFront))
    {
      face.z = cloudDepth(view, 1.0, isFront, true, noThickness);
      imageStore(nodes, place, face);
    }
    node = uint(face.w);
  }
}
