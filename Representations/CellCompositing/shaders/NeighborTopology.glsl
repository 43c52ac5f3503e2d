// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of any mesh (TetrahedronNeighbors.h): their neighbours, and the four vertex numbers as one exclusive-or, which
// gives the fourth vertex when three are known.
// Constants: hasJumps.
// Four per tetrahedron, across from its vertices in ascending order: tetrahedron, -1 for none or -2 - n for boundary face n; its next vertex. Two in
// an element: buffer textures have a limited number of them.
uniform IntegerArray neighbors;
uniform IntegerArray vertexSums; // exclusive-or of the vertex numbers

int cellOf = 0; // the present tetrahedron
const bool otherPoints = false;

void keepTopology() {}

int cellNumber()
{
  return cellOf;
}

int fourthVertex(ivec3 face)
{
  return element(vertexSums, cellOf).r ^ face.x ^ face.y ^ face.z;
}

int pointOf(int vertex)
{
  return vertex;
}

// A boundary face is given by its vertices and the tetrahedron.
int enterTetrahedron(ivec4 boundaryFace, out ivec3 face)
{
  face = boundaryFace.xyz;
  cellOf = boundaryFace.w;
  return fourthVertex(face);
}

void enterPlace(ivec4 place)
{
  cellOf = place.x;
}

bool crossFace(inout ivec3 face, int left, out int next)
{
  ivec3 smaller = ivec3(lessThan(face, ivec3(left)));
  int number = smaller.x + smaller.y + smaller.z;
  ivec4 pair = element(neighbors, 2 * cellOf + (number >> 1));
  ivec2 across = (number & 1) == 0 ? pair.rg : pair.ba;
  int neighbor = across.x;
  next = across.y;
  if (neighbor < 0)
  {
    jumpFace = hasJumps ? -2 - neighbor : -1; // -1: there is nothing across
    return false;
  }
  cellOf = neighbor;
  return true;
}
