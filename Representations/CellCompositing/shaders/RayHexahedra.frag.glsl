//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of all hexahedra that a pixel's ray crosses from where it enters the mesh to where it leaves it.
//   in:  the boundary face through which the ray enters
//   out: premultiplied colour and alpha, front to back
//NEPHOSCOPE::Arrays
uniform FloatArray points; // position, scalar
uniform FloatArray cellScalars;
uniform FloatArray opacityScalars;
uniform FloatArray clearDistances; // 0: something is seen in the cell (ClearDistances.h)
uniform IntegerArray boundaryFaces;
uniform sampler2D entryFaces; // boundary face (-1: none), depth
uniform mat4 MCVCMatrix;
uniform float extinctionScale; // extinction per world length at opacity 1
// The pixel's ray goes through this point, amid the data, in this direction; relative to the centre of the data.
noperspective in vec3 rayPointVSOutput;
noperspective in vec3 rayDirectionVSOutput;
uniform int maximumSteps;
uniform int startsAtEye; // rays start in the cell that holds the eye, not at a boundary face
uniform int eyeHexahedron[4]; // that cell
uniform vec3 eyeMC;
uniform vec4 eyeVC;         // (position, 1) or (direction towards the eye, 0)

float unity = 0.0; // 1; RayCells.frag.glsl says why uniforms are copied

// Through which face a ray leaves a cell: across from the one where it entered, or at one of its edges.
const int exitAhead = 0;
const int exitAB = 1;
const int exitBC = 2;
const int exitCD = 3;
const int exitDA = 4;

//NEPHOSCOPE::Constants
// further: closedGrid

//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction
//NEPHOSCOPE::RaySegments
//NEPHOSCOPE::ContourSurfaces
//NEPHOSCOPE::RayRange
//NEPHOSCOPE::CameraLight
//NEPHOSCOPE::CubicPieces
//NEPHOSCOPE::Topology

vec3 across1 = vec3(0.0), across2 = vec3(0.0);
vec3 pointStep[2], directionStep[2]; // from pixel to pixel

vec4 seen(int point)
{
  vec4 p = element(points, point);
  vec3 q = p.xyz - origin;
  return vec4(dot(q, across1), dot(q, across2), dot(q, along), withCameraLight(p.w, point));
}

void keepWalk() {}

vec3 placeSeen(int point)
{
  return seen(point).xyz;
}

//NEPHOSCOPE::PixelRay
//NEPHOSCOPE::RayEntry
//NEPHOSCOPE::HexahedronWalk
//NEPHOSCOPE::HexahedronContours
//NEPHOSCOPE::ThinPieces

vec2 scalarsOfCell = vec2(0.0);   // lowest and highest
vec2 opacitiesOfCell = vec2(0.0); // the same of the scalars that the opacity function reads
vec4 opacityNear = vec4(0.0), opacityFar = vec4(0.0); // of an array of their own at A to D, and at E to H
const bool opacityInCells = separateOpacity && !opacityOnCells;

void seeOpacities()
{
  opacitiesOfCell = scalarsOfCell;
  if (opacityInCells)
  {
    opacityNear = valuesOfRing(opacityScalars, 0);
    opacityFar = valuesOfRing(opacityScalars, 1);
    opacitiesOfCell = rangeOfEight(opacityNear, opacityFar);
  }
  else if (separateOpacity)
  {
    opacitiesOfCell = vec2(element(opacityScalars, cellNumber()).r);
  }
}

void seeScalars()
{
  if (useCellScalars)
  {
    scalarsOfCell = vec2(element(cellScalars, cellNumber()).r);
  }
  else
  {
    float low = lesser(lesser(lesser(walkA.w, walkB.w), lesser(walkC.w, walkD.w)), lesser(lesser(walkE.w, walkF.w), lesser(walkG.w, walkH.w)));
    float high =
      greater(greater(greater(walkA.w, walkB.w), greater(walkC.w, walkD.w)), greater(greater(walkE.w, walkF.w), greater(walkG.w, walkH.w)));
    scalarsOfCell = vec2(low, high);
  }
  seeOpacities();
  seeContours();
}

// Nothing is seen in the cell.
bool isClear()
{
  return element(clearDistances, cellNumber()).r > 0.0;
}

