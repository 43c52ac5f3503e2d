//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Hands the light of a peel's depth ranges back to the peeling pass, over what another volume has already put there.
//   in:  the light of the first and the second range, premultiplied (see PeelRanges); the draw targets as they are
//   out: the new content of the draw targets, to replace the old
// Target 0 holds light of the back; target 1, where there is one, all in front of the peel.
uniform sampler2D firstLight;
uniform sampler2D secondLight;
uniform sampler2D oldBack;
uniform sampler2D oldFront;
uniform vec2 in_inverseWindowSize;
const float g_opacityThreshold = 2.0;

//VTK::DepthPeeling::Dec

const float smallestAlpha = 1.0 / 255.0; // that the targets hold
int calls = 0;
float lastFar = 0.0;
bool dark = true; // cast rays that meet nothing

void initializeRayCast() {}

vec4 castRay(float nearDepth, float farDepth)
{
  ++calls;
  lastFar = farDepth;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  return dark ? vec4(0.0) : calls == 1 ? texelFetch(firstLight, pixel, 0) : texelFetch(secondLight, pixel, 0);
}

void peel()
{
//VTK::CallWorker::Impl
}

vec4 over(vec4 upper, vec4 lower)
{
  return upper + (1.0 - upper.a) * lower;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  gl_FragData[0] = gl_FragData[1] = vec4(0.0);
  peel();
  vec4 before = gl_FragData[1]; // all in front of this range
  dark = false;
  calls = 0;
  peel();

  gl_FragData[0] = over(gl_FragData[0], texelFetch(oldBack, pixel, 0));
//NEPHOSCOPE::KeepPeeling
  // before + (1 - before.a) light is what the pass made. Light that another volume has put between the two stays there.
  float transparency = 1.0 - before.a;
  float lightTransparency = transparency > 0.0 ? (1.0 - gl_FragData[1].a) / transparency : 1.0;
  vec4 old = texelFetch(oldFront, pixel, 0);
  gl_FragData[1].rgb += lightTransparency * (old.rgb - before.rgb);
  gl_FragData[1].a = 1.0 - lightTransparency * (1.0 - old.a);
}
