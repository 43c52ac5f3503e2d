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
uniform FloatArray hiddenCells;
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
uniform vec2 clearRange; // scalars between which nothing is seen

// Copies: RayCells.frag.glsl says why.
float unity = 0.0;      // 1
vec2 clear = vec2(0.0); // clearRange

// Through which face a ray leaves a cell: across from the one where it entered, or at one of its edges.
const int exitAhead = 0;
const int exitAB = 1;
const int exitBC = 2;
const int exitCD = 3;
const int exitDA = 4;

//NEPHOSCOPE::Constants
// further: hasHiddenCells, closedGrid

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

vec3 placeSeen(int point)
{
  return seen(point).xyz;
}

//NEPHOSCOPE::PixelRay
//NEPHOSCOPE::RayEntry
//NEPHOSCOPE::HexahedronWalk
//NEPHOSCOPE::HexahedronContours

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

// Nothing is seen in the cell whose vertices are at hand.
bool isClear()
{
  if (hasHiddenCells && element(hiddenCells, cellNumber()).r > 0.0)
  {
    return true;
  }
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
  vec2 contoured = contoursInCells ? rangeOfContours() : vec2(0.0);
  bool inLayer = !contoursInCells || !hasContourValues || (contoured.x >= layerReach.x && contoured.y < layerReach.y);
  return inLayer && opacitiesOfCell.x >= clear.x && opacitiesOfCell.y < clear.y;
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

// Where the ray passes the ring: in it, and along the ray, if known already.
vec2 ringPlace = vec2(0.0), ringPass = vec2(0.0);
bool ringIsKnown = false;

// The pieces of the cell that are still to be added, and where they begin: distance, scalars of colour and opacity.
vec4 cellDistances = vec4(0.0), scalarsInCell = vec4(0.0), opacitiesInCell = vec4(0.0);
float pieces = 1.0;
vec3 pieceFront = vec3(0.0);

// Crosses the cell; returns through which face the ray leaves it.
int crossCell()
{
  if (!ringIsKnown)
  {
    ringPlace = placeInRing();
    ringPass = passRing(ringPlace);
    ringIsKnown = true;
  }
  vec3 entered = vec3(ringPlace, 0.0);
  pieceFront = vec3(ringPass, 0.0);
  keepCell();
  int exit = leaveCell();
  ringPlace = placeInRing();
  ringPass = passRing(ringPlace);
  pieces = 1.0;
  inCell = true;
  partOfCell = 0.0;
  pieceFront.y = useCellScalars ? scalarsOfCell.x : pieceFront.y;
  pieceFront.z = separateOpacity ? opacitiesOfCell.x : pieceFront.y;
  if (useCellScalars && !contoursInCells && !opacityInCells)
  {
    return exit;
  }
  vec3 left = placeInCell(ringPlace, exit);
  vec3 thirds[2] = vec3[2](mix(entered, left, 1.0 / 3.0), mix(entered, left, 2.0 / 3.0));
  vec2 first = besidePlace(thirds[0]);
  float contouredFirst = contoursInCells ? contouredBeside(thirds[0]) : 0.0;
  float opacityFirst = opacityInCells ? fieldBeside(opacityNear, opacityFar, thirds[0]) : 0.0;
  vec2 second = besidePlace(thirds[1]);
  cellDistances = cubicThrough(vec4(pieceFront.x, first.x, second.x, ringPass.x));
  scalarsInCell = useCellScalars ? vec4(scalarsOfCell.x, 0.0, 0.0, 0.0) : cubicThrough(vec4(pieceFront.y, first.y, second.y, ringPass.y));
  pieces = countPieces(scalarsInCell);
  if (opacityInCells)
  {
    pieceFront.z = fieldInCell(opacityNear, opacityFar, entered).x;
    opacitiesInCell = cubicThrough(vec4(pieceFront.z, opacityFirst, fieldBeside(opacityNear, opacityFar, thirds[1]),
      fieldInCell(opacityNear, opacityFar, left).x));
    pieces = max(pieces, countPieces(opacitiesInCell));
  }
  if (contoursInCells)
  {
    placeEntered = entered;
    placeLeft = left;
    findLayersOfCell(vec4(contouredAt(entered).x, contouredFirst, contouredBeside(thirds[1]), contouredAt(left).x), exit);
  }
  return exit;
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
    float to = endOfPiece(pieces);
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
bool goOn(int exit, vec2 range)
{
  if (!crossFace(exit))
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

// Goes on to a cell in which something is seen, and crosses it. Less than 0: not found yet, or (not `inside`) there is none.
int findCell(vec2 range, inout bool inside)
{
  // Pixels that are computed together wait for each other before a cell is integrated, but not for long.
  const int stepsAtOnce = 8;
  for (int k = 0; k < stepsAtOnce; ++k)
  {
    seeAhead();
    if (!isClear())
    {
      return crossCell();
    }
    ringIsKnown = false;
    layerIsKnown = false;
    inside = goOn(leaveCell(), range);
    if (!inside)
    {
      break;
    }
  }
  return -1;
}

void walk(vec2 range)
{
  int exit = -1; // out of a cell whose pieces are being added
  const int cellsAtOnce = useHaze ? 16 : contoursInCells ? 32 : 1;
  bool inside = true;
  for (int i = 0; i < maximumSteps && inside; ++i)
  {
    if (useHaze && exit >= 0)
    {
      fitHazeToCell(range);
    }
    for (int n = 0; n < cellsAtOnce; ++n)
    {
      if (exit < 0)
      {
        exit = findCell(range, inside);
      }
      if (exit >= 0)
      {
        if (!addPieces(range))
        {
          break;
        }
        inside = ringPass.x < range.y && !isOpaque() && goOn(exit, range);
        exit = -1;
      }
      if (!inside)
      {
        break;
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
    layerReach = vec2(0.0); // nothing is clear
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