// Adds what lies between two places, as far as it is seen: between the near plane and the opaque geometry.
void addPart(vec3 front, vec3 back, vec2 range)
{
  vec2 z = vec2(max(front.x, range.x), min(back.x, range.y));
  FOR_EACH_SLICE(light, z, part)
  {
    vec4 before = accumulatedLight();
    vec2 t = (part - front.x) / (back.x - front.x);
    addSegment(mix(front.yz, back.yz, t.x), mix(front.yz, back.yz, t.y), part.y - part.x);
    hazeAdded(before, part);
  }
}

// Where the ray passes the ring, that of the next cell once it has crossed one: in it, and along the ray, if known already.
vec2 ringPlace = vec2(0.0), ringPass = vec2(0.0);
bool ringIsKnown = false;

// The pieces of the cell that are still to be added, and where they begin: distance, scalars of colour and opacity.
vec4 cellDistances = vec4(0.0), scalarsInCell = vec4(0.0), opacitiesInCell = vec4(0.0);
vec3 pieceFront = vec3(0.0);

// The face through which the ray leaves the present cell, which is done: the walk goes on from there.
int exitOfCell = 0;
bool cellIsDone = false;

// Finds the pieces of the cell.
void crossCell()
{
  seeAhead();
  seeScalars();
  exitOfCell = leaveCell();
  if (!ringIsKnown)
  {
    ringPlace = placeInRing();
    ringPass = passRing(ringPlace);
    ringIsKnown = true;
  }
  vec3 entered = vec3(ringPlace, 0.0);
  pieceFront = vec3(ringPass, 0.0);
  ringPlace = placeInRingAhead();
  ringPass = passRingAhead(ringPlace);
  numberOfPieces = 1.0;
  inCell = true;
  partOfCell = 0.0;
  pieceFront.y = useCellScalars ? scalarsOfCell.x : pieceFront.y;
  pieceFront.z = separateOpacity ? opacitiesOfCell.x : pieceFront.y;
  if (useCellScalars && !contoursInCells && !opacityInCells)
  {
    return;
  }
  vec3 left = placeInCell(ringPlace, exitOfCell);
  vec3 thirds[2] = vec3[2](mix(entered, left, 1.0 / 3.0), mix(entered, left, 2.0 / 3.0));
  vec2 first = besidePlace(thirds[0]);
  float contouredFirst = contoursInCells ? contouredBeside(thirds[0]) : 0.0;
  float opacityFirst = opacityInCells ? fieldBeside(opacityNear, opacityFar, thirds[0]) : 0.0;
  vec2 second = besidePlace(thirds[1]);
  cellDistances = cubicThrough(vec4(pieceFront.x, first.x, second.x, ringPass.x));
  scalarsInCell = useCellScalars ? vec4(scalarsOfCell.x, 0.0, 0.0, 0.0) : cubicThrough(vec4(pieceFront.y, first.y, second.y, ringPass.y));
  numberOfPieces = countPieces(scalarsInCell);
  if (opacityInCells)
  {
    pieceFront.z = fieldInCell(opacityNear, opacityFar, entered).x;
    opacitiesInCell = cubicThrough(vec4(pieceFront.z, opacityFirst, fieldBeside(opacityNear, opacityFar, thirds[1]),
      fieldInCell(opacityNear, opacityFar, left).x));
    numberOfPieces = max(numberOfPieces, countPieces(opacitiesInCell));
  }
  if (contoursInCells)
  {
    placeEntered = entered;
    placeLeft = left;
    findLayersOfCell(vec4(contouredAt(entered).x, contouredFirst, contouredBeside(thirds[1]), contouredAt(left).x), exitOfCell);
  }
}

bool hazeIsFresh = false;
void fitHazeToCell(vec2 range)
{
  fitHaze(max(pieceFront.x, range.x), (ringPass.x - pieceFront.x) / 32.0);
  hazeIsFresh = true;
}

// Where a piece ends: distance, scalars of colour and opacity.
vec3 placeInPieces(float to)
{
  vec2 place = to >= 1.0 ? vec2(ringPass.x, useCellScalars ? scalarsOfCell.x : ringPass.y)
                         : vec2(cubicAt(cellDistances, to), clamp(cubicAt(scalarsInCell, to), scalarsOfCell.x, scalarsOfCell.y));
  float opacity = opacityInCells ? cubicAt(opacitiesInCell, min(to, 1.0)) : separateOpacity ? opacitiesOfCell.x : place.y;
  return vec3(place, clamp(opacity, opacitiesOfCell.x, opacitiesOfCell.y));
}

