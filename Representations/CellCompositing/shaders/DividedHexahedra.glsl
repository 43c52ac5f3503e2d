// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of unstructured hexahedra that are divided as the cells of a grid are (ChessboardGrid.h), without any list of them: that of the
// four even vertices, and one at each odd vertex. The vertices of the walk are corners of the present cell by bits (HexahedronCells.h): along an axis
// from a corner is its exclusive-or with the axis. Odd corners have an odd number of bits.
uniform IntegerArray hexahedra; // eight vertices per cell
uniform IntegerArray neighbors; // six per cell, -1 for none (HexahedronNeighbors.cxx)

int cellOf = 0;           // the present cell
int oddVertex = -1;       // of the present tetrahedron; -1: the one between even vertices
bool otherPoints = false; // the cell has other points, at the same places, in the face through which the walk has come

void keepTopology() {}

int cellNumber()
{
  return cellOf;
}

int pointOf(int vertex)
{
  return element(hexahedra, 8 * cellOf + vertex).r;
}

// A boundary face comes with four times (eight times its cell plus its odd corner) plus its axis.
int enterTetrahedron(ivec4 boundaryFace, out ivec3 face)
{
  int axis = 1 << (boundaryFace.w & 3);
  oddVertex = (boundaryFace.w >> 2) & 7;
  cellOf = boundaryFace.w >> 5;
  face = ivec3(oddVertex, oddVertex ^ (axis == 1 ? 2 : 1), oddVertex ^ (axis == 4 ? 2 : 4));
  return oddVertex ^ axis;
}

void enterPlace(ivec4 place)
{
  cellOf = place.x;
  oddVertex = place.w;
}

// For each corner of this cell, in four bits, a corner of the neighbour: the same point in their common face, and across it where this one lies
// on this side.
int turnedCorners(int link)
{
  int first = (link >> 5) & 3;
  int second = first + 1 + ((link >> 4) & 1);
  second = second > 2 ? second - 3 : second;
  return (((link >> 1) & 7) * 0x11111111) ^ (0x10101010 << first) ^ (0x11001100 << second) ^ (0x11110000 << (3 - first - second));
}

// Goes into the tetrahedron on the other side of the face `face` of the present one, whose fourth vertex is `left`. False: there is none.
bool crossFace(inout ivec3 face, int left, out int next)
{
  otherPoints = false;
  next = left ^ 7;
  bool fromMiddle = oddVertex < 0;
  if (fromMiddle || left == oddVertex)
  {
    oddVertex = fromMiddle ? next : -1;
    return true;
  }
  int axis = oddVertex ^ left;
  int link = element(neighbors, 6 * cellOf + (axis & 6) + ((oddVertex & axis) != 0 ? 1 : 0)).r;
  if (link < 0)
  {
    return false;
  }
  cellOf = link >> 7;
  otherPoints = (link & 1) != 0;
  int across = turnedCorners(link);
  face = (ivec3(across) >> (4 * face)) & 7;
  next = (across >> (4 * left)) & 7;
  oddVertex = (across >> (4 * oddVertex)) & 7;
  return true;
}
