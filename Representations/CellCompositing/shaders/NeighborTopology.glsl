// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of any mesh (TetrahedronNeighbors.h), 16 bytes each: the exclusive-or of the four vertex numbers, which gives the fourth vertex when
// three are known, and that of the neighbour across from the last vertex in ascending order with each of the three others, which gives all
// neighbours when one is known: the one where the walk comes from. A neighbour is four times a number: that of a
// tetrahedron, plus the rank that the vertex across from the face has there; or -1 for none, or -2 - n for boundary face n or n + 1.
// Constants: hasJumps.
uniform IntegerArray tetrahedronLinks;

int cellOf = 0;         // the present tetrahedron
ivec4 links = ivec4(0); // of it
int lastNeighbor = 0;   // across from its last vertex
const int nothingAcross = -4;
int cameThrough = nothingAcross; // what a boundary face has across from it, through which the walk is about to come
const bool otherPoints = false;

void keepTopology() {}

int cellNumber()
{
  return cellOf;
}

// Position of a vertex among those of the present tetrahedron in ascending order; `face`: the three others.
int rankOf(int vertex, ivec3 face)
{
  ivec3 smaller = ivec3(lessThan(face, ivec3(vertex)));
  return smaller.x + smaller.y + smaller.z;
}

// Leads from the last neighbour to that of another rank, and back.
int linkOf(int rank)
{
  return rank == 0 ? links.y : rank == 1 ? links.z : rank == 2 ? links.w : 0;
}

// Goes into a tetrahedron; returns the vertex that is not in the face.
int enter(int tetrahedron, ivec3 face)
{
  cellOf = tetrahedron;
  links = element(tetrahedronLinks, tetrahedron);
  return links.x ^ face.x ^ face.y ^ face.z;
}

int pointOf(int vertex)
{
  return vertex;
}

// A boundary face is given by its vertices and the tetrahedron.
int enterTetrahedron(ivec4 boundaryFace, out ivec3 face)
{
  face = boundaryFace.xyz;
  int ahead = enter(boundaryFace.w, face);
  lastNeighbor = cameThrough ^ linkOf(rankOf(ahead, face));
  cameThrough = nothingAcross;
  return ahead;
}

// A tetrahedron is given by its number, and one of its neighbours with the rank of the vertex across from it.
void enterPlace(ivec4 place)
{
  cellOf = place.x;
  links = element(tetrahedronLinks, cellOf);
  lastNeighbor = place.y ^ linkOf(place.z);
}

bool crossFace(inout ivec3 face, int left, out int next)
{
  int rank = rankOf(left, face);
  int neighbor = lastNeighbor ^ linkOf(rank);
  if (neighbor < 0)
  {
    jumpFace = hasJumps ? -2 - (neighbor >> 2) : -1; // -1: there is nothing across
    if (hasJumps && jumpFace >= 0)
    {
      cameThrough = neighbor;
      jumpFace += element(boundaryFaces, jumpFace).w == cellOf ? 1 : 0; // the face of the other side
    }
    return false;
  }
  int from = (cellOf << 2) | rank;
  next = enter(neighbor >> 2, face);
  lastNeighbor = from ^ linkOf(neighbor & 3);
  return true;
}
