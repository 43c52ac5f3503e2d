// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a structured grid without any list of them (ChessboardGrid.h says how they lie).
// A cell holds the tetrahedron of its four even vertices and, at each odd vertex, the one of that vertex and its three
// neighbours, so that the next vertex of a walk is a sum of the numbers of those at hand.
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

int oddVertex = 0;       // of the present tetrahedron; -1: the one between even vertices
vec3 cellOf = vec3(0.0); // where the present tetrahedron lies

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

// A boundary face is given by the odd vertex, the two others, and the vertex behind it.
int enterTetrahedron(ivec4 face)
{
  oddVertex = face.x;
  cellOf = min(min(pointIndex(face.x), pointIndex(face.y)), min(pointIndex(face.z), pointIndex(face.w)));
  return face.w;
}

// A tetrahedron is given by its cell, and its odd vertex or -1.
void enterPlace(ivec4 place)
{
  cellOf = vec3(place.xyz);
  oddVertex = place.w;
}

// Goes into the tetrahedron on the other side of the face `face` of the present one, whose fourth vertex is `left`. False: there is none.
bool crossFace(inout ivec3 face, int left, out int next)
{
  int sum = face.x + face.y + face.z;
  bool fromMiddle = oddVertex < 0;
  bool toMiddle = left == oddVertex;
  int ahead = oddVertex - left;
  next = fromMiddle ? (sum - left) >> 1 : toMiddle ? sum - 2 * left : oddVertex + ahead;
  oddVertex = fromMiddle ? next : toMiddle ? -1 : oddVertex;
  if (!fromMiddle && !toMiddle)
  {
    int distance = abs(ahead);
    cellOf += (ahead > 0 ? 1.0 : -1.0) * vec3(distance == 1, distance == rowStride.x, distance == rowStride.y);
  }
  if (closedGrid)
  {
    int jump = cellOf.x < 0.0 ? wrap : cellOf.x == float(wrap) ? -wrap : 0;
    cellOf.x += float(jump); // the same place, numbered at the other end
    face += jump;
    next += jump;
    oddVertex += oddVertex < 0 ? 0 : jump;
  }
  return all(greaterThanEqual(cellOf, lowest)) && all(lessThanEqual(cellOf, highest));
}
