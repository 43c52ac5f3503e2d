// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Bumps of cloud for the lights: the normal of a surface that the texture has raised, which is not moved itself (Blinn1978).
//   in:  footprints, takeRelief; normal in view coordinates, texture coordinates, weights of the two sets
//   out: unit normal
// Constants: hasSecondSet, largestAmplitude, and the waves of GardnerTexture.glsl.
uniform float reliefHeight; // of the largest wave, in view coordinates

const float reliefLimit = 0.6; // steep slopes tend to 1 / reliefLimit, 59 degrees
vec3 reliefAcross, reliefUp; // to the next pixel, in view coordinates

// To be called where all fragments of a pixel's neighbourhood pass: it takes derivatives.
void takeRelief(vec3 place)
{
  reliefAcross = dFdx(place);
  reliefUp = dFdy(place);
}

// How the height changes to the next pixel, across and up. Waves are as high as the squares of their amplitudes: the small ones of the
// texture itself are too steep for bumps.
vec2 bumpChangeOfWave(vec4 wave, vec4 shift, float turns, vec3 p, vec3 across, vec3 up)
{
  float chi = dot(shift.xyz, p);
  vec3 local = wave.xyz + fullTurn * turns * cosineOfTurns(chi) * shift.xyz;
  vec2 change = fullTurn * vec2(dot(local, across), dot(local, up));
  float height = wave.w / largestAmplitude;
  float phase = dot(wave.xyz, p) + shift.w + turns * cosineOfTurns(chi - 0.25);
  return -height * height * exp(-0.5 * dot(change, change)) * cosineOfTurns(phase - 0.25) * change;
}

vec2 bumpChange(vec3 p, vec3 across, vec3 up)
{
  vec2 result = vec2(0.0);
#define addBumps(wave, shift, turns) result += bumpChangeOfWave(wave, shift, turns, p, across, up);
  forEachWave(addBumps)
  return result / pixelDeviation;
}

vec3 raisedNormal(vec3 normal, vec3 first, vec3 second, vec2 weights)
{
  float square = dot(normal, normal);
  if (!(square > 0.5 && square < 2.0)) // what VTK makes of facets with pixels of 1e-10: the square of their area is 0
  {
    vec3 facet = normalize(cross(normalize(reliefAcross), normalize(reliefUp)));
    normal = facet.z < 0.0 ? -facet : facet;
  }
  vec2 change = bumpChange(first, footprints[0], footprints[1]);
  if (hasSecondSet)
  {
    vec2 other = bumpChange(placeInSecondSet(second), footprints[2], footprints[3]);
    change = (weights.x * change + weights.y * other) / length(weights);
  }
  vec3 across = cross(reliefUp, normal);
  vec3 up = cross(normal, reliefAcross);
  float area = dot(reliefAcross, across);
  if (abs(area) <= 1.0e-6 * length(reliefAcross) * length(reliefUp))
  {
    return normal; // seen from the side
  }
  vec3 slope = reliefHeight * (change.x * across + change.y * up) / area;
  return normalize(normal - slope / (1.0 + reliefLimit * length(slope)));
}
