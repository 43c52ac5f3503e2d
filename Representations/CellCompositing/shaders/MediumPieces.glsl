// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One of several media along a ray, in pieces over which its colour and extinction are linear, and gaps between them where nothing is seen.
// A walk finds cells, and the segments in them over which its scalars are linear: TetrahedronMedium.glsl, HexahedronMedium.glsl, VoxelMedium.glsl. Every medium has all of these names with its
// number (ShaderInstance.h).
// Places along the ray are distances from the plane in which the first medium's rays start, away from the eye.
// Constants: mediumNumber, mayOverlapItself.
uniform float mediumPlace; // of the plane in which this medium's rays start

float placePerDistance = 1.0; // along this ray, of this medium's coordinates
float extinctionPerPlace = 0.0;
vec2 mediumRange = vec2(0.0); // places between which it is seen
bool mediumEnds = true;       // there is no further piece

// The present piece, or gap: places; colour and extinction at its ends.
float pieceFrom = 0.0, pieceTo = 0.0;
vec4 mediumFront = vec4(0.0), mediumBack = vec4(0.0);

// What is left of the present segment: its two samples and their places; where it is done to, as a fraction.
vec2 sampleFront = vec2(0.0), sampleBack = vec2(0.0);
vec2 segmentPlaces = vec2(0.0);
float segmentDone = 0.0;

float placeAt(float distance)
{
  return mediumPlace + placePerDistance * distance;
}

float distanceAt(float place)
{
  return (place - mediumPlace) / placePerDistance;
}

vec3 placeInView(float place)
{
  return (MCVCMatrix * vec4(origin + distanceAt(place) * along, 1.0)).xyz;
}

#ifdef SMALL_TABLES
vec2 sampleHere = vec2(0.0); // where the segment is done to

void startPieces()
{
  sampleHere = sampleFront;
  segmentDone = 0.0;
}

// The next piece of the present segment: up to where a scalar comes to a node.
void takePiece()
{
  LinearPart part = partFrom(sampleHere, sampleFront, sampleBack);
  segmentDone = greater(segmentDone, part.to);
  mediumFront = part.start * vec4(1.0, 1.0, 1.0, extinctionPerPlace);
  mediumBack = part.end * vec4(1.0, 1.0, 1.0, extinctionPerPlace);
  pieceTo = max(pieceFrom, mix(segmentPlaces.x, segmentPlaces.y, segmentDone));
  sampleHere = part.scalars;
  inSegment = !part.atEnd;
}
#else
vec4 nextFront = vec4(0.0); // the value where the segment is done to
ivec2 piecesInterval = ivec2(0), lastInterval = ivec2(0);
bool startsAtColorNode = false, startsAtOpacityNode = false;

void startPieces()
{
  piecesInterval = findIntervals(sampleFront);
  lastInterval = findIntervals(sampleBack);
  nextFront = evaluate(piecesInterval, sampleFront);
  segmentDone = 0.0;
  startsAtColorNode = startsAtOpacityNode = false;
}

// The next piece of the present segment, as integrateSegment cuts it. The length of one between two nodes of one function is that of
// its interval; where float has no places for its ends, its light is added at once.
void takePiece()
{
  bool atEnd = !splitAtControlPoints || piecesInterval == lastInterval;
  ivec2 direction = ivec2(sign(lastInterval - piecesInterval));
  vec2 leave = atEnd ? vec2(2.0)
    : vec2(leaveInterval(transferNodes, transferTable, piecesInterval.x, lastInterval.x, sampleFront.x, sampleBack.x),
        separateOpacity ? leaveInterval(opacityNodes, opacityTable, piecesInterval.y, lastInterval.y, sampleFront.y, sampleBack.y) : 2.0);
  bool ofColor = leave.x <= leave.y;
  bool rising = (ofColor ? direction.x : direction.y) > 0;
  float to = atEnd ? 1.0 : max(segmentDone, min(leave.x, leave.y));
  vec2 s = mix(sampleFront, sampleBack, to);
  float exactLength = -1.0;
  if (!atEnd && ofColor && startsAtColorNode)
  {
    exactLength = crossingLength(transferNodes, transferTable, piecesInterval.x, sampleFront.x, sampleBack.x);
  }
  else if (!atEnd && !ofColor && startsAtOpacityNode)
  {
    exactLength = crossingLength(opacityNodes, opacityTable, piecesInterval.y, sampleFront.y, sampleBack.y);
  }
  exactLength *= segmentPlaces.y - segmentPlaces.x;
  mediumFront = nextFront;
  mediumBack = atEnd ? evaluate(lastInterval, sampleBack) : limit(ofColor, piecesInterval, rising, s);
  pieceTo = max(pieceFrom, atEnd ? segmentPlaces.y : mix(segmentPlaces.x, segmentPlaces.y, to));
  float length = pieceTo - pieceFrom;
  if (exactLength > 0.0 && length <= 0.0 && pieceFrom > max(mediumRange.x, mediaRange.x) && pieceFrom < min(mediumRange.y, mediaRange.y))
  {
    mixedLight += (1.0 - mixedLight.a) * integrateLinear(mediumFront, mediumBack, exactLength * extinctionPerPlace);
  }
  float extinction = extinctionPerPlace * (exactLength > 0.0 && length > 0.0 ? exactLength / length : 1.0);
  mediumFront.a *= extinction;
  mediumBack.a *= extinction;
  if (atEnd)
  {
    inSegment = false;
    return;
  }
  piecesInterval += ofColor ? ivec2(direction.x, 0) : ivec2(0, direction.y);
  nextFront = limit(ofColor, piecesInterval, !rising, s);
  startsAtColorNode = ofColor;
  startsAtOpacityNode = !ofColor;
  segmentDone = to;
}
#endif

