// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One of several media along a ray, from hexahedron to hexahedron. It follows the parts of RayHexahedra.frag.glsl, whose walk it takes.
bool inSegment = false;
const bool mayOverlapItself = true;

//NEPHOSCOPE::MediumPieces
//NEPHOSCOPE::MediumBeside

int exitOfCell = -1; // out of the present cell

// Crosses the next cell in which something is seen. False: there is none.
bool crossNextCell(vec2 range)
{
  bool inside = !walkIsLost && (exitOfCell < 0 || (ringPass.x < range.y && goOn(exitOfCell, range)));
  exitOfCell = -1;
  for (int i = 0; i < maximumSteps && inside && exitOfCell < 0; ++i)
  {
    exitOfCell = findCell(range, inside);
    if (exitOfCell >= 0 && ringPass.x <= range.x)
    {
      inside = goOn(exitOfCell, range);
      exitOfCell = -1;
    }
  }
  return exitOfCell >= 0;
}

bool findSegment()
{
  vec2 range = vec2(distanceAt(max(mediumRange.x, mediaRange.x)), distanceAt(mediumRange.y));
  inSegment = inCell || crossNextCell(range);
  float to = endOfPiece(pieces);
  vec3 back = placeInPieces(to);
  sampleFront = pieceFront.yz;
  sampleBack = back.yz;
  segmentPlaces = vec2(placeAt(pieceFront.x), placeAt(back.x));
  pieceFront = back;
  partOfCell = to;
  inCell = inSegment && to < 1.0;
  return inSegment;
}

void startMedium()
{
  makeRay(beside);
  placeMedium();
  ringIsKnown = layerIsKnown = inCell = walkIsLost = false;
  layerReach = vec2(0.0); // nothing is clear
  exitOfCell = -1;
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
