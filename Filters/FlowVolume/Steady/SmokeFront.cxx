// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeFront.h"

#include "SmokeGeometry.h"

namespace nephoscope
{
std::vector<std::array<PointId, 2>> SmokeFront::HalveEdges(
  const std::vector<unsigned char>& marks, PointId firstId)
{
  std::vector<PointId> middles(this->Edges.Size(), noPoint);
  std::vector<std::array<PointId, 2>> halved;
  for (std::size_t e = 0; e < marks.size(); ++e)
  {
    if (!marks[e])
    {
      continue;
    }
    const auto a = static_cast<std::size_t>(this->Edges.Points[e][0]);
    const auto b = static_cast<std::size_t>(this->Edges.Points[e][1]);
    middles[e] = static_cast<PointId>(this->Positions.size());
    this->Positions.push_back(Midpoint(this->Positions[a], this->Positions[b]));
    this->Hints.push_back(CellHint(this->Hints[a]));
    this->Directions.push_back(Normalized(this->Directions[a] + this->Directions[b]));
    this->Ids.push_back(firstId + static_cast<PointId>(halved.size()));
    halved.push_back({ { this->Ids[a], this->Ids[b] } });
  }
  const auto id = [this](PointId point) {
    return point == noPoint ? noPoint : this->Ids[static_cast<std::size_t>(point)];
  };
  std::vector<FrontTriangle> triangles;
  triangles.reserve(this->Triangles.size() + 2 * halved.size());
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    FrontTriangle piece = this->Triangles[t];
    const TrianglePoints p = piece.Points;
    const auto& edges = this->Edges.Of[t];
    const TrianglePoints m = { { middles[edges[0]], middles[edges[1]], middles[edges[2]] } };
    const DividedTriangle divided = DivideTriangle(
      p, m, { { id(p[0]), id(p[1]), id(p[2]) } }, { { id(m[0]), id(m[1]), id(m[2]) } });
    for (std::size_t i = 0; i < static_cast<std::size_t>(divided.Count); ++i)
    {
      piece.Points = divided.Triangles[i];
      piece.Mass = divided.Shares[i] * this->Triangles[t].Mass;
      triangles.push_back(piece);
    }
  }
  this->Triangles.swap(triangles);
  this->BuildEdges();
  return halved;
}

void SmokeFront::Compact()
{
  std::vector<PointId> places(this->Positions.size(), noPoint);
  for (const FrontTriangle& triangle : this->Triangles)
  {
    for (PointId point : triangle.Points)
    {
      places[static_cast<std::size_t>(point)] = 0;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] != noPoint)
    {
      places[i] = static_cast<PointId>(count);
      this->Positions[count] = this->Positions[i];
      this->Ids[count] = this->Ids[i];
      this->Hints[count] = this->Hints[i];
      this->Directions[count++] = this->Directions[i];
    }
  }
  this->Positions.resize(count);
  this->Ids.resize(count);
  this->Hints.resize(count);
  this->Directions.resize(count);
  for (FrontTriangle& triangle : this->Triangles)
  {
    for (PointId& point : triangle.Points)
    {
      point = places[static_cast<std::size_t>(point)];
    }
  }
}
}
