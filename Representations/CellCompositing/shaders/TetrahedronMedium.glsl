// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One of several media along a ray, from tetrahedron to tetrahedron. It follows the parts of RayCells.frag.glsl, whose walk it takes.
const bool mayOverlapItself = true;
//NEPHOSCOPE::MediumPieces

float farthestBeside(ivec3 triangle)
{
  return 1.0;
}

//NEPHOSCOPE::MediumBeside

bool mustGoOn = false; // from the tetrahedron of the present segment
bool isFound = false;  // a tetrahedron is found whose segment is still to be taken

bool hasSegments()
{
  return isFound;
}

void takeSegment()
{
  isFound = false;
  sampleFront = segmentFront.yz;
  sampleBack = segmentBack.yz;
  if (useCellScalars)
  {
    sampleFront.x = sampleBack.x = element(cellScalars, cellNumber()).r;
  }
  if (!separateOpacity)
  {
    sampleFront.y = sampleFront.x;
    sampleBack.y = sampleBack.x;
  }
  else if (opacityOnCells)
  {
    sampleFront.y = sampleBack.y = element(opacityScalars, cellNumber()).r;
  }
  segmentPlaces = vec2(placeAt(segmentFront.x), placeAt(segmentBack.x));
}

// Walks to the next tetrahedron in which something is seen. False: there is none.
bool findSegments()
{
  float begin = distanceAt(max(mediumRange.x, mediaRange.x));
  float end = distanceAt(mediumRange.y);
  if (mustGoOn && (segmentBack.x >= end || walkIsLost || !goOn()))
  {
    return false;
  }
  for (int i = 0; i < maximumSteps; ++i)
  {
    Seen ahead = seen(next);
    if (isClear(ahead) || isHidden())
    {
      leaveTetrahedron(ahead);
    }
    else
    {
      crossTetrahedron(ahead);
      inSegment = false;
      isFound = segmentBack.x > begin;
      if (isFound)
      {
        mustGoOn = true;
        return true;
      }
    }
    if (walkIsLost || !goOn() || lesser(walkA.place.z, lesser(walkB.place.z, walkC.place.z)) >= end)
    {
      return false;
    }
  }
  return false;
}

void startMedium()
{
  makeRay(beside);
  placeMedium();
  mustGoOn = walkIsLost = layerIsKnown = isFound = false;
  jumpFace = -1;
  int face_ = faceOfFloat(entered[mediumNumber]);
  if (face_ >= 0)
  {
    startAtFace(element(boundaryFaces, face_));
  }
  else if (face_ == -2)
  {
    startInEyeTetrahedron();
    takeSegment();
    startPieces();
    pieceTo = segmentPlaces.x;
    inSegment = !isHidden();
    mustGoOn = true;
  }
}
