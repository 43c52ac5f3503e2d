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

// isDot: the centre decides, and not the pixel. One of a splat that is spread over it may lie farther away than neighbours know.
vec4 inRegion(vec3 center, bool isDot)
{
  if (parallelRays)
  {
    return vec4(center.xy, ofLayer(center.z - layerOrigin) + layerOrigin, isDot ? -1.0 : 1.0);
  }
  return vec4(center, isDot ? -1.0 : ofLayer(length(center)));
}
