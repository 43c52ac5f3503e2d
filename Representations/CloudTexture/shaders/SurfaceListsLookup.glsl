// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks at all faces behind the pixel, as SurfaceLists.frag.glsl has written them.
uniform usampler2D cloudHeads;
uniform sampler2D cloudNodes;

const uint cloudColumns = uint(//NEPHOSCOPE::Columns
);

void considerLayers(ivec2 pixel)
{
  uint node = cloudDrawings > 0 ? texelFetch(cloudHeads, pixel, 0).r : 0u;
  while (node != 0u)
  {
    vec4 face = texelFetch(cloudNodes, ivec2((node - 1u) % cloudColumns, (node - 1u) / cloudColumns), 0);
    if (face.y > 0.5)
    {
      cloudHasFrontBefore = cloudHasFrontBefore || face.x < cloudDepthHere;
    }
    else
    {
      considerBack(face.x, face.z);
    }
    node = uint(face.w);
  }
}