int contourAhead = -1; // to be passed before the next piece

// Adds the pieces of the cell that are left. False: the haze is to be fitted anew first, or a surface to be added.
bool addPieces(vec2 range)
{
  while (inCell)
  {
    float to = endOfPiece(numberOfPieces);
    int contour = contoursInCells ? contourInPiece(to) : -1;
    vec3 back = placeInPieces(to);
    float end = min(back.x, range.y);
    bool hazeEnds = useHaze && end > hazeTo && end > max(pieceFront.x, range.x);
    if (hazeEnds && !hazeIsFresh)
    {
      return false;
    }
    hazeIsFresh = false;
    if (hazeEnds) // the piece is longer
    {
      float part = (hazeTo - pieceFront.x) / (back.x - pieceFront.x);
      back = mix(pieceFront, back, part);
      to = mix(partOfCell, to, part);
      contour = -1;
    }
    addPart(pieceFront, back, range);
    pieceFront = back;
    partOfCell = to;
    contourAhead = contour;
    inCell = hazeEnds || contour >= 0 || to < 1.0;
    if (hazeEnds || contour >= 0)
    {
      return false;
    }
  }
  return true;
}

// Into the next cell. False: there is none, or it is out of sight.
bool goOn(vec2 range)
{
  takeRingAhead();
  if (!crossFace(exitOfCell))
  {
    return false;
  }
  if (!takesRingAlong)
  {
    layerIsKnown = false; // the scalar may jump
    ringIsKnown = false;
    walkIsLost = !seeRing();
  }
  return !walkIsLost && lesser(lesser(walkA.z, walkB.z), lesser(walkC.z, walkD.z)) < range.y;
}

// Goes on to a cell in which something is seen. False: not found yet, or (not `inside`) there is none. Software computes both sides of
// every test: what is done with such a cell is no part of this loop.
bool findCell(vec2 range, inout bool inside)
{
  const int stepsAtOnce = 8; // pixels that are computed together wait for each other
  bool found = false;
  for (int k = 0; k < stepsAtOnce && inside && !found; ++k)
  {
    seeAhead();
    found = !cellIsDone && !isClear();
    if (found)
    {
      break;
    }
    ringIsKnown = ringIsKnown && cellIsDone;
    layerIsKnown = layerIsKnown && cellIsDone;
    cellIsDone = false;
    exitOfCell = leaveCell();
    inside = goOn(range);
  }
  return found;
}

// The three pieces that addThinPieces adds.
void placePieces()
{
  for (int i = 0; i < 4; ++i)
  {
    vec3 place = placeInPieces(float(i) / numberOfPieces);
    places[i] = place.x;
    scalars[i] = place.y;
    opacityScalarsHere[i] = place.z;
  }
  places.x = pieceFront.x;
}

// The cell that was crossed is added, as far as that is simple. False: it is left, in whole or in part.
bool addThinCell(vec2 range)
{
  bool isCut = pieceFront.x < range.x || ringPass.x > range.y || (useHaze && ringPass.x > hazeTo);
  bool isFolded = ringPass.x < pieceFront.x;
  bool mustWait = isCut || isFolded || (contoursInCells && crossesContours());
#ifdef SMALL_TABLES
  closeSlices(light, pieceFront.x);
  bool waits = mustWait || !endsInSlice(ringPass.x) || !splitAtControlPoints;
  for (int i = 0; i < 64 && inCell && !waits; ++i)
  {
    float to = endOfPiece(numberOfPieces);
    vec3 back = placeInPieces(to);
    LinearPart part = partFrom(pieceFront.yz, pieceFront.yz, back.yz);
    float end = mix(pieceFront.x, back.x, part.to);
    waits = !averageIntegration && max(part.start.a, part.end.a) * opticalLength * (end - pieceFront.x) > 1.0;
    if (!waits)
    {
      addLinear(part.start, part.end, vec2(pieceFront.x, end));
      pieceFront = vec3(end, part.scalars);
      partOfCell = mix(partOfCell, to, part.to);
      inCell = partOfCell < 1.0;
    }
  }
  return !inCell;
#else
  placePieces();
  return addThinPieces(mustWait);
#endif
}

