// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cloud texture through the footprint of a pixel, as GardnerTexture.h and CoverageThreshold.h have it.
//   in:  texture coordinates p; how far they change over one standard deviation of the pixel's filter, across and up
//   out: mean of f, variance lost to the filter, sum of the fourth powers of the amplitudes that are left
// Constants, from the header: gardnerWaves, gardnerAmplitudes, gardnerFourth, thresholdColumns, thresholdRows.
uniform sampler2D coverageThresholds;

vec3 filteredTexture(vec3 p, vec3 across, vec3 up)
{
  vec3 result = vec3(0.0);
  for (int i = 0; i < 7; ++i)
  {
    vec3 wave = gardnerWaves[i];
    float chi = 0.5 * (wave.y * p.x - wave.x * p.y);
    float slope = cos(chi);
    vec3 local = vec3(wave.x + wave.y * slope, wave.y - wave.x * slope, wave.z);
    vec2 change = vec2(dot(local, across), dot(local, up));
    float amplitude = gardnerAmplitudes[i];
    float kept = amplitude * exp(-0.5 * dot(change, change));
    float square = kept * kept;
    result += vec3(kept * cos(dot(wave, p) + 2.0 * sin(chi)), 0.5 * (amplitude * amplitude - square), square * square);
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
