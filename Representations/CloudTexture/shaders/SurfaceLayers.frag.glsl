//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest and the farthest faces of a surface that lie between those found before; drawn with GL_MAX.
//   in:  depth from the eye along the view, and which way the face looks; depths found before
//   out: minus the depth of the nearest front and back face, depth of the farthest front and back face
// With densities, hidden back faces count as nearest, until the first of them is found. Their second drawing gives the densities
// at the back faces that were found.
// Constant: hasDensity.
//NEPHOSCOPE::Constants
uniform sampler2D foundBefore;
uniform sampler2D opaqueDepth;
uniform int stage;        // 0: the first drawing; 1: the others; 2: densities
uniform int frontIsFront; // 0: the picture is mirrored, or the surface inside out
uniform vec4 depthToView; // z = (x + y e) / (z + w e), e = 1 - depth
in float depthVSOutput;
in float densityVSOutput;

const float noLayer = -1.0e30;

float opaqueDepthHere(ivec2 pixel)
{
  float e = 1.0 - texelFetch(opaqueDepth, pixel, 0).r;
  return e > 0.0 ? -(depthToView.x + depthToView.y * e) / (depthToView.z + depthToView.w * e) : 1.0e30;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool isFront = gl_FrontFacing == (frontIsFront != 0);
  float depth = depthVSOutput;
  bool isHidden = hasDensity && depth >= opaqueDepthHere(pixel);
  vec4 found = stage > 0 ? texelFetch(foundBefore, pixel, 0) : vec4(0.0);
  vec2 mine = isFront ? found.xz : found.yw;
  if (stage == 2)
  {
    if (isFront || (depth != -mine.x && depth != mine.y))
    {
      discard;
    }
    gl_FragData[0] = vec4(0.0, depth == -mine.x ? densityVSOutput : 0.0, 0.0, depth == mine.y ? densityVSOutput : 0.0);
    return;
  }
  bool isBetween = stage == 0 || (depth > -mine.x && depth < mine.y);
  if (isHidden)
  {
    isBetween = !isFront && (stage == 0 || (mine.x > noLayer && -mine.x < opaqueDepthHere(pixel)));
  }
  if (!isBetween)
  {
    discard;
  }
  float farthest = isHidden ? noLayer : depth;
  gl_FragData[0] = isFront ? vec4(-depth, noLayer, depth, noLayer) : vec4(noLayer, -depth, noLayer, farthest);
}
