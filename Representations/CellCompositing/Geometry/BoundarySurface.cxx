// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundarySurface.h"

#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
using Face = FaceNeighbors::Face;

struct Edge
{
  std::int32_t Low, High; // places
  std::int32_t Face;      // number in the list of boundary faces
  std::int32_t Apex;      // the place of the face that is not on the edge
  bool SameEdge(const Edge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const Edge& other) const
  {
    return std::tie(this->Low, this->High, this->Face) <
      std::tie(other.Low, other.High, other.Face);
  }
};

class Surface
{
public:
  Surface(const CellGeometry& geometry, const std::vector<Face>& boundary,
    const std::vector<std::int32_t>& places, double error)
    : Geometry(geometry)
    , Boundary(boundary)
    , Places(places)
    , Error(error)
  {
  }

  /** Whether the place does not lie outside the plane of the face. */
  bool IsInside(std::size_t face, std::int32_t place) const
  {
    const Face& f = this->Boundary[face];
    const auto p = this->Geometry.Vertices(static_cast<std::size_t>(f.Tetrahedron));
    const auto& v = tetrahedronFaces[f.Opposite];
    const auto side = [&](const Vector3& x) {
      return planeSideWithin(p[v[0]], p[v[1]], p[v[2]], { { x[0], x[1], x[2], 1.0 } }, this->Error);
    };
    const Vector3& apex = p[static_cast<std::size_t>(f.Opposite)];
    return side(this->Geometry.Position(place)) * side(apex) >= 0;
  }

  /** A few faces against all corners: most surfaces that are not convex are found out here. */
  bool LooksConvex() const
  {
    constexpr std::size_t samples = 8;
    const std::size_t step = std::max<std::size_t>(this->Boundary.size() / samples, 1);
    for (std::size_t face = 0; face < this->Boundary.size(); face += step)
    {
      for (const Face& other : this->Boundary)
      {
        for (const int k : tetrahedronFaces[other.Opposite])
        {
          const Tetrahedron& t =
            this->Geometry.Tetrahedra[static_cast<std::size_t>(other.Tetrahedron)];
          if (!this->IsInside(face, t[static_cast<std::size_t>(k)]))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  std::vector<Edge> FindEdges() const
  {
    std::vector<Edge> edges(3 * this->Boundary.size());
    forEach(this->Boundary.size(), {}, [&](std::size_t i) {
      const Face& f = this->Boundary[i];
      const Tetrahedron& t = this->Geometry.Tetrahedra[static_cast<std::size_t>(f.Tetrahedron)];
      std::int32_t place[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        place[k] = this->Places[static_cast<std::size_t>(
          t[static_cast<std::size_t>(tetrahedronFaces[f.Opposite][k])])];
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto [low, high] = std::minmax(place[(k + 1) % 3], place[(k + 2) % 3]);
        edges[3 * i + k] = { low, high, static_cast<std::int32_t>(i), place[k] };
      }
    });
    vtkSMPTools::Sort(edges.begin(), edges.end());
    return edges;
  }

private:
  const CellGeometry& Geometry;
  const std::vector<Face>& Boundary;
  const std::vector<std::int32_t>& Places;
  const double Error;
};

/** Joins what touches; counts what is left apart. */
class Pieces
{
public:
  explicit Pieces(std::size_t n)
    : Parent(n)
    , Count(n)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  void Join(std::size_t a, std::size_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Count -= a != b;
    this->Parent[std::max(a, b)] = std::min(a, b);
  }
  std::size_t GetCount() const { return this->Count; }

private:
  std::size_t Find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  std::vector<std::size_t> Parent;
  std::size_t Count;
};
}

bool isConvexSurface(const CellGeometry& geometry, const std::vector<Face>& boundary,
  const std::vector<std::int32_t>& places, double coordinateError, const Progress& progress)
{
  if (boundary.empty())
  {
    return true;
  }
  const Surface surface(geometry, boundary, places, coordinateError);
  if (!surface.LooksConvex() || !progress.Report(0.3))
  {
    return false;
  }
  const std::vector<Edge> edges = surface.FindEdges();
  if (!progress.Report(0.7))
  {
    return false;
  }
  Pieces pieces(boundary.size());
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    const bool paired = i + 1 < edges.size() && edges[i].SameEdge(edges[i + 1]) &&
      !(i + 2 < edges.size() && edges[i].SameEdge(edges[i + 2]));
    if (!paired || !surface.IsInside(static_cast<std::size_t>(edges[i].Face), edges[i + 1].Apex) ||
      !surface.IsInside(static_cast<std::size_t>(edges[i + 1].Face), edges[i].Apex))
    {
      return false;
    }
    pieces.Join(
      static_cast<std::size_t>(edges[i].Face), static_cast<std::size_t>(edges[i + 1].Face));
  }
  return pieces.GetCount() == 1;
}

} // namespace nephoscope
