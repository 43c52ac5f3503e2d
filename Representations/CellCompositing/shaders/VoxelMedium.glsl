// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One of several media along a ray, from cell to cell of an evenly spaced grid.
uniform mat4 MCVCMatrix;
uniform vec4 eyeVC; // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1
noperspective in vec3 rayPointVSOutput; // as RayVoxels.frag.glsl has them
noperspective in vec3 rayDirectionVSOutput;
uniform int maximumSteps;
float unity = 0.0; // RayCells.frag.glsl says why uniforms are copied
bool inSegment = false;
const bool walkIsLost = false;
const bool mayOverlapItself = false;

//NEPHOSCOPE::Constants
//NEPHOSCOPE::TransferFunction
//NEPHOSCOPE::RaySegments
//NEPHOSCOPE::RayRange
//NEPHOSCOPE::CubicPieces
//NEPHOSCOPE::CameraLight
//NEPHOSCOPE::VoxelCells
//NEPHOSCOPE::MediumPieces

vec2 waysInBox = vec2(0.0);
float way = 0.0;
float piecesDone = 0.0, piecesFound = 0.0; // of the present cell

// The pieces of the next cell in which something is seen. False: there is none.
bool findSegments()
{
  for (int i = 0; i < maximumSteps && way < waysInBox.y && isInBox(); ++i)
  {
    float distance = floor(255.0 * element(clearDistances, cellNumber()).r + 0.5);
    float here = way;
    vec3 present = cell;
    way = leap(here, max(distance, 1.0));
    if (distance == 0.0)
    {
      vec3 following = cell;
      cell = present;
      readCell(vec2(here, min(way, waysInBox.y)), false);
      cell = following;
      piecesDone = 0.0;
      piecesFound = numberOfPieces;
      return true;
    }
  }
  return false;
}

bool hasSegments()
{
  return piecesDone < piecesFound;
}

void takeSegment()
{
  sampleFront = vec2(scalars.x, separateOpacity ? opacityScalarsHere.x : scalars.x);
  sampleBack = vec2(scalars.y, separateOpacity ? opacityScalarsHere.y : scalars.y);
  segmentPlaces = vec2(placeAt(places.x), placeAt(places.y));
  passPiece(piecesDone);
  piecesDone += 1.0;
}

void prepareMedium()
{
  unity = softwareOpenGL ? gl_FragCoord.w : 1.0;
  keepTable();
  keepGrid();
}

void placeBeside() {} // no ray is lost

void startMedium()
{
  origin = rayPointVSOutput;
  along = normalize(rayDirectionVSOutput);
  placeMedium();
  waysInBox = wayInBox(vec2(distanceAt(max(mediumRange.x, mediaRange.x)), distanceAt(mediumRange.y)));
  way = waysInBox.x;
  cell = clamp(floor(rayStart + way * raySlope), firstCell, lastCell);
  piecesDone = piecesFound = 0.0;
}