// From cell to cell. False: none is found yet that needs more than is done here, or (not `inside`) there is none.
bool walkThin(vec2 range, inout bool inside)
{
  const int cellsAtOnce = 8;
  bool waits = false;
  for (int k = 0; k < cellsAtOnce && inside && !waits; ++k)
  {
    if (findCell(range, inside))
    {
      crossCell();
      waits = !addThinCell(range);
      inCell = waits;
      inside = waits || (ringPass.x < range.y && !isOpaque() && goOn(range));
    }
  }
  return waits;
}

void walk(vec2 range)
{
  bool waits = false; // the pieces of a cell are being added
  const int cellsAtOnce = useHaze ? 16 : contoursInCells ? 32 : 1;
  bool inside = true;
  cellIsDone = false;
  for (int i = 0; i < maximumSteps && inside; ++i)
  {
    if (useHaze && waits)
    {
      fitHazeToCell(range);
    }
    for (int n = 0; n < cellsAtOnce && inside; ++n)
    {
      if (!waits)
      {
        waits = walkThin(range, inside);
      }
      if (waits)
      {
        if (!addPieces(range))
        {
          break;
        }
        waits = false;
        cellIsDone = true;
        inside = ringPass.x < range.y && !isOpaque();
      }
    }
    if (contoursInCells && contourAhead >= 0)
    {
      addSurface(contourAhead, pieceFront.xy, range);
      contourAhead = -1;
      inside = inside && !isOpaque();
    }
  }
}

// The ray passes the triangle. Where it does not pass the quadrilateral then, that is bent, and seen from the side.
bool passesWellInside(ivec3 triangle)
{
  vec3 a = placeSeen(triangle.x), b = placeSeen(triangle.y), c = placeSeen(triangle.z);
  return wayInside(a.xy, b.xy, c.xy, vec3(1.0 / 3.0)) == 0.0;
}

// By how many pixels a ray may pass its pixel's centre where it enters through a triangle.
float farthestBeside(ivec3 triangle)
{
  makeRay(vec2(0.0));
  return startsAtEye == 0 && passesWellInside(triangle) ? 0.003 : 0.3;
}

// The cell lies ahead of the ring, which the ray sees counterclockwise.
bool cellIsAhead()
{
  seeAhead();
  vec3 normal = cross(walkC.xyz - walkA.xyz, walkD.xyz - walkB.xyz);
  return dot(normal, walkE.xyz + walkF.xyz + walkG.xyz + walkH.xyz - walkA.xyz - walkB.xyz - walkC.xyz - walkD.xyz) > 0.0;
}

// The face through which the ray enters the cell. Its distance does not tell: an eye on a vertex has all of them at the same.
bool startInEyeCell()
{
  ivec4 place = ivec4(eyeHexahedron[0], eyeHexahedron[1], eyeHexahedron[2], eyeHexahedron[3]);
  int nearest = -1;
  float least = 3.0e38;
  for (int number = 0; number < 6; ++number)
  {
    enterFaceOfCell(place, number);
    bool passes = seeRing();
    float distance = passRing(placeInRing()).x + (cellIsAhead() ? 0.0 : 1.0e30);
    nearest = passes && distance < least ? number : nearest;
    least = passes ? min(least, distance) : least;
  }
  enterFaceOfCell(place, max(nearest, 0));
  return seeRing();
}

void main()
{
  ivec4 boundaryFace = startPixel();
  // A ray that passes by the face that the rasterizer gave it tries again a little beside.
  float farthest = farthestBeside(boundaryFace.xyz);
  for (int attempt = 0; attempt < lastAttempt; ++attempt)
  {
    vec2 beside = besideCentre(attempt, boundaryFace.xyz);
    if (dot(beside, beside) > farthest * farthest)
    {
      continue;
    }
    makeRay(beside);
    keepCameraLight(along);
    vec2 range = visibleRange();
    startSegments(length(mat3(MCVCMatrix) * along) * extinctionScale);
    startHaze();
    ringIsKnown = false;
    layerIsKnown = false;
    layerReach = vec2(0.0);
    if (startsAtEye != 0)
    {
      walkIsLost = !startInEyeCell();
      range.x = max(range.x, dot(eyeMC - origin, along));
    }
    else
    {
      enterFace(boundaryFace);
      walkIsLost = !seeRing();
    }
    if (!walkIsLost)
    {
      walk(range);
    }
    if (!walkIsLost)
    {
      break;
    }
  }
  PUT_LIGHT(light)
}
