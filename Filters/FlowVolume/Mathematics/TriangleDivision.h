// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A triangle with one, two or three of its edges halved becomes two, three or four triangles. What
// is left to choose, the diagonal of the quadrilateral beside two halved edges, starts at its
// vertex of smallest rank: the triangle and the tetrahedron below it, which divide by themselves,
// agree. Plain C++17.
#ifndef nephoscope_TriangleDivision_h
#define nephoscope_TriangleDivision_h

#include "PrismTetrahedra.h"

namespace nephoscope
{
using TrianglePoints = std::array<PointId, 3>;

constexpr PointId noPoint = -1;

struct DividedTriangle
{
  std::array<TrianglePoints, 4> Triangles;
  std::array<double, 4> Shares; // of the area
  int Count = 0;

  void Add(PointId a, PointId b, PointId c, double share)
  {
    this->Triangles[static_cast<std::size_t>(this->Count)] = { { a, b, c } };
    this->Shares[static_cast<std::size_t>(this->Count++)] = share;
  }
};

// middles[i]: the point that halves the edge from vertex i to vertex i + 1, or noPoint. `ids` are
// the numbers whose ranks decide, one for each of the three vertices and the three middles.
inline DividedTriangle DivideTriangle(const TrianglePoints& triangle, const TrianglePoints& middles,
  const std::array<PointId, 3>& vertexIds, const std::array<PointId, 3>& middleIds)
{
  const int marks =
    (middles[0] != noPoint) + 2 * (middles[1] != noPoint) + 4 * (middles[2] != noPoint);
  // Turned until the halved edges are 0; 0 and 1; or all.
  static constexpr std::size_t turns[8] = { 0, 0, 1, 0, 2, 2, 1, 0 };
  const std::size_t i = turns[marks], j = (i + 1) % 3, k = (i + 2) % 3;
  const PointId a = triangle[i], b = triangle[j], c = triangle[k];
  DividedTriangle result;
  switch (marks)
  {
    case 0:
      result.Add(a, b, c, 1.0);
      break;
    case 1:
    case 2:
    case 4:
      result.Add(a, middles[i], c, 0.5);
      result.Add(middles[i], b, c, 0.5);
      break;
    case 7:
      result.Add(a, middles[i], middles[k], 0.25);
      result.Add(middles[i], b, middles[j], 0.25);
      result.Add(middles[k], middles[j], c, 0.25);
      result.Add(middles[i], middles[j], middles[k], 0.25);
      break;
    default:
      result.Add(middles[i], b, middles[j], 0.25);
      if (std::min(Rank(vertexIds[i]), Rank(middleIds[j])) <
        std::min(Rank(middleIds[i]), Rank(vertexIds[k])))
      {
        result.Add(a, middles[i], middles[j], 0.25);
        result.Add(a, middles[j], c, 0.5);
      }
      else
      {
        result.Add(a, middles[i], c, 0.5);
        result.Add(middles[i], middles[j], c, 0.25);
      }
  }
  return result;
}

inline DividedTriangle DivideTriangle(const TrianglePoints& triangle, const TrianglePoints& middles)
{
  return DivideTriangle(triangle, middles, triangle, middles);
}
}

#endif
