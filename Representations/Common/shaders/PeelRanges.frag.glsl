//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The depth ranges in which a peel wants a volume to be drawn: what the peeling pass would hand to a ray caster's castRay.
//   out: (near, far) of the first and of the second call, depths in [0, 1]; near >= far: nothing
//        as depth, a little less than the nearest of them, so that a depth test keeps out what lies in front of it
// Names that the pass expects of a volume's shader: in_inverseWindowSize, g_opacityThreshold, initializeRayCast, castRay.
uniform vec2 in_inverseWindowSize;
const float g_opacityThreshold = 2.0; // of alpha, above which the pass would skip what lies behind: never
const vec2 nothing = vec2(1.0, 0.0);
const float depthMargin = 1.0e-5; // more than a rasterizer errs in depth

//VTK::DepthPeeling::Dec

int calls = 0;
vec2 firstRange = nothing;
vec2 secondRange = nothing;

void initializeRayCast() {}

vec4 castRay(float nearDepth, float farDepth)
{
  vec2 range = nearDepth < farDepth ? vec2(nearDepth, farDepth) : nothing;
  if (calls == 0)
  {
    firstRange = range;
  }
  else
  {
    secondRange = range;
  }
  ++calls;
  return vec4(0.0);
}

void peel()
{
//VTK::CallWorker::Impl
}

void main()
{
  peel();
  if (firstRange == nothing && secondRange == nothing)
  {
    discard;
  }
  gl_FragData[0] = vec4(firstRange, secondRange);
  gl_FragDepth = min(firstRange.x, secondRange.x) - depthMargin;
}
