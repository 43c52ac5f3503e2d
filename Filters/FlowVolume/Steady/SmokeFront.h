// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The front of the smoke: the polygon, carried by the flow to a certain age, as triangles. Plain
// C++17.
#ifndef nephoscope_SmokeFront_h
#define nephoscope_SmokeFront_h

#include "SmokeMesh.h"
#include "TriangleEdges.h"

namespace nephoscope
{
struct FrontTriangle
{
  TrianglePoints Points; // of the front; counter-clockwise seen from downstream
  double Mass = 0.0;     // through the triangle, per second
  double Density = 1.0;  // of the smoke just below, relative to that at the polygon
};

struct SmokeFront
{
  std::vector<Vector3> Positions;
  std::vector<PointId> Ids; // in the mesh
  std::vector<CellHint> Hints;
  std::vector<Vector3>
    Directions; // of the paths just below; unit length, or zero for a point at rest
  std::vector<FrontTriangle> Triangles;
  TriangleEdges Edges;

  void BuildEdges()
  {
    this->Edges.Build(this->Triangles.size(),
      [this](std::size_t t) -> const TrianglePoints& { return this->Triangles[t].Points; });
  }

  const Vector3& Corner(const FrontTriangle& triangle, std::size_t i) const
  {
    return this->Positions[static_cast<std::size_t>(triangle.Points[i])];
  }

  // Halves the marked edges (one mark for each edge) and divides the triangles beside them. Each
  // new point lies on its straight edge, so no gap opens, and gets the ids from `firstId` on.
  // Returns the new points' edges, by mesh ids.
  std::vector<std::array<PointId, 2>> HalveEdges(
    const std::vector<unsigned char>& marks, PointId firstId);

  // Forgets the points that no triangle uses.
  void Compact();
};
}

#endif
