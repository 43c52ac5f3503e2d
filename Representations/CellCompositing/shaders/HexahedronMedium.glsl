// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One of several media along a ray, from hexahedron to hexahedron. It follows the parts of RayHexahedra.frag.glsl, whose walk it takes.
bool inSegment = false;
const bool mayOverlapItself = true;

//NEPHOSCOPE::MediumPieces
//NEPHOSCOPE::MediumBeside

// Crosses the next cell in which something is seen. False: there is none.
bool crossNextCell(vec2 range)
{
  bool inside = !walkIsLost && (!cellIsDone || ringPass.x < range.y);
  bool found = false;
  for (int i = 0; i < maximumSteps && inside && !found; ++i)
  {
    if (findCell(range, inside))
    {
      crossCell();
      found = ringPass.x > range.x;
      cellIsDone = !found;
    }
  }
  return found;
}

bool findSegments()
{
  inCell = crossNextCell(vec2(distanceAt(max(mediumRange.x, mediaRange.x)), distanceAt(mediumRange.y)));
  return inCell;
}

bool hasSegments()
{
  return inCell;
}

void takeSegment()
{
  float to = endOfPiece(numberOfPieces);
  vec3 back = placeInPieces(to);
  sampleFront = pieceFront.yz;
  sampleBack = back.yz;
  segmentPlaces = vec2(placeAt(pieceFront.x), placeAt(back.x));
  pieceFront = back;
  partOfCell = to;
  inCell = to < 1.0;
  cellIsDone = !inCell;
}

void startMedium()
{
  makeRay(beside);
  placeMedium();
  ringIsKnown = layerIsKnown = inCell = walkIsLost = false;
  layerReach = vec2(0.0);
  cellIsDone = false;
  int face_ = faceOfFloat(entered[mediumNumber]);
  if (face_ == -2)
  {
    walkIsLost = !startInEyeCell();
  }
  else if (face_ >= 0)
  {
    enterFace(element(boundaryFaces, face_));
    walkIsLost = !seeRing();
  }
}
