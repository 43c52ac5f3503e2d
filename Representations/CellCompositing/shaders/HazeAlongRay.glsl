// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Haze along a ray that passes many cells. From one place on, the density of haze is a polynomial of third degree in the distance, exact at
// four places, and the optical depth is its integral; a segment then costs one exponential. The polynomial holds as far as the depth is
// exact to 1e-5; there the next one begins. Only the depth where it begins is taken from the closed form (Haze.glsl).
//   startHazeRay(place, along)  VC: the place at distance 0, and the change per distance
//   fitHaze(from, least)        the polynomial from this distance on, for this distance at least
//   hazedAlong(light, at)       hazedLight at a distance from hazeFrom to hazeTo
//   hazedThin(light, z, depth)  the same of a thin part between two distances, with its optical depth
float hazeFrom = 0.0;
#ifdef NEPHOSCOPE_HAZE
const bool useHaze = true;
float hazeTo = -3.0e38;
HazePlace hazeRayStart;
vec3 hazeRayOrigin = vec3(0.0), hazeRayStep = vec3(0.0); // from the start: of distance 0, and per distance; scale heights
float hazeRayPlane = -3.0e38; // parallel rays: distance of the camera, behind which there is no haze
float hazePerReach = 0.0, hazeDepth = 0.0;
vec4 hazeDepths = vec4(0.0);  // coefficients of what is added to the depth
float hazeClear = 1.0, hazePerSeen = 0.0; // T at hazeFrom; 1 / (its change up to hazeTo); the light there, where a sun lights the haze
vec3 hazeLightFrom = vec3(0.0), hazeLightTo = vec3(0.0);

void startHazeRay(vec3 placeVC, vec3 alongVC)
{
  vec3 startVC = hazeStart(placeVC);
  hazeRayStart = hazePlaceOfStart(startVC);
  hazeRayOrigin = (placeVC - startVC) * hazeUnit;
  hazeRayStep = alongVC * hazeUnit;
  hazeRayPlane = hazeParallel != 0 ? -placeVC.z / alongVC.z : -3.0e38;
  hazeFrom = hazeTo = -3.0e38;
}

// How far the polynomial holds, in scale heights: the fourth derivative of exp(-altitude) is less than (change of altitude)^4.
float hazeReach(HazePlace here, vec3 direction)
{
  bool onGlobe = HAZE_ON_GLOBE;
  float rise = onGlobe ? dot(here.place, direction) / here.height.x : dot(hazeFrame, direction);
  float change = max(abs(rise) + (onGlobe ? inversesqrt(here.height.x) : 0.0), 1.0e-4);
  const float error = 9000.0 * 1.0e-5; // the integral of the interpolation's error is a 9000th of the derivative
  float thickness = max(hazeExtinction * hazeDensity(here.height.y), 1.0e-20);
  return min(1.0, pow(error * change / thickness, 0.2)) / change;
}

float hazeDepthAt(float s)
{
  return hazeDepth + max(0.0, s * (hazeDepths.x + s * (hazeDepths.y + s * (hazeDepths.z + s * hazeDepths.w))));
}

void fitHaze(float from, float least)
{
  vec3 before = hazeRayOrigin + from * hazeRayStep;
  float perDistance = length(hazeRayStep);
  vec3 direction = hazeRayStep / perDistance;
  HazePlace here = hazePlaceAfter(hazeRayStart, before);
  float reach = max(hazeReach(here, direction), least * perDistance);
  hazeFrom = from;
  hazeTo = from + reach / perDistance;
  hazePerReach = perDistance / reach;
  hazeDepth = hazeExtinction * hazeLength(hazeRayStart, before);
  vec3 third = reach / 3.0 * direction;
  vec4 d = vec4(hazeDensity(here.height.y), hazeDensity(hazePlaceAfter(here, third).height.y),
    hazeDensity(hazePlaceAfter(here, 2.0 * third).height.y), hazeDensity(hazePlaceAfter(here, 3.0 * third).height.y));
  vec4 cubic = vec4(d.x, dot(d, vec4(-5.5, 9.0, -4.5, 1.0)), dot(d, vec4(9.0, -22.5, 18.0, -4.5)), dot(d, vec4(-4.5, 13.5, -13.5, 4.5)));
  hazeDepths = hazeExtinction * reach * cubic * vec4(1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0);
  if (from < hazeRayPlane)
  {
    hazeDepth = 0.0;
    hazeDepths = vec4(0.0);
    hazeTo = max(hazeRayPlane, from + least);
  }
  if (HAZE_IS_LIT)
  {
    hazeClear = exp(-hazeDepth);
    float seen = hazeClear - exp(-hazeDepthAt(1.0));
    hazePerSeen = seen > 0.0 ? 1.0 / seen : 0.0;
    vec3 after = before + 3.0 * third;
    hazeLightFrom = from < hazeRayPlane ? vec3(0.0) : hazeAirlight(hazeRayStart, before, 1.0 - hazeClear);
    hazeLightTo = from < hazeRayPlane ? vec3(0.0) : hazeAirlight(hazeRayStart, after, 1.0 - hazeClear + seen);
  }
}

vec4 hazedAlong(vec4 light, float at)
{
  float transparency = exp(-hazeDepthAt((at - hazeFrom) * hazePerReach));
  vec3 haze = (1.0 - transparency) * hazeTint;
  if (HAZE_IS_LIT)
  {
    haze = mix(hazeLightFrom, hazeLightTo, (hazeClear - transparency) * hazePerSeen);
  }
  return vec4(light.a * haze + transparency * light.rgb, light.a);
}

vec4 hazedThin(vec4 light, vec2 z, float depth)
{
  float q = depth * depth; // hazeMeanPlaceAt as a series
  float place = !averageIntegration || depth <= 1.0 ? 0.5 - depth * (1.0 / 12.0 - q * (1.0 / 720.0 - q / 30240.0)) : hazeMeanPlaceAt(depth);
  return hazedAlong(light, mix(z.x, z.y, place));
}
#else
const bool useHaze = false;
const float hazeTo = 3.0e38;
void startHazeRay(vec3 placeVC, vec3 alongVC)
{
}
void fitHaze(float from, float least)
{
}
vec4 hazedAlong(vec4 light, float at)
{
  return light;
}
vec4 hazedThin(vec4 light, vec2 z, float depth)
{
  return light;
}
#endif
