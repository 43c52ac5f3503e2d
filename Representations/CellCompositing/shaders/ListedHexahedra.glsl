// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of an unstructured mesh as a walk through hexahedra sees them (HexahedronWalk.glsl). Vertices and axes of a cell are bits
// (HexahedronCells.h): along an axis from a vertex is its exclusive-or with the axis.
uniform IntegerArray hexahedra; // eight vertices per cell
uniform IntegerArray neighbors; // six per cell (HexahedronNeighbors.h), -1: none

int cellOf = 0;
int corner = 0;                    // the vertex A of the ring
int toB = 1, toD = 2, toAhead = 4; // axes

bool takesRingAlong = true; // into the next cell; otherwise its points are fetched anew

void keepTopology() {}

int cellNumber()
{
  return cellOf;
}

int pointOfRing(int b, int d, int ahead)
{
  return element(hexahedra, 8 * cellOf + (corner ^ (b * toB) ^ (d * toD) ^ (ahead * toAhead))).r;
}

// One of the six faces of a cell.
void enterFaceOfCell(ivec4 place, int number)
{
  cellOf = place.x;
  toAhead = 1 << (number >> 1);
  toB = toAhead == 1 ? 2 : 1;
  toD = toAhead == 4 ? 2 : 4;
  corner = (number & 1) * toAhead;
}

// A triangle of the boundary comes with eight times its cell, plus its face there.
void enterFace(ivec4 face)
{
  enterFaceOfCell(ivec4(face.w >> 3, 0, 0, 0), face.w & 7);
}

// Into the cell behind a face of this one, the ring of HexahedronWalk.glsl changed accordingly. False: there is none.
bool crossFace(int exit)
{
  int b = toB, d = toD, ahead = toAhead;
  bool besideB = exit == exitBC || exit == exitDA, besideD = exit == exitAB || exit == exitCD;
  corner ^= exit == exitAhead ? ahead : exit == exitBC ? b ^ ahead : exit == exitCD ? d ^ ahead : 0;
  toB = besideB ? ahead : b;
  toD = besideD ? ahead : d;
  int across = besideB ? b : besideD ? d : ahead;
  int link = element(neighbors, 6 * cellOf + (across >> 1) * 2 + ((corner & across) != 0 ? 1 : 0)).r;
  if (link < 0)
  {
    return false;
  }
  takesRingAlong = (link & 1) == 0;
  int numbers = link >> 4;
  cellOf = numbers / 6;
  int order = numbers - 6 * cellOf;
  int first = order >> 1;
  int second = first + 1 + (order & 1);
  int newFirst = 1 << first;
  int newSecond = 1 << (second > 2 ? second - 3 : second);
  int oldFirst = across == 1 ? 2 : 1;
  int oldSecond = across == 4 ? 2 : 4;
  corner = ((link >> 1) & 7) ^ ((corner & oldFirst) != 0 ? newFirst : 0) ^ ((corner & oldSecond) != 0 ? newSecond : 0);
  toB = toB == oldFirst ? newFirst : newSecond;
  toD = toD == oldFirst ? newFirst : newSecond;
  toAhead = 7 ^ newFirst ^ newSecond;
  return true;
}
