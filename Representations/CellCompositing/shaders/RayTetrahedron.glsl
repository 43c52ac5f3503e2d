// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a ray in one tetrahedron: where it lies, whether anything is seen of it, and its light.
ivec3 face = ivec3(0); // vertices of the face that the ray is passing
int next = 0;          // the vertex behind it
int left = 0;          // of the present tetrahedron, when the ray leaves it: the vertex that stays behind

// Leaves the present tetrahedron through the face where the ray does; returns which vertex of the face before stays behind.
int leaveTetrahedron(Seen ahead)
{
  int behind = stepWalk(ahead);
  left = behind == 0 ? face.x : behind == 1 ? face.y : face.z;
  face = ivec3(behind == 0 ? next : face.x, behind == 1 ? next : face.y, behind == 2 ? next : face.z);
  return behind;
}

bool isHidden()
{
  return hasHiddenCells && element(hiddenCells, cellNumber()).r > 0.0;
}

// Number of the polygon in the face of the present tetrahedron that is across from a vertex.
int polygonInFace(int opposite)
{
  ivec3 smaller = ivec3(lessThan(face, ivec3(opposite)));
  return element(tetrahedronSurfaces, cellNumber())[smaller.x + smaller.y + smaller.z];
}

// Nothing is seen between the face and the vertex ahead.
bool isClear(Seen ahead)
{
  if (useLayers && !contourLayers)
  {
    enterLayer(element(tetrahedronLayers, cellNumber()).r);
  }
  vec4 s = vec4(opacityScalar(walkA), opacityScalar(walkB), opacityScalar(walkC), opacityScalar(ahead));
  if (separateOpacity ? opacityOnCells : useCellScalars)
  {
    s = vec4(separateOpacity ? element(opacityScalars, cellNumber()).r : element(cellScalars, cellNumber()).r);
  }
  float low = lesser(lesser(s.x, s.y), lesser(s.z, s.w));
  float high = greater(greater(s.x, s.y), greater(s.z, s.w));
  bool seesThrough = low >= clear.x && high < clear.y;
  if (useContours)
  {
    vec4 c = vec4(contourScalar(walkA), contourScalar(walkB), contourScalar(walkC), contourScalar(ahead));
    if (contourOfColor && useCellScalars)
    {
      c = vec4(element(cellScalars, cellNumber()).r);
    }
    low = lesser(lesser(c.x, c.y), lesser(c.z, c.w));
    high = greater(greater(c.x, c.y), greater(c.z, c.w));
    seesThrough = seesThrough && low >= layerReach.x && high < layerReach.y;
  }
  return seesThrough;
}

// The part of the ray in one tetrahedron. Each end: distance, scalars of colour, opacity and contours.
vec4 segmentFront = vec4(0.0), segmentBack = vec4(0.0);
bool inSegment = false;
vec4 frontWeights = vec4(0.0); // of the vertices of the face behind, and of the vertex left
float passedPlace = 0.0;       // what is in front of this place is done, from 0 to 1
float passedValue = 0.0;       // the contour value there, if there is one
bool crossesNone = false;      // no surface is drawn in this tetrahedron

// `sum`: of the contour scalars; no number where one is missing.
void startSegment(vec4 front, vec4 back, float sum)
{
  segmentFront = front;
  segmentBack = back;
  inSegment = true;
  passedPlace = 0.0;
  if (useContours)
  {
    if (contourOfColor && useCellScalars)
    {
      segmentFront.w = segmentBack.w = element(cellScalars, cellNumber()).r;
    }
    crossesNone = isHidden() || isnan(sum);
    segmentFront.w = crossesNone ? 0.0 : segmentFront.w;
    layerIsKnown = (layerIsKnown && !crossesNone && !(contourOfColor && useCellScalars)) ||
      (segmentFront.w >= layerReach.x && segmentFront.w < layerReach.y);
  }
}

// From the face to where the ray leaves the tetrahedron behind it.
void crossTetrahedron(Seen ahead)
{
  vec4 front = passFace();
  vec3 entered = faceWeights();
  float sum = contourScalar(walkA) + contourScalar(walkB) + contourScalar(walkC) + contourScalar(ahead);
  int behind = leaveTetrahedron(ahead);
  frontWeights = behind == 0 ? vec4(0.0, entered.yz, entered.x) : behind == 1 ? vec4(entered.x, 0.0, entered.z, entered.y)
    : vec4(entered.xy, 0.0, entered.z);
  startSegment(front, passFace(), sum);
}

// Adds what lies between two places of the segment, as far as it is seen: between the near plane and the opaque geometry. `value` is the
// contour value at the second place, if one is crossed there.
void addPart(float place, bool crosses, float value, vec2 range)
{
  vec4 front = segmentFront, back = segmentBack;
  vec2 ends = useContours || useHaze ? mix(front.xx, back.xx, vec2(passedPlace, place)) : vec2(front.x, back.x);
  vec2 z = vec2(max(ends.x, range.x), min(ends.y, range.y));
  if (isHidden())
  {
    return;
  }
  FOR_EACH_SLICE(light, z, part)
  {
    vec4 before = accumulatedLight();
    vec2 t = (part - front.x) / (back.x - front.x);
    vec2 from = mix(front.yz, back.yz, t.x);
    vec2 to = mix(front.yz, back.yz, t.y);
    if (useContours && contourOfColor) // where a transfer function may jump
    {
      from.x = passedPlace > 0.0 && part.x == ends.x ? passedValue : from.x;
      to.x = crosses && part.y == ends.y ? value : to.x;
    }
    if (useCellScalars)
    {
      from.x = to.x = element(cellScalars, cellNumber()).r;
    }
    if (separateOpacity && opacityOnCells)
    {
      from.y = to.y = element(opacityScalars, cellNumber()).r;
    }
    addSegment(from, to, part.y - part.x);
    hazeAdded(before, part);
  }
}

// The part of the segment up to a place, as far as it is seen.
vec2 partUpTo(float place, vec2 range)
{
  vec2 ends = mix(segmentFront.xx, segmentBack.xx, vec2(passedPlace, place));
  return vec2(max(ends.x, range.x), min(ends.y, range.y));
}

// The haze from there on. A segment is cut into 32 parts at most.
bool hazeIsFresh = false;
void fitHazeToSegment(vec2 range)
{
  fitHaze(max(mix(segmentFront.x, segmentBack.x, passedPlace), range.x), (segmentBack.x - segmentFront.x) / 32.0);
  hazeIsFresh = true;
}
