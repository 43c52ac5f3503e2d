// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Haze between the eye and a place, as Testing/Haze.h has it: lengths in scale heights but for places in view coordinates (VC).
//   hazeBefore(placeVC)               what haze adds from the eye to the place, and T of the air there
//   hazeAirlight(...)                 what haze adds on the way: (1 - T) C, or with a sun the sum of what each part of it scatters
//   hazedColor(rgb, placeVC)          colour of a surface of any opacity as it is seen through the air: T rgb + (1 - T) C
//   hazedLight(light, placeVC)        the same of a premultiplied colour with alpha: T rgb + alpha (1 - T) C, alpha
//   hazedSegment(light, front, back)  the same of a medium between two places
#ifndef HAZE_ON_GLOBE // otherwise true or false, where that is known beforehand: software computes both sides of every test
uniform int hazeOnGlobe;      // 0: over flat ground
#define HAZE_ON_GLOBE (hazeOnGlobe != 0)
#define HAZE_IS_LIT (dot(hazeSun, hazeSun) > 0.0)
#endif
uniform int hazeParallel;     // parallel rays, which start in the plane of the camera
uniform float hazeUnit;       // scale heights in one length of view coordinates
uniform float hazeExtinction; // per scale height at altitude 0
uniform vec3 hazeTint;        // C
uniform vec3 hazeSun;         // VC: unit vector towards the sun; 0: haze has its colour wherever it is
uniform float hazeAsymmetry;  // of its phase function
#ifdef HAZE_SHADOWS
uniform sampler3D hazeShadows; // fraction of the sun's beam that clouds let through; the third axis points towards the sun
uniform mat4 hazeToShadows;    // from VC
#endif
uniform vec3 hazeEye;         // VC: where all rays start; direction of parallel ones, away from the camera
uniform vec3 hazeFrame;       // globe: from its centre to the eye (parallel: to the camera); flat: upwards
uniform vec2 hazeHeight;      // of the eye (parallel: of the camera): distance from the centre, altitude

float hazeErfc(float x) // exp(x^2) erfc(x)
{
  float t = (x - 3.0) / (x + 3.0);
  float sum = -9.25451669e-05;
  sum = sum * t - 0.000513850513;
  sum = sum * t + 0.00187507912;
  sum = sum * t + 0.0022865137;
  sum = sum * t - 0.0237635764;
  sum = sum * t + 0.0684095817;
  sum = sum * t - 0.119275275;
  sum = sum * t + 0.129627505;
  sum = sum * t - 0.0475621569;
  sum = sum * t - 0.135620239;
  sum = sum * t + 1.25300806;
  return sum / (1.0 + 2.0 * x);
}

float hazeMeanDecay(float x)
{
  return x < 0.03 ? 1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)) : (1.0 - exp(-x)) / x;
}

float hazeMeanTransparency(float front, float back)
{
  if (back <= 1.0)
  {
    vec4 t = vec4(0.069431844202973714, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629);
    vec4 weights = vec4(0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693);
    return dot(weights, exp(-t * (front + 0.5 * (back - front) * t)));
  }
  float q = sqrt(2.0 * max(back - front, 1.0e-6 * back));
  return 1.7724538509055160 / q * (hazeErfc(front / q) - exp(-0.5 * (front + back)) * hazeErfc(back / q));
}

float hazeDensity(float altitude)
{
  return exp(-max(altitude, -20.0));
}

// A place about the centre: (radius, altitude) belong to `place`.
struct HazePlace
{
  vec3 place;
  vec2 height;
};

HazePlace movedHazePlace(HazePlace from, vec3 step_)
{
  vec3 to = from.place + step_;
  float radius = length(to);
  return HazePlace(to, vec2(radius, from.height.y + dot(from.place + to, step_) / (from.height.x + radius)));
}

float levelHazeLength(vec2 first, vec2 last, vec2 along, float nearest)
{
  vec2 x = along * inversesqrt(vec2(first.x, last.x) + nearest);
  vec2 e = vec2(hazeDensity(first.y), hazeDensity(last.y));
  const float halfRootPi = 0.88622692545275801;
  vec2 tails = halfRootPi * e * vec2(hazeErfc(abs(x.x)), hazeErfc(abs(x.y)));
  float g = abs(tails.x - tails.y);
  if (x.x < 0.0 && x.y > 0.0)
  {
    float lowest = abs(along.x) < abs(along.y) ? first.y - along.x * along.x / (first.x + nearest)
                                               : last.y - along.y * along.y / (last.x + nearest);
    g = 2.0 * halfRootPi * hazeDensity(lowest) - tails.x - tails.y;
  }
  float second = 0.5 * (g - x.y * e.y + x.x * e.x);
  return max(0.0, sqrt(2.0 * nearest) * (g + 0.75 / nearest * second));
}

