// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a structured grid without any list of them (ChessboardGrid.h says how they lie).
// A cell holds the tetrahedron of its four even vertices and, at each odd vertex, the one of that vertex and its three
// neighbours, so that the next vertex of a walk is a sum of the numbers of those at hand.
//NEPHOSCOPE::GridCells

int oddVertex = 0;       // of the present tetrahedron; -1: the one between even vertices
const bool otherPoints = false;

int pointOf(int vertex)
{
  return vertex;
}

// A boundary face is given by the odd vertex, the two others, and the vertex behind it.
int enterTetrahedron(ivec4 boundaryFace, out ivec3 face)
{
  face = boundaryFace.xyz;
  cellOf = min(min(pointIndex(face.x), pointIndex(face.y)), min(pointIndex(face.z), pointIndex(boundaryFace.w)));
  oddVertex = face.x;
  return boundaryFace.w;
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
    stepCell(ahead);
  }
  if (closedGrid)
  {
    int jump = jumpAround();
    face += jump;
    next += jump;
    oddVertex += oddVertex < 0 ? 0 : jump;
  }
  return mayBeSeen();
}
