// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The first that the shader of a pixel does. Returns the boundary face through which the ray enters; ends pixels without a ray to draw.
//NEPHOSCOPE::FaceNumber
ivec4 startPixel()
{
  keepSteps();
  float entry = texelFetch(entryFaces, ivec2(gl_FragCoord.xy), 0).r;
  if (startsAtEye == 0 && entry < 0.0)
  {
    discard;
  }
  if (useDepthRanges)
  {
    vec2 depths = visibleDepths();
    if (depths.x >= depths.y)
    {
      discard;
    }
  }
  keepUniforms();
  return element(boundaryFaces, max(faceOfFloat(entry), 0));
}