float steepHazeLength(vec2 lower, float sine, float reach)
{
  float front = sine * reach;
  float back = front + (1.0 - sine * sine) * reach / lower.x * reach;
  return reach * hazeDensity(lower.y) * hazeMeanTransparency(front, back);
}

float globeHazeLength(HazePlace from, vec3 step_)
{
  vec2 first = from.height;
  vec2 last = movedHazePlace(from, step_).height;
  float reach = length(step_);
  float perReach = reach > 0.0 ? 1.0 / reach : 0.0;
  float along1 = dot(from.place, step_) * perReach;
  vec2 along = vec2(along1, along1 + reach);
  float nearest = length(from.place - along1 * perReach * step_);
  bool rising = along.x >= 0.0;
  bool falling = along.y <= 0.0;
  vec2 lower = first.x < last.x ? first : last;
  float sine = min(1.0, (rising ? along.x : -along.y) / lower.x);
  bool isShort = reach < 0.005 * lower.x;
  if (!isShort && !((rising || falling) && sine > 0.2))
  {
    return levelHazeLength(first, last, along, nearest);
  }
  if (rising || falling)
  {
    return steepHazeLength(lower, sine, reach);
  }
  vec2 lowest = vec2(nearest, first.y - along.x * along.x / (first.x + nearest));
  return steepHazeLength(lowest, 0.0, -along.x) + steepHazeLength(lowest, 0.0, along.y);
}

float flatHazeLength(vec2 altitudes, float reach)
{
  return reach * hazeDensity(min(altitudes.x, altitudes.y)) * hazeMeanDecay(abs(altitudes.y - altitudes.x));
}

// Where the ray to a place starts, in VC.
vec3 hazeStart(vec3 placeVC)
{
  return hazeParallel == 0 ? hazeEye : placeVC - hazeEye * (placeVC.z / hazeEye.z);
}

vec3 hazeRayStartVC = vec3(0.0); // of the present ray

// The same in scale heights; over flat ground only its altitude. The ray from there becomes the present one.
HazePlace hazePlaceOfStart(vec3 startVC)
{
  hazeRayStartVC = startVC;
  HazePlace place = HazePlace(hazeFrame, hazeHeight);
  if (hazeParallel == 0)
  {
    return place;
  }
  if (HAZE_ON_GLOBE)
  {
    return movedHazePlace(place, startVC * hazeUnit);
  }
  place.height.y += dot(hazeFrame, startVC) * hazeUnit;
  return place;
}

float flatHazeLengthToSky(float altitude, float rise)
{
  float slope = max(abs(rise), 1.0e-6);
  return (rise >= 0.0 ? hazeDensity(altitude) : max(0.0, 1.0 - hazeDensity(altitude))) / slope;
}

float globeHazeLengthToSky(HazePlace from, vec3 direction)
{
  const float top = 30.0;
  float radius = from.height.x;
  float altitude = from.height.y;
  float along = dot(from.place, direction);
  float planet = radius - altitude;
  float toGround = altitude * (planet + radius);
  float toTop = (top - altitude) * (planet + top + radius);
  float ground = along * along - toGround;
  float sky = along * along + toTop;
  bool meetsGround = along < 0.0 && ground > 0.0 && altitude > 0.0;
  if (!(sky > 0.0) || (along > 0.0 && toTop < 0.0))
  {
    return 0.0;
  }
  float reach = meetsGround ? toGround / (sqrt(ground) - along) : sqrt(sky) - along;
  float start = along < 0.0 && toTop < 0.0 ? -along - sqrt(sky) : 0.0;
  return globeHazeLength(movedHazePlace(from, start * direction), (reach - start) * direction);
}

bool hazeIsLit()
{
  return HAZE_IS_LIT;
}

// From a start (over flat ground only its altitude) along a step.
float hazeLength(HazePlace start, vec3 step_)
{
  return HAZE_ON_GLOBE ? globeHazeLength(start, step_)
                          : flatHazeLength(vec2(start.height.y, start.height.y + dot(hazeFrame, step_)), length(step_));
}

HazePlace hazePlaceAfter(HazePlace start, vec3 step_)
{
  return HAZE_ON_GLOBE ? movedHazePlace(start, step_)
                          : HazePlace(start.place, vec2(0.0, start.height.y + dot(hazeFrame, step_)));
}

