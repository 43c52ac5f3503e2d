//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of all tetrahedra that a pixel's ray crosses from where it enters the mesh to where it leaves it.
//   in:  the boundary triangle through which the ray enters
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
uniform int startsAtEye;    // rays start in the tetrahedron that holds the eye, not at a boundary face
uniform vec3 eyeMC;
uniform int eyeVertices[4]; // of that tetrahedron
uniform int eyePlace[4];
uniform vec2 eyeScalars;    // at the eye
uniform vec4 eyeWeights;    // of the vertices, there
uniform vec4 eyeVC;         // (position, 1) or (direction towards the eye, 0)
uniform vec2 clearRange; // scalars between which nothing is seen
uniform IntegerArray tetrahedronLayers;

// Software OpenGL (Mesa's llvmpipe) fetches a uniform anew for every pixel wherever it is used, at the cost of a texture: what loops
// use is copied before, in a way that no compiler sees through.
// Globals start at a value: Mesa warns of those that a function further down assigns.
float unity = 0.0;      // 1
vec2 clear = vec2(0.0); // clearRange, or that of the layer

//NEPHOSCOPE::Constants
// further: hasHiddenCells, closedGrid, hasJumps
int jumpFace = -1; // boundary face from which a ray goes on that has left the mesh, where there is one: values jump there

//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction
//NEPHOSCOPE::RaySegments
//NEPHOSCOPE::Topology
//NEPHOSCOPE::ContourSurfaces
//NEPHOSCOPE::PolygonSurfaces
//NEPHOSCOPE::TetrahedronWalk
//NEPHOSCOPE::RayRange
//NEPHOSCOPE::RayContours
//NEPHOSCOPE::CameraLight

vec3 across1 = vec3(0.0), across2 = vec3(0.0);
vec3 pointStep[2], directionStep[2]; // from pixel to pixel

Seen seen(int point)
{
  vec4 p = element(points, point);
  vec3 q = p.xyz - origin;
  vec4 place = vec4(dot(q, across1), dot(q, across2), dot(q, along), withCameraLight(p.w, point));
#ifdef MORE_SCALARS
  return Seen(place, vec2(separateOpacity && !opacityOnCells ? element(opacityScalars, point).r : 0.0,
    useContours && !contourOfColor ? element(contourScalars, point).r : 0.0));
#else
  return Seen(place);
#endif
}

vec3 placeSeen(int point)
{
  return seen(point).place.xyz;
}

