// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a structured grid as a walk through hexahedra sees them (HexahedronWalk.glsl): sums of point numbers.
// Constants: closedGrid (along the first axis).
uniform int gridStride[3]; // from a point to the next along each axis
uniform vec3 boxLow;       // of the cells that can be seen: first and
uniform vec3 boxHigh;      // last cell, inclusive
uniform int wrapCells;     // around the closed axis

// Copies (see keepUniforms).
ivec2 rowStride; // to the next point along the second and third axis
ivec2 cellRows;  // cells along the first and second axis
vec3 lowest, highest;
int wrap;

int corner = 0;                       // the point A of the ring
int toB = 0, toD = 0, toAhead = 0;    // from there to its neighbours in the cell
vec3 cellOf = vec3(0.0);

const bool takesRingAlong = true; // into the next cell; otherwise its points are fetched anew

void keepTopology()
{
  rowStride = ivec2(gridStride[1], gridStride[2]) * int(unity);
  cellRows = ivec2(gridStride[1] - 1, gridStride[2] / gridStride[1] - 1) * int(unity);
  lowest = boxLow * unity;
  highest = boxHigh * unity;
  wrap = wrapCells * int(unity);
}

int cellNumber()
{
  ivec3 c = ivec3(cellOf);
  return c.x + cellRows.x * (c.y + cellRows.y * c.z);
}

vec3 pointIndex(int point)
{
  int row = point / gridStride[1];
  int rows = gridStride[2] / gridStride[1];
  return vec3(point - row * gridStride[1], row % rows, row / rows);
}

int pointOfRing(int b, int d, int ahead)
{
  return corner + b * toB + d * toD + ahead * toAhead;
}

// A triangle of the boundary is given by the point where two edges of its quadrilateral meet, their other ends, and the point behind it.
void enterFace(ivec4 face)
{
  corner = face.x;
  toB = face.y - face.x;
  toD = face.z - face.x;
  toAhead = face.w - face.x;
  cellOf = min(min(pointIndex(face.x), pointIndex(face.y)), min(pointIndex(face.z), pointIndex(face.w)));
}

// One of the six faces of the cell that holds the eye.
void enterFaceOfCell(ivec4 place, int number)
{
  ivec3 strides = ivec3(1, rowStride);
  int axis = number >> 1;
  int side = number & 1;
  cellOf = vec3(place.xyz);
  corner = place.x + place.y * strides.y + place.z * strides.z;
  toAhead = axis == 0 ? strides.x : axis == 1 ? strides.y : strides.z;
  toB = axis == 0 ? strides.y : strides.x;
  toD = axis == 2 ? strides.y : strides.z;
  corner += side * toAhead;
  toAhead = side == 0 ? toAhead : -toAhead;
}

void turnRing()
{
  int b = toB;
  toB = toD;
  toD = b;
}

// Into the cell behind a face of this one, the ring of HexahedronWalk.glsl changed accordingly. False: there is none.
bool crossFace(int exit)
{
  int b = toB, d = toD, ahead = toAhead;
  corner += exit == exitAhead ? ahead : exit == exitBC ? b + ahead : exit == exitCD ? d + ahead : 0;
  toB = exit == exitBC ? -ahead : exit == exitDA ? ahead : b;
  toD = exit == exitAB ? ahead : exit == exitCD ? -ahead : d;
  toAhead = exit == exitAB ? -d : exit == exitBC ? b : exit == exitCD ? d : exit == exitDA ? -b : ahead;
  int distance = abs(toAhead);
  cellOf += (toAhead > 0 ? 1.0 : -1.0) * vec3(distance == 1, distance == rowStride.x, distance == rowStride.y);
  if (closedGrid)
  {
    int jump = cellOf.x < 0.0 ? wrap : cellOf.x == float(wrap) ? -wrap : 0;
    cellOf.x += float(jump); // the same place, numbered at the other end
    corner += jump;
  }
  return all(greaterThanEqual(cellOf, lowest)) && all(lessThanEqual(cellOf, highest));
}
