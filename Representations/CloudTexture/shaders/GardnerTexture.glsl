// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cloud texture through the footprint of a pixel, as GardnerTexture.h and CoverageThreshold.h have it.
//   in:  texture coordinates p; how far they change over one standard deviation of the pixel's filter, across and up
//   out: mean of f, variance lost to the filter, sum of the fourth powers of the amplitudes that are left
// From the headers: the constants thresholdColumns, thresholdRows and gardnerFourth (sum of the fourth powers of the amplitudes), and the macro
// forEachWave(visit), which calls visit(wave, shift, turns) for each: frequencies and amplitude; frequencies of what shifts the phase, and
// phase; by how many turns it shifts.
uniform int hasThreshold; // instead of a cover
uniform float givenThreshold;
uniform sampler2D coverageThresholds;

const float squaredTurn = 39.4784176; // of 2 pi
const float fullTurn = 6.28318531;

// cos(2 pi x), to 7e-5 and what x is rounded by.
float cosineOfTurns(float x)
{
  float y = abs(x - floor(x + 0.5)) - 0.25;
  float z = y * y;
  return y * (-6.28128008 + z * (41.0952427 - z * 73.5855146));
}

vec3 filteredWave(vec4 wave, vec4 shift, float turns, vec3 p, vec3 across, vec3 up)
{
  float chi = dot(shift.xyz, p);
  vec3 local = wave.xyz + fullTurn * turns * cosineOfTurns(chi) * shift.xyz;
  vec2 change = vec2(dot(local, across), dot(local, up));
  float kept = wave.w * exp(-0.5 * squaredTurn * dot(change, change));
  float square = kept * kept;
  float phase = dot(wave.xyz, p) + shift.w + turns * cosineOfTurns(chi - 0.25);
  return vec3(kept * cosineOfTurns(phase), 0.5 * (wave.w * wave.w - square), square * square);
}

vec3 filteredTexture(vec3 p, vec3 across, vec3 up)
{
  vec3 result = vec3(0.0);
#define addFilteredWave(wave, shift, turns) result += filteredWave(wave, shift, turns, p, across, up);
  forEachWave(addFilteredWave)
  return result;
}

vec3 blendTextures(vec3 first, vec3 second, vec2 weights)
{
  vec2 w = weights / length(weights);
  vec2 square = w * w;
  return vec3(w.x * first.x + w.y * second.x, square.x * first.y + square.y * second.y,
    square.x * square.x * first.z + square.y * square.y * second.z);
}

// The second set reads the texture mirrored and shifted: independent of the first where coordinates agree.
vec3 placeInSecondSet(vec3 p)
{
  return vec3(p.x + 0.37, 0.61 - p.y, p.z + 0.29);
}

// Cumulative normal distribution, to 2e-4.
float normalShare(float x)
{
  return 1.0 / (1.0 + exp(-1.5957691 * (x + 0.044715 * x * x * x)));
}

float coverageThreshold(float cover, float fourth)
{
  vec2 place = vec2(cover * (thresholdColumns - 1.0), fourth * (thresholdRows - 1.0));
  return texture(coverageThresholds, (place + 0.5) / vec2(thresholdColumns, thresholdRows)).r;
}

// Above which there is cloud.
float cloudThreshold(float fourth, float cover, float softness)
{
  if (hasThreshold != 0)
  {
    return givenThreshold;
  }
  float variance = 1.0 + softness * softness;
  return sqrt(variance) * coverageThreshold(cover, clamp(fourth / (gardnerFourth * variance * variance), 0.0, 1.0));
}

// The fraction of the pixel that is cloud, from what exceeds the threshold and its standard deviation there. Its mean over the texture is the cover.
float cloudShare(float excess, float width)
{
  float share = normalShare(excess / width);
  return share < 0.002 ? 0.0 : share;
}

float normalDensity(float x)
{
  return 0.39894228 * exp(-0.5 * x * x);
}

// Mean over the cloud in the pixel of the excess, in units of a range, at most 1.
float cloudExcess(float excess, float width, float range)
{
  float low = excess / width;
  float high = (excess - range) / width;
  float sum = excess * (normalShare(low) - normalShare(high)) + width * (normalDensity(low) - normalDensity(high));
  return clamp((sum / range + normalShare(high)) / max(normalShare(low), 1.0e-3), 0.0, 1.0);
}
