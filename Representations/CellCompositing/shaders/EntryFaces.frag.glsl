//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The next boundary face, behind the last one, through which a pixel's ray enters the mesh.
//   out: number of the face, depth; the depth test keeps the nearest, and the lowest number of those at one depth: where parts of the
//        mesh overlap, their faces may lie in the same place
//        Those behind the opaque geometry are left out, and where only a slice of the depths is looked through, those outside.
//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
uniform sampler2D lastEntries;
uniform int isSliced;
uniform vec2 slice;              // depths from, and up to
uniform sampler2D passedEntries; // last ones before the slices
uniform vec2 depthRange;         // distances from the eye's plane that are depths 0 and 1
uniform sampler2D depthRanges;   // where VTK peels surfaces: near and far depth of two ranges, empty where near >= far
uniform int rangeNumber;         // the one to draw
uniform sampler2D pixelOwners;   // RayOwners.frag.glsl
uniform float owner;             // whose pixels are drawn

in float depthVSOutput;
flat in float faceVSOutput;

bool isPassed(vec2 last)
{
  return depthVSOutput < last.y || (depthVSOutput == last.y && faceVSOutput <= last.x);
}

// Nothing can be seen from there on.
bool isHidden(ivec2 pixel)
{
  float end;
  if (useDepthRanges)
  {
    vec4 ranges = texelFetch(depthRanges, pixel, 0);
    vec2 depths = rangeNumber == 0 ? ranges.xy : ranges.zw;
    if (depths.x >= depths.y)
    {
      return true;
    }
    end = depths.y;
  }
  else
  {
    end = texelFetch(opaqueDepth, pixel, 0).r;
  }
  return -mix(depthRange.x, depthRange.y, depthVSOutput) < zFromDepth(end);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (hasOwners && texelFetch(pixelOwners, pixel, 0).r != owner)
  {
    discard;
  }
  if (isPassed(texelFetch(lastEntries, pixel, 0).rg) || isHidden(pixel))
  {
    discard;
  }
  if (isSliced != 0 &&
    (depthVSOutput < slice.x || depthVSOutput >= slice.y || isPassed(texelFetch(passedEntries, pixel, 0).rg)))
  {
    discard;
  }
  gl_FragData[0] = vec4(faceVSOutput, depthVSOutput, 0.0, 0.0);
  gl_FragDepth = depthVSOutput;
}
