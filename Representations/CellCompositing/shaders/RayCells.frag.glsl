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
// further: hasHiddenCells, closedGrid, hasJumps, hasOtherPoints
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

Seen seenPoint(int point)
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

Seen seen(int vertex)
{
  return seenPoint(pointOf(vertex));
}

void keepWalk()
{
  clear = clearRange * unity;
}

vec3 placeSeen(int point)
{
  return seenPoint(point).place.xyz;
}

//NEPHOSCOPE::PixelRay
//NEPHOSCOPE::RayEntry

//NEPHOSCOPE::RayTetrahedron
//NEPHOSCOPE::RayStart

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

//NEPHOSCOPE::RaySurfaces

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
  ivec4 boundaryFace = startPixel();
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
  PUT_LIGHT(light)
}