//NEPHOSCOPE::PixelRay

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
  if (z.y > z.x && !isHidden())
  {
    vec4 before = accumulatedLight();
    vec2 t = (z - front.x) / (back.x - front.x);
    vec2 from = mix(front.yz, back.yz, t.x);
    vec2 to = mix(front.yz, back.yz, t.y);
    if (useContours && contourOfColor) // where a transfer function may jump
    {
      from.x = passedPlace > 0.0 && z.x == ends.x ? passedValue : from.x;
      to.x = crosses && z.y == ends.y ? value : to.x;
    }
    if (useCellScalars)
    {
      from.x = to.x = element(cellScalars, cellNumber()).r;
    }
    if (separateOpacity && opacityOnCells)
    {
      from.y = to.y = element(opacityScalars, cellNumber()).r;
    }
    addSegment(from, to, z.y - z.x);
    hazeAdded(before, z);
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

// Passes the face through which the ray enters.
void startAtFace(ivec4 boundaryFace)
{
  face = boundaryFace.xyz;
  next = enterTetrahedron(boundaryFace);
  if (startWalk(seen(face.x), seen(face.y), seen(face.z)))
  {
    face = face.xzy;
  }
}

// Goes into the next tetrahedron. False: there is none.
bool goOn()
{
  if (crossFace(face, left, next))
  {
    return true;
  }
  if (!hasJumps || jumpFace < 0)
  {
    return false;
  }
  bool lost = walkIsLost;
  startAtFace(element(boundaryFaces, jumpFace));
  walkIsLost = lost;
  layerIsKnown = false;
  return true;
}

// Which of the faces of the eye's tetrahedron, across from its vertices, the ray leaves through: where it is deepest inside, ahead.
float depthInside(Seen a, Seen b, Seen c, float eyeZ)
{
  startWalk(a, b, c);
  float inside = min(edgeFunction(walkA, walkB), min(edgeFunction(walkB, walkC), edgeFunction(walkC, walkA)));
  return passFace().x > eyeZ ? inside : -3.0e38;
}

void startInEyeTetrahedron()
{
  ivec4 v = ivec4(eyeVertices[0], eyeVertices[1], eyeVertices[2], eyeVertices[3]);
  float eyeZ = dot(eyeMC - origin, along);
  Seen p0 = seen(v.x), p1 = seen(v.y), p2 = seen(v.z), p3 = seen(v.w);
  vec4 inside = vec4(depthInside(p1, p2, p3, eyeZ), depthInside(p0, p2, p3, eyeZ), depthInside(p0, p1, p3, eyeZ),
    depthInside(p0, p1, p2, eyeZ));
  float deepest = max(max(inside.x, inside.y), max(inside.z, inside.w));
  int across = inside.x == deepest ? 0 : inside.y == deepest ? 1 : inside.z == deepest ? 2 : 3;
  left = across == 0 ? v.x : across == 1 ? v.y : across == 2 ? v.z : v.w;
  face = across == 0 ? v.yzw : across == 1 ? v.xzw : across == 2 ? v.xyw : v.xyz;
  vec4 w = eyeWeights;
  frontWeights = across == 0 ? w.yzwx : across == 1 ? w.xzwy : across == 2 ? w.xywz : w;
  enterPlace(ivec4(eyePlace[0], eyePlace[1], eyePlace[2], eyePlace[3]));
  if (startWalk(seen(face.x), seen(face.y), seen(face.z)))
  {
    face = face.xzy;
    frontWeights = frontWeights.xzyw;
  }
  if (useLayers && !contourLayers)
  {
    enterLayer(element(tetrahedronLayers, cellNumber()).r);
  }
  vec4 contour = vec4(contourScalar(p0), contourScalar(p1), contourScalar(p2), contourScalar(p3));
  vec2 scalars = vec2(cameraLight ? dot(w, vec4(p0.place.w, p1.place.w, p2.place.w, p3.place.w)) : eyeScalars.x, eyeScalars.y);
  startSegment(vec4(eyeZ, scalars, dot(w, contour)), passFace(), contour.x + contour.y + contour.z + contour.w);
}

// What has to be done before the walk goes on.
const int rayEnds = 0;
const int mayGoOn = 1;
const int findsLayer = 2;
const int crossesUp = 3;
const int crossesDown = 4;
const int passesPolygon = 5; // in the face through which it leaves a tetrahedron
const int entersMesh = 6;    // perhaps through a polygon
const int leavesHaze = 7;    // the polynomial of the haze holds no longer
const bool useSurfaces = useContours || usePolygons;
const bool stopsInSegments = useSurfaces || useHaze;

// From there to where the ray leaves the mesh or is lost, or where there are surfaces, to the next one, if it is near.
int walk(vec2 range)
{
  // Loops rather than tests in one: pixels that are computed together wait for each other before a segment is integrated, so that
  // it is not integrated for a few of them at a time; but not for long. So do they before a surface is lit.
  const int stepsAtOnce = 8;
  int steps = useSurfaces ? 6 * stepsAtOnce : maximumSteps;
  int outcome = mayGoOn;
  for (int i = 0; i < steps; ++i)
  {
    if (!stopsInSegments || !inSegment)
    {
      Seen ahead;
      bool inside = true;
      bool found = false;
      bool polygon = false;
      for (int k = 0; k < stepsAtOnce; ++k)
      {
        ahead = seen(next);
        if (!isClear(ahead))
        {
          found = true;
          break;
        }
        leaveTetrahedron(ahead);
        polygon = usePolygons && polygonInFace(left) > 0;
        if (polygon)
        {
          break;
        }
        inside = goOn() && !walkIsLost &&
          lesser(walkA.place.z, lesser(walkB.place.z, walkC.place.z)) < range.y;
        if (!inside)
        {
          break;
        }
      }
      if (!inside)
      {
        outcome = rayEnds;
        break;
      }
      if (polygon)
      {
        outcome = passesPolygon;
        break;
      }
      if (!found)
      {
        continue;
      }
      crossTetrahedron(ahead);
    }
    float place = 1.0;
    float value = 0.0;
    bool crosses = false;
    if (useContours)
    {
      if (!layerIsKnown)
      {
        outcome = findsLayer;
        break;
      }
      bool up = segmentBack.w >= layerReach.y;
      crosses = !crossesNone && (up || segmentBack.w < layerReach.x);
      value = up ? layerReach.y : layerReach.x;
      float change = segmentBack.w - segmentFront.w;
      place = !crosses ? 1.0 : change == 0.0 ? passedPlace : clamp((value - segmentFront.w) / change, passedPlace, 1.0);
      outcome = crosses ? (up ? crossesUp : crossesDown) : mayGoOn;
    }
    bool hazeEnds = false;
    if (useHaze)
    {
      vec2 part = partUpTo(place, range);
      hazeEnds = part.y > part.x && part.y > hazeTo;
      if (hazeEnds && !hazeIsFresh)
      {
        outcome = leavesHaze;
        break;
      }
      hazeIsFresh = false;
    }
    if (hazeEnds) // the segment is longer
    {
      outcome = leavesHaze;
      crosses = true;
      place = clamp((hazeTo - segmentFront.x) / (segmentBack.x - segmentFront.x), passedPlace, 1.0);
      value = mix(segmentFront.w, segmentBack.w, place);
    }
    addPart(place, crosses, value, range);
    passedPlace = place;
    passedValue = value;
    if (crosses)
    {
      break;
    }
    inSegment = false;
    if (useContours && crossesNone)
    {
      layerIsKnown = false;
    }
    if (usePolygons && polygonInFace(left) > 0)
    {
      outcome = passesPolygon;
      break;
    }
    if (segmentBack.x >= range.y || walkIsLost || isOpaque() || !goOn())
    {
      outcome = rayEnds;
      break;
    }
  }
  return outcome;
}

// The surface of this contour where the walk is.
void addSurface(int contour, vec2 range)
{
  float z = mix(segmentFront.x, segmentBack.x, passedPlace);
  if (z >= range.x && z < range.y)
  {
    vec4 weights = mix(frontWeights, vec4(faceWeights(), 0.0), passedPlace);
    vec2 scalars = mix(segmentFront.yz, segmentBack.yz, passedPlace);
    scalars.x = useCellScalars ? element(cellScalars, cellNumber()).r : scalars.x;
    ivec3 table = transferTable;
    vec4 surface =
      contourSurface(contour, Crossing(ivec4(face, left), weights, scalars, (MCVCMatrix * vec4(origin + z * along, 1.0)).xyz));
    transferTable = table;
    light += (1.0 - light.a) * surface;
  }
}

// The polygon in the face that the ray is passing, across from this vertex.
void addPolygon(int opposite, vec2 range)
{
  vec4 pass = passFace();
  if (pass.x >= range.x && pass.x < range.y)
  {
    vec3 weights = faceWeights();
    ivec3 v = face;
    weights = v.x > v.y ? weights.yxz : weights; // of ascending vertices
    v = v.x > v.y ? v.yxz : v;
    weights = v.y > v.z ? weights.xzy : weights;
    v = v.y > v.z ? v.xzy : v;
    weights = v.x > v.y ? weights.yxz : weights;
    ivec3 table = transferTable;
    light += (1.0 - light.a) *
      polygonSurface(polygonInFace(opposite), weights, pass.y, (MCVCMatrix * vec4(origin + pass.x * along, 1.0)).xyz);
    transferTable = table;
  }
}

void walkInStretches(vec2 range)
{
  int outcome = usePolygons && startsAtEye == 0 ? entersMesh : mayGoOn;
  for (int i = 0; i < maximumSteps && outcome != rayEnds; ++i)
  {
    if (usePolygons && (outcome == passesPolygon || outcome == entersMesh))
    {
      bool leaves = outcome == passesPolygon;
      addPolygon(leaves ? left : next, range);
      if (leaves && (passFace().x >= range.y || walkIsLost || !goOn()))
      {
        outcome = rayEnds;
      }
    }
    if (useContours && (outcome == crossesUp || outcome == crossesDown))
    {
      bool up = outcome == crossesUp;
      addSurface(up ? contourLayerOfRay : contourLayerOfRay - 1, range);
      enterContourLayer(up ? contourLayerOfRay + 1 : contourLayerOfRay - 1);
    }
    if (useContours && outcome == findsLayer)
    {
      enterContourLayer(contourLayer(segmentFront.w));
    }
    if (useHaze && outcome == leavesHaze)
    {
      fitHazeToSegment(range);
    }
    outcome = outcome == rayEnds || isOpaque() ? rayEnds : walk(range);
  }
}

void main()
{
  // Both are linear in the pixel, so that differences to its neighbour are exact; to be taken before pixels part.
  pointStep[0] = dFdx(rayPointVSOutput);
  pointStep[1] = dFdy(rayPointVSOutput);
  directionStep[0] = dFdx(rayDirectionVSOutput);
  directionStep[1] = dFdy(rayDirectionVSOutput);
  float entry = texelFetch(entryFaces, ivec2(gl_FragCoord.xy), 0).r;
  if (startsAtEye == 0 && entry < 0.0)
  {
    discard;
  }
  if (useDepthRanges)
  {
    vec2 depths = visibleDepths();
    if (depths.x >= depths.y)
    {
      discard;
    }
  }
  unity = softwareOpenGL ? gl_FragCoord.w : 1.0;
  clear = clearRange * unity;
  keepTopology();
  keepTable();
  ivec4 boundaryFace = element(boundaryFaces, max(int(entry), 0));
  // Cameras look along axes and grids lie along them: a ray that is lost in a face tries again a little beside.
  for (int attempt = 0; attempt <= lastAttempt; ++attempt)
  {
    makeRay(besideCentre(attempt, boundaryFace.xyz));
    keepCameraLight(along);
    vec2 range = visibleRange();
    startSegments(length(mat3(MCVCMatrix) * along) * extinctionScale);
    inSegment = false;
    layerIsKnown = false;
    layerReach = vec2(0.0); // nothing is clear
    if (startsAtEye != 0)
    {
      startInEyeTetrahedron();
    }
    else
    {
      startAtFace(boundaryFace);
    }
    startHaze();
    if (stopsInSegments)
    {
      walkInStretches(range);
    }
    else
    {
      bool goesOn = true;
      if (startsAtEye != 0)
      {
        addPart(1.0, false, 0.0, range);
        goesOn = goOn();
      }
      if (goesOn)
      {
        walk(range);
      }
    }
    if (!walkIsLost)
    {
      break;
    }
  }
  gl_FragData[0] = accumulatedLight();
}
