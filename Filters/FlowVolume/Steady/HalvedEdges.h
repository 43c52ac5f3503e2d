// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra divided at the halved edges of the triangle they share with a front, so that no point
// hangs. Plain C++17.
#ifndef nephoscope_HalvedEdges_h
#define nephoscope_HalvedEdges_h

#include "TriangleDivision.h"

#include <vector>

namespace nephoscope
{
class HalvedEdges
{
public:
  // Edge `edges[i]`, by mesh ids, is halved at point `firstMiddle + i`.
  HalvedEdges(const std::vector<std::array<PointId, 2>>& edges, PointId firstMiddle)
  {
    PointId last = 0;
    this->First = firstMiddle;
    for (const auto& edge : edges)
    {
      const auto pair = std::minmax(edge[0], edge[1]);
      this->Middles.push_back(
        { pair.first, pair.second, firstMiddle + static_cast<PointId>(this->Middles.size()) });
      this->First = std::min(this->First, pair.first);
      last = std::max(last, pair.second);
    }
    std::sort(this->Middles.begin(), this->Middles.end());
    this->Ends.assign(static_cast<std::size_t>(std::max<PointId>(last - this->First + 1, 0)), 0);
    for (const auto& edge : this->Middles)
    {
      this->Ends[static_cast<std::size_t>(edge[0] - this->First)] = 1;
      this->Ends[static_cast<std::size_t>(edge[1] - this->First)] = 1;
    }
  }

  // The tetrahedron as pieces beside its face with the most halved edges: one piece if it has none.
  // All of its halved edges are in that face, unless more than three of its points are on the
  // front; then the pieces can be divided again.
  const std::vector<TetrahedronPoints>& Divide(const TetrahedronPoints& t)
  {
    static constexpr std::size_t faces[4][4] = { { 0, 1, 2, 3 }, { 0, 3, 1, 2 }, { 0, 2, 3, 1 },
      { 1, 3, 2, 0 } };
    this->Pieces.assign(1, t);
    if (this->NumberOfEnds(t) < 2)
    {
      return this->Pieces;
    }
    int most = 0;
    for (const auto& face : faces)
    {
      const TrianglePoints triangle = { { t[face[0]], t[face[1]], t[face[2]] } };
      TrianglePoints middles;
      int count = 0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        middles[i] = this->Middle(triangle[i], triangle[(i + 1) % 3]);
        count += middles[i] != noPoint;
      }
      if (count > most)
      {
        most = count;
        this->Replace(DivideTriangle(triangle, middles), t[face[3]]);
      }
    }
    return this->Pieces;
  }

private:
  bool IsEnd(PointId id) const
  {
    const PointId place = id - this->First;
    return place >= 0 && place < static_cast<PointId>(this->Ends.size()) &&
      this->Ends[static_cast<std::size_t>(place)];
  }

  int NumberOfEnds(const TetrahedronPoints& t) const
  {
    return this->IsEnd(t[0]) + this->IsEnd(t[1]) + this->IsEnd(t[2]) + this->IsEnd(t[3]);
  }

  PointId Middle(PointId a, PointId b) const
  {
    if (!this->IsEnd(a) || !this->IsEnd(b))
    {
      return noPoint;
    }
    const std::array<PointId, 3> wanted = { { std::min(a, b), std::max(a, b), 0 } };
    const auto found = std::lower_bound(this->Middles.begin(), this->Middles.end(), wanted);
    return found != this->Middles.end() && (*found)[0] == wanted[0] && (*found)[1] == wanted[1]
      ? (*found)[2]
      : noPoint;
  }

  void Replace(const DividedTriangle& base, PointId apex)
  {
    this->Pieces.clear();
    for (std::size_t i = 0; i < static_cast<std::size_t>(base.Count); ++i)
    {
      const TrianglePoints& p = base.Triangles[i];
      this->Pieces.push_back({ { p[0], p[1], p[2], apex } });
    }
  }

  std::vector<std::array<PointId, 3>> Middles; // smaller end, larger end, middle; sorted
  std::vector<unsigned char> Ends;             // by id from First on: an end of a halved edge
  PointId First = 0;
  std::vector<TetrahedronPoints> Pieces;
};
}

#endif