// T of the air between a place and the sun; 0 at night.
float hazeSunTransparency(HazePlace place)
{
  float altitude = max(place.height.y, 0.0);
  if (!HAZE_ON_GLOBE)
  {
    float rise = dot(hazeFrame, hazeSun);
    return rise > 0.0 ? exp(-hazeExtinction * flatHazeLengthToSky(altitude, rise)) : 0.0;
  }
  float along = dot(place.place, hazeSun);
  float toGround = altitude * (2.0 * place.height.x - altitude);
  return along < 0.0 && along * along > toGround ? 0.0 : exp(-hazeExtinction * globeHazeLengthToSky(place, hazeSun));
}

// HenyeyGreenstein1941, with a mean of 1; `cosine` is that of the angle between the ray and the direction towards the sun.
float hazePhase(float cosine)
{
  float g = hazeAsymmetry;
  float d = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (d * sqrt(d));
}

// Light that a place scatters into a direction with this phase function, for a white sun: the sun's beam, and what other haze has scattered out
// of it, which comes from everywhere. Together they are what a layer as thick as the way to the sun lets through (MeadorWeaver1980, Eddington,
// no absorption). From 30 degrees down to the horizon the second part fades out with the light that falls on a level surface. The third part
// is light of the ground and of the clear sky, from half of all directions each: their albedo times what falls on a level surface.
float hazeSunlight(HazePlace place, float phase)
{
  float beam = hazeSunTransparency(place);
  if (!(beam > 0.0))
  {
    return 0.0;
  }
  float height = HAZE_ON_GLOBE ? dot(normalize(place.place), hazeSun) : dot(hazeFrame, hazeSun);
  float through = 1.0 / (1.0 - 0.75 * (1.0 - hazeAsymmetry) * log(beam));
  const float ground = 0.2, sky = 0.15;
  return beam * phase + clamp(2.0 * height, 0.0, 1.0) * max(through - beam, 0.0) + 2.0 * (ground + sky) * max(height, 0.0) * through;
}

// The part of a ray that has haze: below this altitude.
vec2 hazyPart(HazePlace start, vec3 direction, float reach)
{
  const float top = 8.0;
  float altitude = start.height.y;
  float rise = dot(hazeFrame, direction);
  vec2 part = vec2(0.0, reach);
  if (!HAZE_ON_GLOBE)
  {
    float crossing = (top - altitude) / (abs(rise) > 1.0e-6 ? rise : 1.0e-6);
    part = altitude > top ? vec2(rise < 0.0 ? crossing : reach, reach) : vec2(0.0, rise > 0.0 ? crossing : reach);
  }
  else
  {
    float along = dot(start.place, direction);
    float toTop = (top - altitude) * (2.0 * start.height.x - altitude + top);
    float disc = along * along + toTop;
    float root = sqrt(max(disc, 0.0));
    part = vec2(toTop < 0.0 ? -along - root : 0.0, toTop < 0.0 && along > 0.0 ? 0.0 : -along + root);
    float toGround = altitude * (2.0 * start.height.x - altitude);
    float ground = along * along - toGround;
    part.y = along < 0.0 && ground > 0.0 && altitude > 0.0 ? min(part.y, toGround / (sqrt(ground) - along)) : part.y;
  }
  return clamp(part, 0.0, reach);
}

// Where the light of a uniform medium of this optical depth comes from, in the mean: from the front (0) to the back (1).
float hazeMeanPlaceAt(float depth)
{
  return depth < 0.05 ? 0.5 - depth / 12.0 : 1.0 / depth - 1.0 / (exp(min(depth, 80.0)) - 1.0);
}

// What is displayed of light: all of it up to a knee, and above less and less, so that bright haze around the sun keeps its colour and its shafts.
vec3 hazeExposed(vec3 light)
{
  const float knee = 0.75;
  float most = max(light.r, max(light.g, light.b));
  float above = (most - knee) / (1.0 - knee);
  return most > knee ? light * (knee + (1.0 - knee) * above / (1.0 + above)) / most : light;
}

#ifdef HAZE_SHADOWS
// The part of a ray, in scale heights from its start, that is neither beside the map of shadows nor nearer to the sun.
vec2 hazeShadowedPart(vec3 from, vec3 perHeight, vec2 part)
{
  vec3 along = mix(perHeight, vec3(1.0e-9), lessThan(abs(perHeight), vec3(1.0e-9)));
  vec3 toLow = -from / along, toHigh = (1.0 - from) / along;
  vec3 enters = min(toLow, toHigh), leaves = max(toLow, toHigh);
  enters.z = along.z < 0.0 ? enters.z : -3.0e38;
  leaves.z = along.z > 0.0 ? leaves.z : 3.0e38;
  return vec2(max(part.x, max(enters.x, max(enters.y, enters.z))), min(part.y, min(leaves.x, min(leaves.y, leaves.z))));
}