// Each walk has its own: goes on to the next cell in which something is seen. False: there is none.
bool findSegments();
// There are segments of the cell to take.
bool hasSegments();
void takeSegment();

void nextPiece()
{
  pieceFrom = pieceTo;
  mediumFront = mediumBack = vec4(0.0);
  if (!inSegment)
  {
    takeSegment();
    inSegment = true;
    startPieces();
    if (segmentPlaces.x > pieceFrom)
    {
      pieceTo = segmentPlaces.x; // a gap
      return;
    }
  }
  takePiece();
}

// The pixel's ray, or one beside it, before the medium's first segment.
void placeMedium()
{
  keepCameraLight(along);
  placePerDistance = -dot(vec3(MCVCMatrix[0].z, MCVCMatrix[1].z, MCVCMatrix[2].z), along);
  extinctionPerPlace = length(mat3(MCVCMatrix) * along) * extinctionScale / placePerDistance;
  mediumRange = vec2(-3.0e38, mediaEnd);
#ifdef CLIPPING_PLANES
  vec2 between = clippedRay((MCVCMatrix * vec4(origin, 1.0)).xyz, mat3(MCVCMatrix) * along);
  mediumRange = vec2(placeAt(max(between.x, -1.0e30)), min(placeAt(min(between.y, 1.0e30)), mediaEnd));
#endif
  inSegment = false;
  pieceFrom = pieceTo = -3.0e38;
  mediumFront = mediumBack = vec4(0.0);
  mediumEnds = entered[mediumNumber] == -1.0;
}

//------------------------------------------------------------------------------------------------
// What RayMedia.frag.glsl does with all media.

bool lacksSegments(float place)
{
  return pieceTo <= place && !mediumEnds && !inSegment && !hasSegments();
}

void lookInMedium(float place)
{
  mediaWait = mediaWait || lacksSegments(place);
}

void findInMedium(float place)
{
  if (lacksSegments(place) && !findSegments())
  {
    mediumEnds = true;
    pieceFrom = pieceTo;
    pieceTo = 3.0e38;
    mediumFront = mediumBack = vec4(0.0);
  }
  lostMedium = walkIsLost ? mediumNumber : lostMedium;
}

void goOnInMedium(float place)
{
  if (pieceTo <= place && !mediumEnds)
  {
    nextPiece();
  }
}

// Up to where the medium stays as it is at a place.
void findEvent(float place)
{
  float edge = mediumRange.x > place ? mediumRange.x : mediumRange.y > place ? mediumRange.y : 3.0e38;
  nextPlace = min(nextPlace, mediumEnds ? 3.0e38 : min(pieceTo, edge));
}

void addMedium(float from, float to)
{
  if (!mediumEnds && from >= mediumRange.x && from < mediumRange.y && mediumFront.a + mediumBack.a > 0.0)
  {
    vec2 t = clamp((vec2(from, to) - pieceFrom) / (pieceTo - pieceFrom), 0.0, 1.0);
    vec4 front = mix(mediumFront, mediumBack, t.x);
    vec4 back = mix(mediumFront, mediumBack, t.y);
    vec4 middle = 0.5 * (front + back);
    soleFront = front;
    soleBack = back;
    mixedFront += vec4(front.rgb * front.a, front.a);
    mixedBack += vec4(back.rgb * back.a, back.a);
    mixedMiddle += middle.rgb * middle.a;
    ++mixedMedia;
  }
}

// What is left of a stretch of mesh where the next one begins: parts of a mesh that overlap are composited one after the other.
void finishMedium(float place)
{
  bool overlaps = mayOverlapItself && (int(plan.z) >> mediumNumber & 1) != 0;
  for (int i = 0; i < maximumSteps && overlaps && !mediumEnds && pieceFrom < mediumRange.y; ++i)
  {
    float from = max(max(pieceFrom, place), mediumRange.x);
    float to = min(pieceTo, mediumRange.y);
    FOR_EACH_SLICE(mixedLight, vec2(from, to), part)
    {
      clearMixture();
      addMedium(part.x, part.y);
      fitHaze(part.x, part.y - part.x);
      addMixture(part.x, part.y);
    }
    findInMedium(pieceTo);
    goOnInMedium(pieceTo);
  }
}
