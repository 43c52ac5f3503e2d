// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks at all faces behind the pixel, as SurfaceLists.frag.glsl has written them; headOfPixel and nodeAt read their images.
const uint cloudColumns = uint(//NEPHOSCOPE::Columns
);

ivec2 placeOfNode(uint node)
{
  return ivec2((node - 1u) % cloudColumns, (node - 1u) / cloudColumns);
}

void considerLayers(ivec2 pixel)
{
  uint node = cloudDrawings > 0 ? headOfPixel(pixel) : 0u;
  while (node != 0u)
  {
    vec4 face = nodeAt(placeOfNode(node));
    bool isFront = face.y > 0.5;
    considerSame(face.x, isFront, face.z);
    if (isFront)
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
