// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonRefinement.h"

#include "PolygonShape.h"
#include "TriangleEdges.h"

namespace nephoscope
{
namespace
{
constexpr int maximumPasses = 100; // of swapping; a handful suffices

// An inner edge a b with the triangles a b c and b a d beside it.
struct Diamond
{
  std::size_t First, Second; // triangles
  PointId A, B, C, D;
};

class DiagonalSwapper
{
public:
  DiagonalSwapper(PolygonMesh& mesh, double longest)
    : Mesh(mesh)
    , Longest(longest)
  {
  }

  // Every triangle is changed once at most. Returns the number of swaps.
  std::size_t Pass()
  {
    const auto& triangles = this->Mesh.Triangles;
    this->Edges.Build(triangles.size(),
      [&triangles](std::size_t t) -> const TrianglePoints& { return triangles[t]; });
    std::vector<std::array<std::size_t, 2>> beside(this->Edges.Size(), { { none, none } });
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      for (std::size_t e : this->Edges.Of[t])
      {
        beside[e][beside[e][0] != none] = t;
      }
    }
    this->Changed.assign(triangles.size(), 0);
    std::size_t swaps = 0;
    for (std::size_t e = 0; e < this->Edges.Size(); ++e)
    {
      if (this->Edges.Uses[e] == 2 && !this->Changed[beside[e][0]] && !this->Changed[beside[e][1]])
      {
        swaps += this->TrySwap(beside[e][0], beside[e][1], e);
      }
    }
    return swaps;
  }

private:
  static constexpr std::size_t none = ~std::size_t{ 0 };

  const Vector3& Point(PointId p) const { return this->Mesh.Points[static_cast<std::size_t>(p)]; }

  bool TrySwap(std::size_t first, std::size_t second, std::size_t edge)
  {
    Diamond d{ first, second, 0, 0, 0, 0 };
    if (!this->MakeDiamond(edge, d) || !this->IsBetterSwapped(d))
    {
      return false;
    }
    this->Mesh.Triangles[first] = { { d.A, d.D, d.C } };
    this->Mesh.Triangles[second] = { { d.D, d.B, d.C } };
    this->Changed[first] = this->Changed[second] = 1;
    return true;
  }

  // False if the triangles are turned against each other.
  bool MakeDiamond(std::size_t edge, Diamond& d) const
  {
    const std::size_t i = this->Place(d.First, edge), j = this->Place(d.Second, edge);
    const auto& one = this->Mesh.Triangles[d.First];
    const auto& other = this->Mesh.Triangles[d.Second];
    d.A = one[i];
    d.B = one[(i + 1) % 3];
    d.C = one[(i + 2) % 3];
    d.D = other[(j + 2) % 3];
    return other[j] == d.B && d.C != d.D;
  }

  std::size_t Place(std::size_t triangle, std::size_t edge) const
  {
    const auto& edges = this->Edges.Of[triangle];
    return static_cast<std::size_t>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
  }

  bool IsBetterSwapped(const Diamond& d) const
  {
    const Vector3 &a = this->Point(d.A), &b = this->Point(d.B), &c = this->Point(d.C),
                  &e = this->Point(d.D);
    if (this->Longest > 0.0 && Distance(c, e) > this->Longest)
    {
      return false;
    }
    // The sine of the sum of the angles at c and d, times the lengths of their arms.
    const double sine =
      Norm(Cross(a - c, b - c)) * Dot(a - e, b - e) + Norm(Cross(a - e, b - e)) * Dot(a - c, b - c);
    const double lengths = Distance(a, c) * Distance(b, c) * Distance(a, e) * Distance(b, e);
    const Vector3 area = AreaVector(a, b, c) + AreaVector(b, a, e);
    const double least = 1e-9 * Dot(area, area);
    return sine < -1e-9 * lengths && Dot(AreaVector(a, e, c), area) > least &&
      Dot(AreaVector(e, b, c), area) > least;
  }

  PolygonMesh& Mesh;
  double Longest;
  TriangleEdges Edges;
  std::vector<unsigned char> Changed;
};

// Returns the number of halved edges.
std::size_t HalveOnce(PolygonMesh& mesh, double longest)
{
  TriangleEdges edges;
  edges.Build(mesh.Triangles.size(),
    [&mesh](std::size_t t) -> const TrianglePoints& { return mesh.Triangles[t]; });
  std::vector<PointId> middles(edges.Size(), noPoint);
  const std::size_t count = mesh.Points.size();
  for (std::size_t e = 0; e < edges.Size(); ++e)
  {
    const Vector3 a = mesh.Points[static_cast<std::size_t>(edges.Points[e][0])];
    const Vector3 b = mesh.Points[static_cast<std::size_t>(edges.Points[e][1])];
    if (Distance(a, b) > longest)
    {
      middles[e] = static_cast<PointId>(mesh.Points.size());
      mesh.Points.push_back(Midpoint(a, b));
    }
  }
  std::vector<TrianglePoints> triangles;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& e = edges.Of[t];
    const DividedTriangle divided =
      DivideTriangle(mesh.Triangles[t], { { middles[e[0]], middles[e[1]], middles[e[2]] } });
    triangles.insert(
      triangles.end(), divided.Triangles.begin(), divided.Triangles.begin() + divided.Count);
  }
  mesh.Triangles.swap(triangles);
  return mesh.Points.size() - count;
}
}

void SwapToDelaunay(PolygonMesh& mesh, double longest)
{
  DiagonalSwapper swapper(mesh, longest);
  for (int pass = 0; pass < maximumPasses && swapper.Pass() > 0; ++pass)
  {
  }
}

bool HalveLongEdges(PolygonMesh& mesh, double longest, std::size_t maximumNumberOfTriangles)
{
  // A hair longer is no longer: the sides of a polygon that was made to measure stay whole.
  const double limit = (1.0 + 1e-9) * longest;
  while (longest > 0.0 && HalveOnce(mesh, limit) > 0)
  {
    if (mesh.Triangles.size() > maximumNumberOfTriangles)
    {
      return false;
    }
    SwapToDelaunay(mesh, 0.0);
  }
  return true;
}
}
