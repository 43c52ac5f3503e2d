// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a pixel's ray that is seen: origin + distance * along.
//NEPHOSCOPE::VisibleDepths
vec3 origin = vec3(0.0), along = vec3(0.0);

// Distances along the ray between which it is seen.
vec2 visibleRange()
{
  vec4 toZ = vec4(MCVCMatrix[0].z, MCVCMatrix[1].z, MCVCMatrix[2].z, MCVCMatrix[3].z);
  float atOrigin = dot(toZ, vec4(origin, 1.0));
  float slope = dot(toZ.xyz, along);
  vec2 depths = visibleDepths();
  vec2 range = (vec2(zFromDepth(depths.x), zFromDepth(depths.y)) - atOrigin) / slope;
#ifdef IN_SLICES
  vec4 ranges = texelFetch(depthRanges, ivec2(gl_FragCoord.xy), 0);
  for (int i = 0; i < SLICES; ++i)
  {
    sliceEnds[i] = (zFromDepth(sliceDepth(i + 1, ranges)) - atOrigin) / slope;
  }
#endif
#ifdef CLIPPING_PLANES
  vec2 between = clippedRay((MCVCMatrix * vec4(origin, 1.0)).xyz, mat3(MCVCMatrix) * along);
  range = vec2(max(range.x, between.x), min(range.y, between.y));
#endif
  return range;
}

// The haze along this ray.
void startHaze()
{
  startHazeRay((MCVCMatrix * vec4(origin, 1.0)).xyz, mat3(MCVCMatrix) * along);
}

// Hazes what has been added to the light between two distances along the ray.
void hazeAdded(vec4 before, vec2 z)
{
#ifdef NEPHOSCOPE_HAZE
  vec4 added = accumulatedLight() - before;
  float alpha = added.a / max(max(1.0 - before.a, added.a), 1.0e-20);
  light = before + hazedAlong(added, mix(z.x, z.y, hazeMeanPlace(alpha)));
#endif
}
