// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Part of RayPlan.frag.glsl, once for each medium. Constant: mediumNumber.
uniform sampler2D lastEntry; // face (-1: none), depth
uniform sampler2D nextEntry;
uniform vec2 entryPlaces;    // places of the depths 0 and 1
uniform int startsAtEye;

vec2 entry = vec2(-1.0);
vec2 following = vec2(-1.0);
float followingPlace = 3.0e38;

void findNextEntry()
{
  entry = texelFetch(lastEntry, ivec2(gl_FragCoord.xy), 0).rg;
  following = texelFetch(nextEntry, ivec2(gl_FragCoord.xy), 0).rg;
  followingPlace = following.x < 0.0 ? 3.0e38 : mix(entryPlaces.x, entryPlaces.y, following.y);
  roundEnd = min(roundEnd, followingPlace);
}

void advanceMedium()
{
  bool isAtEye = startsAtEye != 0 && entry.y < 0.0;
  faces[mediumNumber] = isAtEye ? -2.0 : entry.x;
  if (following.x >= 0.0 && followingPlace <= roundEnd)
  {
    enteredAgain += 1 << mediumNumber;
    entry = following;
  }
}
