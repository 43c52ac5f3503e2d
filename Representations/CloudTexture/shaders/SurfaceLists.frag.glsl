// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#version 150
#extension GL_ARB_shader_image_load_store : require
#extension GL_ARB_shading_language_420pack : require
// All faces of a surface behind every pixel, in lists. No order: the shader that reads them looks at all.
//   in:  depth from the eye along the view, density, which way the face looks
//   out: nodes: depth, 1 where the face looks to the eye, density, number of the next node, 0 where there is none
//        heads: number of each pixel's first node, counted from 1; in the row above them, the number of all
layout(early_fragment_tests) in;
layout(binding = 0, r32ui) uniform uimage2D heads;
layout(binding = 1, rgba32f) uniform writeonly image2D nodes;
uniform int nodesInRow;
uniform int rowsOfNodes;
uniform int rowOfNumber;  // of the image of heads
uniform int frontIsFront; // 0: the picture is mirrored, or the surface inside out
in float depthVSOutput;
in float densityVSOutput;

void main()
{
  int node = int(imageAtomicAdd(heads, ivec2(0, rowOfNumber), 1u));
  if (node < nodesInRow * rowsOfNodes)
  {
    uint next = imageAtomicExchange(heads, ivec2(gl_FragCoord.xy), uint(node + 1));
    float isFront = gl_FrontFacing == (frontIsFront != 0) ? 1.0 : 0.0;
    imageStore(nodes, ivec2(node % nodesInRow, node / nodesInRow), vec4(depthVSOutput, isFront, densityVSOutput, float(next)));
  }
}
