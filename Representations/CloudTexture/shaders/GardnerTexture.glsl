// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cloud texture through the footprint of a pixel, as GardnerTexture.h and CoverageThreshold.h have it.
//   in:  texture coordinates p; how far they change over one standard deviation of the pixel's filter, across and up
//   out: mean of f, variance lost to the filter, sum of the fourth powers of the amplitudes that are left
// Constants, from the headers: gardnerWaves (in turns), gardnerAmplitudes, gardnerFourth, thresholdColumns, thresholdRows.
uniform sampler2D coverageThresholds;

const float squaredTurn = 39.4784176; // of 2 pi
const float twoOverTurn = 0.318309886;

// cos(2 pi x), to 7e-5 and what x is rounded by.
float cosineOfTurns(float x)
{
  float y = abs(x - floor(x + 0.5)) - 0.25;
  float z = y * y;
  return y * (-6.28128008 + z * (41.0952427 - z * 73.5855146));
}

vec3 filteredTexture(vec3 p, vec3 across, vec3 up)
{
  vec3 result = vec3(0.0);
  for (int i = 0; i < 7; ++i)
  {
    vec3 wave = gardnerWaves[i]; // in turns
    float chi = 0.5 * (wave.y * p.x - wave.x * p.y);
    float slope = cosineOfTurns(chi);
    vec3 local = vec3(wave.x + wave.y * slope, wave.y - wave.x * slope, wave.z);
    vec2 change = vec2(dot(local, across), dot(local, up));
    float amplitude = gardnerAmplitudes[i];
    float kept = amplitude * exp(-0.5 * squaredTurn * dot(change, change));
    float square = kept * kept;
    float modulation = twoOverTurn * cosineOfTurns(chi - 0.25);
    float height = cosineOfTurns(dot(wave, p) + modulation);
    result += vec3(kept * height, 0.5 * (amplitude * amplitude - square), square * square);
  }
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

// Share of a pixel that is cloud; its mean over the texture is the cover.
float cloudShare(vec3 tex, float cover, float softness)
{
  if (cover <= 0.0 || cover >= 1.0)
  {
    return cover <= 0.0 ? 0.0 : 1.0;
  }
  float variance = 1.0 + softness * softness;
  float threshold = sqrt(variance) * coverageThreshold(cover, clamp(tex.z / (gardnerFourth * variance * variance), 0.0, 1.0));
  float width = sqrt(max(tex.y, 0.0) + softness * softness);
  float share = normalShare((tex.x - threshold) / max(width, 1.0e-4));
  return share < 0.002 ? 0.0 : share;
}
