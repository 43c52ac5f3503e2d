// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a structured grid as a walk through hexahedra sees them (HexahedronWalk.glsl): sums of point numbers.
//NEPHOSCOPE::GridCells

int corner = 0;                       // the point A of the ring
int toB = 0, toD = 0, toAhead = 0;    // from there to its neighbours in the cell

const bool takesRingAlong = true; // into the next cell; otherwise its points are fetched anew

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

// Into the cell behind a face of this one, the ring of HexahedronWalk.glsl changed accordingly. False: there is none.
bool crossFace(int exit)
{
  int b = toB, d = toD, ahead = toAhead;
  corner += exit == exitAhead ? ahead : exit == exitBC ? b + ahead : exit == exitCD ? d + ahead : 0;
  toB = exit == exitBC ? -ahead : exit == exitDA ? ahead : b;
  toD = exit == exitAB ? ahead : exit == exitCD ? -ahead : d;
  toAhead = exit == exitAB ? -d : exit == exitBC ? b : exit == exitCD ? d : exit == exitDA ? -b : ahead;
  stepCell(toAhead);
  if (closedGrid)
  {
    int jump = jumpAround();
    corner += jump;
  }
  return mayBeSeen();
}
