// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which pixels of a splat this process draws: SplatRegion.h. The same operations everywhere, so that one of two neighbours draws a pixel.
uniform vec4 regionRay;     // x and y of the ray through a pixel: X = x + z px, Y = y + w py; at a depth of 1, or in a parallel projection
uniform vec4 regionLow[3];  // dot((p, 1), plane) >= 0 within, of points p in VC
uniform vec4 regionHigh[3]; // < 0 within

// splat: centre in VC, and the distance from the eye at which it counts (in a parallel projection z is the depth); below 0 the centre
// decides for all pixels
bool outsideRegion(vec4 splat)
{
  vec4 place = vec4(splat.xyz, 1.0);
  if (splat.w >= 0.0)
  {
    vec2 ray = regionRay.xy + regionRay.zw * gl_FragCoord.xy;
    place.xyz = parallelRays ? vec3(ray, splat.z) : vec3(ray, -1.0) * (splat.w * inversesqrt(1.0 + dot(ray, ray)));
  }
  vec3 low = vec3(dot(regionLow[0], place), dot(regionLow[1], place), dot(regionLow[2], place));
  vec3 high = vec3(dot(regionHigh[0], place), dot(regionHigh[1], place), dot(regionHigh[2], place));
  return any(lessThan(low, vec3(0.0))) || any(greaterThanEqual(high, vec3(0.0)));
}
