//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of several media that may overlap in space, along a pixel's ray: extinctions add, and every medium emits in proportion to its own.
// The ray walks through all meshes in step, from one place to the next where any of them has a new piece (TetrahedronMedium.glsl).
//   in:  what a round is to draw (RayPlan.frag.glsl)
//   out: premultiplied colour and alpha, front to back
//NEPHOSCOPE::Arrays
uniform sampler2D roundPlan;    // places from, and up to; bits of the media that enter their meshes again there
uniform sampler2D enteredFaces; // of each medium: boundary face through which the ray entered; -1: none; -2: starts at the eye
uniform float firstPlane;       // distance from the eye's plane of the places 0

//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::VisibleDepths
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::MixedSegment

vec4 plan = vec4(0.0);
vec4 entered = vec4(-1.0);
vec2 mediaRange = vec2(0.0); // places of this round
float mediaEnd = 0.0;        // nothing is seen behind
int lostMedium = -1;         // the walk through its mesh is lost
bool isLastAttempt = false;
bool mediaWait = false; // for a cell of one
float nextPlace = 0.0;

vec4 mixedLight = vec4(0.0);
// Sums over the media at both ends of an interval and in its middle: emission, extinction. How many there are, and the last one.
vec4 mixedFront = vec4(0.0), mixedBack = vec4(0.0);
vec3 mixedMiddle = vec3(0.0);
int mixedMedia = 0;
vec4 soleFront = vec4(0.0), soleBack = vec4(0.0);

void clearMixture()
{
  mixedFront = mixedBack = vec4(0.0);
  mixedMiddle = vec3(0.0);
  mixedMedia = 0;
}

void addMixture(float from, float to);

//NEPHOSCOPE::Media

void addMixture(float from, float to)
{
  if (mixedMedia == 0)
  {
    return;
  }
  float length = to - from;
  vec2 weights = segmentWeights(soleFront.a * length, soleBack.a * length);
  vec4 added = mixedMedia == 1 ? vec4(weights.x * soleFront.rgb + weights.y * soleBack.rgb, weights.x + weights.y)
                               : integrateMixed(mixedFront * length, mixedBack * length, mixedMiddle * length);
#ifdef NEPHOSCOPE_HAZE
  added = hazedAlong(added, mix(from, to, hazeMeanPlace(added.a)));
#endif
  mixedLight += (1.0 - mixedLight.a) * added;
}

void startHaze()
{
#ifdef NEPHOSCOPE_HAZE
  vec3 seenVC = placeInViewOfFirst(mediaRange.x);
  vec3 alongVC = hazeParallel != 0 ? hazeEye : seenVC - hazeEye;
  alongVC /= -alongVC.z;
  startHazeRay(seenVC - mediaRange.x * alongVC, alongVC);
#endif
}

bool isTransparent()
{
  return transparencyOf(mixedLight) > 1.0e-7;
}

// To the next place where a medium has a new piece, but no further than to the end.
void addEvent(float end, inout float place)
{
  closeSlices(mixedLight, place);
  goOnInMedia(place);
  nextPlace = endInSlice(end);
  findEvents(place);
  if (nextPlace > place)
  {
    clearMixture();
    addMedia(place, nextPlace);
    addMixture(place, nextPlace);
    place = nextPlace;
  }
}

// From a place to an end, if that is near; returns how far. Software computes both sides of every test: looking for cells is apart from
// integrating the pieces of those that are found.
float walkTo(float end, float from)
{
  const int eventsAtOnce = useHaze ? 32 : 1 << 20;
  const int piecesAtOnce = 16;
  float place = from;
  for (int i = 0; i < eventsAtOnce && place < end && isTransparent(); ++i)
  {
    findInMedia(place);
    if (lostMedium >= 0 && !isLastAttempt)
    {
      break;
    }
    for (int k = 0; k < piecesAtOnce && place < end && isTransparent(); ++k)
    {
      mediaWait = false;
      lookInMedia(place);
      if (mediaWait)
      {
        break;
      }
      addEvent(end, place);
    }
  }
  return place;
}

// From the place where the round begins to where it, the light or what is seen ends.
void walkTogether()
{
  const int most = 1 << 20;
  float end = min(mediaRange.y, mediaEnd);
  float place = mediaRange.x;
  lostMedium = -1;
  for (int i = 0; i < most && place < end && isTransparent(); ++i)
  {
    fitHaze(place, 1.0e-5 * abs(place));
    place = walkTo(min(end, hazeTo), place);
    if (lostMedium >= 0 && !isLastAttempt)
    {
      return;
    }
  }
  if (mediaRange.y < mediaEnd)
  {
    finishMedia(max(mediaRange.x, mediaRange.y));
  }
}

void main()
{
  prepareMedia();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  plan = texelFetch(roundPlan, pixel, 0);
  entered = texelFetch(enteredFaces, pixel, 0);
  vec2 depths = visibleDepths();
  vec2 seenPlaces = vec2(-zFromDepth(depths.x), -zFromDepth(depths.y)) - firstPlane;
  mediaRange = vec2(max(plan.x, seenPlaces.x), plan.y);
  mediaEnd = seenPlaces.y;
#ifdef IN_SLICES
  vec4 ranges = texelFetch(depthRanges, pixel, 0);
  for (int i = 0; i < SLICES; ++i)
  {
    sliceEnds[i] = -zFromDepth(sliceDepth(i + 1, ranges)) - firstPlane;
  }
#endif
  bool isEmpty = plan.z > 0.0 ? mediaRange.x >= mediaEnd : mediaRange.x >= min(mediaRange.y, mediaEnd);
  if (all(equal(entered, vec4(-1.0))) || isEmpty || depths.x >= depths.y)
  {
    discard;
  }
  lostMedium = -1;
  const int last = 16;
  for (int attempt = 0; attempt <= last; ++attempt)
  {
    isLastAttempt = attempt == last;
    placeBesideOfMedia();
    mixedLight = vec4(0.0);
    startSlices();
    startMedia();
    startHaze();
    walkTogether();
    if (lostMedium < 0)
    {
      break;
    }
  }
  PUT_LIGHT(mixedLight)
}
