// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a splat counts in choosing the process that draws a pixel of it, for SplatRegion.glsl: at its own distance, or where vectors are
// drawn in layers at that of its layer, as it is sorted.
uniform float layerThickness; // 0: no layers
uniform float layerOrigin;    // z of the layers' origin in a parallel projection

float ofLayer(float depth)
{
  return layerThickness > 0.0 ? (floor(depth / layerThickness) + 0.5) * layerThickness : depth;
}

// pixels: whether these decide. Those of a splat that is spread over a pixel may lie farther from it than neighbours know.
vec4 inRegion(vec3 center, bool pixels)
{
  if (parallelRays)
  {
    return vec4(center.xy, ofLayer(center.z - layerOrigin) + layerOrigin, pixels ? 1.0 : -1.0);
  }
  return vec4(center, pixels ? ofLayer(length(center)) : -1.0);
}
