// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Integrates light along a ray through the cells of an evenly spaced grid (VoxelCells.glsl).

// The first piece, cut where slices end and where the haze is fitted anew.
void addCutPiece()
{
  const float mostParts = 32.0;
  float from = places.x;
  float length = places.y - from;
  for (float part = 0.0; part < mostParts && from < places.y; part += 1.0)
  {
    if (places.y > hazeTo)
    {
      fitHaze(from, length / mostParts);
    }
    vec2 z = vec2(from, part + 1.0 == mostParts ? places.y : min(places.y, hazeTo));
    FOR_EACH_SLICE(light, z, inSlice)
    {
      vec2 parts = (inSlice - places.x) / length;
      vec2 s = mix(scalars.xx, scalars.yy, parts), o = mix(opacityScalarsHere.xx, opacityScalarsHere.yy, parts);
      vec4 before = accumulatedLight();
      addSegment(vec2(s.x, o.x), vec2(s.y, o.y), inSlice.y - inSlice.x);
      hazeAdded(before, inSlice);
    }
    from = z.y;
  }
}

void addFirstPiece()
{
  if (useHaze || inSlices)
  {
    addCutPiece();
  }
  else if (places.y > places.x)
  {
    addSegment(vec2(scalars.x, opacityScalarsHere.x), vec2(scalars.y, opacityScalarsHere.y), places.y - places.x);
  }
}

void addPieces()
{
  for (float piece = 0.0; piece < numberOfPieces; piece += 1.0)
  {
    addFirstPiece();
    passPiece(piece);
  }
}

//NEPHOSCOPE::VoxelContours

// What is seen of the ray in the present cell, up to where it goes on. False: that is not simple, or waits.
bool addCell(vec2 ways, bool isKnown, bool mustWait)
{
  readCell(ways, isKnown);
  if (useContours)
  {
    if (contourOfColor)
    {
      contourField = colorField;
    }
    else
    {
      contourField = fieldInCell(contourSquares, ways);
    }
  }
  return addThinPieces(mustWait || crossesContours());
}

float way = 0.0;

// From cell to cell, until the ray ends or a cell needs more than is done here: true. Pixels that are computed together wait there.
bool walkOn(vec2 ends, inout bool inside, inout bool isKnown)
{
  const int stepsAtOnce = useHaze ? 16 : 8;
  bool waits = false;
  for (int k = 0; k < stepsAtOnce; ++k)
  {
    float distance = floor(255.0 * element(clearDistances, cellNumber()).r + 0.5);
    float here = way;
    vec3 present = cell;
    way = leap(here, max(distance, 1.0));
    vec3 following = cell;
    bool isSeen = distance == 0.0;
    bool leavesHaze = useHaze && isSeen && min(way, ends.y) > hazeTo;
    if (leavesHaze && here > hazeFrom)
    {
      cell = present;
      way = here;
      break;
    }
    if (isSeen)
    {
      cell = present;
      waits = !addCell(vec2(here, min(way, ends.y)), isKnown, leavesHaze);
      cell = following;
    }
    isKnown = isSeen;
    inside = way < ends.y && isInBox() && !isOpaque();
    if (waits || !inside)
    {
      cellAdded = present;
      break;
    }
    layerIsKnown = false;
    axesBehind = axesAhead;
  }
  return waits;
}

// The number of the contour whose surface the ray has come to; otherwise -1.
int addWithContours(bool waits, vec2 ends)
{
  vec3 following = cell;
  cell = cellAdded;
  if (waits)
  {
    enterCell(axesBehind, way <= ends.y ? axesAhead : vec3(0.0));
    axesBehind = axesAhead;
  }
  int contour = addPiecesToSurface();
  cell = following;
  return contour;
}

void walkVoxels(vec2 range)
{
  vec2 ends = wayInBox(range);
  way = ends.x;
  bool inside = way < ends.y;
  cell = clamp(floor(rayStart + way * raySlope), firstCell, lastCell);
  bool isKnown = false;
  int contour = -1;
  for (int i = 0; i < maximumSteps && (inside || inCell); ++i)
  {
    const int cellsAtOnce = useContours ? 32 : 1; // before a surface is lit
    for (int n = 0; n < cellsAtOnce && contour < 0 && (inside || inCell); ++n)
    {
      bool waits = false;
      fitHaze(way, 0.0);
      if (!inCell)
      {
        waits = walkOn(ends, inside, isKnown);
      }
      if (useContours)
      {
        contour = addWithContours(waits, ends);
      }
      else if (waits)
      {
        addPieces();
      }
      inside = inside && !isOpaque();
    }
    if (useContours && contour >= 0)
    {
      addSurface(contour);
      contour = -1;
      inside = inside && !isOpaque();
      inCell = inCell && !isOpaque();
    }
  }
}