// The part of the sun's beam that clouds keep from haze along a ray, times its phase function: to be taken from the light of haze without clouds.
float hazeLightInShadow(HazePlace start, vec3 direction, vec2 hazy, float phase)
{
  const int parts = 8, samples = 6;
  vec3 from = (hazeToShadows * vec4(hazeRayStartVC, 1.0)).xyz;
  vec3 perHeight = mat3(hazeToShadows) * direction / hazeUnit;
  vec2 part = hazeShadowedPart(from, perHeight, hazy);
  if (!(part.y > part.x))
  {
    return 0.0;
  }
  float before = exp(-hazeExtinction * hazeLength(start, part.x * direction));
  float beamBefore = hazeSunTransparency(hazePlaceAfter(start, part.x * direction));
  float sum = 0.0;
  for (int i = 1; i <= parts; ++i)
  {
    float reach = mix(part.x, part.y, float(i) / float(parts));
    float after = min(before, exp(-hazeExtinction * hazeLength(start, reach * direction)));
    float beam = hazeSunTransparency(hazePlaceAfter(start, reach * direction));
    float shadow = 0.0;
    for (int k = 0; k < samples; ++k)
    {
      float at = mix(part.x, part.y, (float(i - 1) + (float(k) + 0.5) / float(samples)) / float(parts));
      shadow += 1.0 - texture(hazeShadows, from + at * perHeight).x;
    }
    sum += (before - after) * 0.5 * (beamBefore + beam) * shadow / float(samples);
    before = after;
    beamBefore = beam;
  }
  return phase * sum;
}
#endif

// `opacity`: 1 - T of the whole step. What each part scatters is dimmed by the haze in front of it.
vec3 hazeAirlight(HazePlace start, vec3 step_, float opacity)
{
  const int parts = 12;
  float reach = length(step_);
  vec3 direction = step_ / max(reach, 1.0e-20);
  vec2 hazy = hazyPart(start, direction, reach);
  float before = hazeExtinction * hazeLength(start, hazy.x * direction);
  float first = before;
  float phase = hazePhase(dot(direction, hazeSun));
  float lightBefore = hazeSunlight(hazePlaceAfter(start, hazy.x * direction), phase);
  float sum = 0.0;
  for (int i = 1; i <= parts; ++i)
  {
    vec3 back = mix(hazy.x, hazy.y, float(i) / float(parts)) * direction;
    float after = max(before, hazeExtinction * hazeLength(start, back));
    float light = hazeSunlight(hazePlaceAfter(start, back), phase);
    float depth = after - before; // thin: light is linear in T, as with the sun overhead; thick: it comes from near the front
    float place = mix(0.5, hazeMeanPlaceAt(depth), smoothstep(1.0, 3.0, depth));
    sum += (exp(-before) - exp(-after)) * mix(lightBefore, light, place);
    before = after;
    lightBefore = light;
  }
#ifdef HAZE_SHADOWS
  sum = max(0.0, sum - hazeLightInShadow(start, direction, hazy, phase));
#endif
  float seen = exp(-first) - exp(-before);
  float share = seen > 0.0 ? opacity / seen : 0.0; // the rest is too thin for parts
  return hazeExposed(min(share, 2.0) * sum * hazeTint);
}

// What haze makes of black between the eye and a place: light, and T.
vec4 hazeBefore(vec3 placeVC)
{
  if (hazeParallel != 0 && placeVC.z >= 0.0)
  {
    return vec4(0.0, 0.0, 0.0, 1.0); // behind the camera
  }
  vec3 startVC = hazeStart(placeVC);
  vec3 step_ = (placeVC - startVC) * hazeUnit;
  HazePlace start = hazePlaceOfStart(startVC);
  float transparency = exp(-hazeExtinction * hazeLength(start, step_));
  float opacity = 1.0 - transparency;
  return vec4(hazeIsLit() ? hazeAirlight(start, step_, opacity) : opacity * hazeTint, transparency);
}

// The same for an opacity.
float hazeMeanPlace(float alpha)
{
  float a = min(alpha, 1.0 - 1.0e-7);
  return a < 0.05 ? 0.5 - a * (1.0 + 0.5 * a) / 12.0 : -1.0 / log(1.0 - a) - (1.0 - a) / a;
}

vec3 hazedColor(vec3 rgb, vec3 placeVC)
{
  vec4 haze = hazeBefore(placeVC);
  return haze.rgb + haze.a * rgb;
}

vec4 hazedLight(vec4 light, vec3 placeVC)
{
  vec4 haze = hazeBefore(placeVC);
  return vec4(light.a * haze.rgb + haze.a * light.rgb, light.a);
}

vec4 hazedSegment(vec4 light, vec3 frontVC, vec3 backVC)
{
  return hazedLight(light, mix(frontVC, backVC, hazeMeanPlace(light.a)));
}
