// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeMerging.h"

#include "SmokeGeometry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace nephoscope
{
namespace
{
constexpr double flattest = 0.9961946980917455; // cosine of 5 degrees
// Thickness of a tetrahedron that merging makes: eddies would soon turn thinner ones over.
constexpr double thinnest = 0.05;
constexpr double nearlyEqual = 1e-3; // change of a volume

using Face = std::array<PointId, 3>; // sorted

Face FaceOf(PointId a, PointId b, PointId c)
{
  Face face = { { a, b, c } };
  std::sort(face.begin(), face.end());
  return face;
}

struct FaceHash
{
  std::size_t operator()(const Face& face) const
  {
    return static_cast<std::size_t>(Rank(face[0]) ^ (Rank(face[1]) << 1) ^ (Rank(face[2]) << 2));
  }
};

class Merging
{
public:
  Merging(StreakMesh& mesh, const MergingLimits& limits)
    : Mesh(mesh)
    , Limits(limits)
    , Around(mesh.Positions.size())
    , Fixed(mesh.Positions.size(), 0)
    , OnSurface(mesh.Positions.size(), 0)
    , Touched(mesh.Positions.size(), 0)
    , Gone(mesh.Tetrahedra.size(), 0)
  {
    this->FindNeighbours();
    this->FixFront();
  }

  std::size_t Run()
  {
    std::size_t merged = 0;
    for (const auto& edge : this->ShortEdges())
    {
      const PointId a = std::get<1>(edge), b = std::get<2>(edge);
      merged += this->Merge(b, a) || this->Merge(a, b);
    }
    this->Mesh.Filter([this](std::size_t t) { return !this->Gone[t]; });
    return merged;
  }

private:
  using ShortEdge = std::tuple<double, PointId, PointId>;

  static std::size_t At(PointId id) { return static_cast<std::size_t>(id); }

  static bool Has(const TetrahedronPoints& points, PointId id)
  {
    return std::find(points.begin(), points.end(), id) != points.end();
  }

  void FindNeighbours()
  {
    std::unordered_map<Face, int, FaceHash> uses;
    for (std::size_t t = 0; t < this->Mesh.Tetrahedra.size(); ++t)
    {
      const TetrahedronPoints& p = this->Mesh.Tetrahedra[t];
      for (std::size_t i = 0; i < 4; ++i)
      {
        this->Around[At(p[i])].push_back(t);
        ++uses[FaceOf(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4])];
      }
    }
    for (const auto& use : uses)
    {
      for (const PointId id : use.first)
      {
        this->OnSurface[At(id)] |= use.second == 1;
      }
      if (use.second == 1)
      {
        this->Surface.insert(use.first);
      }
    }
  }

  void FixFront()
  {
    const StreakFront& front = this->Mesh.Front;
    std::fill_n(this->Fixed.begin() + front.First, front.Count, 1);
    for (const HalvedEdge& edge : front.Halved)
    {
      this->Fixed[At(edge.Middle)] = 1;
    }
  }

  std::vector<ShortEdge> ShortEdges() const
  {
    std::vector<ShortEdge> edges;
    for (const TetrahedronPoints& p : this->Mesh.Tetrahedra)
    {
      for (std::size_t i = 0; i < 4; ++i)
      {
        for (std::size_t j = 0; j < i; ++j)
        {
          const double length = this->Length(p[i], p[j]);
          if (length < this->Limits.MinimumEdgeLength)
          {
            edges.emplace_back(length, std::min(p[i], p[j]), std::max(p[i], p[j]));
          }
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  double Length(PointId a, PointId b) const
  {
    return Distance(this->Mesh.Positions[At(a)], this->Mesh.Positions[At(b)]);
  }

  // `from` moves to `to`.
  bool Merge(PointId from, PointId to)
  {
    if (this->Fixed[At(from)] || this->Touched[At(from)] || this->Touched[At(to)] ||
      !this->KeepsSheets(from, to) || !this->KeepsSurface(from, to))
    {
      return false;
    }
    double mass = 0.0, before = 0.0, after = 0.0; // of the cavity
    for (const std::size_t t : this->Around[At(from)])
    {
      const TetrahedronPoints& points = this->Mesh.Tetrahedra[t];
      mass += this->Mesh.Masses[t];
      before += std::abs(VolumeOf(points, this->Mesh.Positions));
      if (Has(points, to))
      {
        continue;
      }
      const double volume = this->VolumeAfter(points, from, to);
      if (!(volume > 0.0) || !this->KeepsLengths(points, to))
      {
        return false;
      }
      after += volume;
    }
    if (std::abs(after - before) > nearlyEqual * before)
    {
      return false;
    }
    this->Move(from, to, mass / after);
    return true;
  }

  // 0 if the tetrahedron would turn over or become a sliver.
  double VolumeAfter(const TetrahedronPoints& points, PointId from, PointId to) const
  {
    TetrahedronPoints moved = points;
    std::replace(moved.begin(), moved.end(), from, to);
    const double before = VolumeOf(points, this->Mesh.Positions);
    const double after = VolumeOf(moved, this->Mesh.Positions);
    const bool isThick = Thickness(moved) > std::min(thinnest, Thickness(points));
    return after * before > 0.0 && isThick ? std::abs(after) : 0.0;
  }

  // 1 for a regular tetrahedron, 0 for a flat one.
  double Thickness(const TetrahedronPoints& points) const
  {
    constexpr double regular = 0.11785113019775793; // volume, of edges of 1
    double longest = 0.0;
    for (std::size_t i = 1; i < 4; ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        longest = std::max(longest, this->Length(points[i], points[j]));
      }
    }
    return std::abs(VolumeOf(points, this->Mesh.Positions)) / (regular * std::pow(longest, 3.0));
  }

  bool KeepsLengths(const TetrahedronPoints& points, PointId to) const
  {
    return std::all_of(points.begin(), points.end(), [&](PointId id) {
      return !(this->Limits.MaximumEdgeLength > 0.0) ||
        this->Length(id, to) <= this->Limits.MaximumEdgeLength;
    });
  }

  // The link condition: points and edges beside both ends are
  // beside the edge itself.
  bool KeepsSheets(PointId from, PointId to) const
  {
    std::set<PointId> besideEdge, besideTo;
    std::set<std::array<PointId, 2>> edgesBesideEdge, edgesBesideTo;
    for (const std::size_t t : this->Around[At(to)])
    {
      const bool isBoth = Has(this->Mesh.Tetrahedra[t], from);
      this->AddLink(t, to, from, besideTo, edgesBesideTo);
      if (isBoth)
      {
        this->AddLink(t, to, from, besideEdge, edgesBesideEdge);
      }
    }
    std::set<PointId> besideFrom;
    std::set<std::array<PointId, 2>> edgesBesideFrom;
    for (const std::size_t t : this->Around[At(from)])
    {
      this->AddLink(t, from, to, besideFrom, edgesBesideFrom);
    }
    const auto isShared = [](const auto& all, const auto& others, const auto& known) {
      return std::any_of(all.begin(), all.end(),
        [&](const auto& item) { return others.count(item) > 0 && known.count(item) == 0; });
    };
    return !isShared(besideFrom, besideTo, besideEdge) &&
      !isShared(edgesBesideFrom, edgesBesideTo, edgesBesideEdge);
  }

  // The points and edges of a tetrahedron without two of its points.
  void AddLink(std::size_t t, PointId without, PointId other, std::set<PointId>& points,
    std::set<std::array<PointId, 2>>& edges) const
  {
    for (const PointId a : this->Mesh.Tetrahedra[t])
    {
      if (a == without || a == other)
      {
        continue;
      }
      points.insert(a);
      for (const PointId b : this->Mesh.Tetrahedra[t])
      {
        if (b > a && b != without && b != other)
        {
          edges.insert({ { a, b } });
        }
      }
    }
  }

  // A point of the surface moves along it, and only where that is flat.
  bool KeepsSurface(PointId from, PointId to) const
  {
    if (!this->OnSurface[At(from)])
    {
      return true;
    }
    const auto atFrom = this->SurfaceAt(from), atTo = this->SurfaceAt(to);
    std::set<PointId> nearFrom, nearTo, shared;
    int beside = 0;
    for (const Face& face : atFrom)
    {
      nearFrom.insert(face.begin(), face.end());
      const bool vanishes = std::find(face.begin(), face.end(), to) != face.end();
      beside += vanishes;
      if (!vanishes && !this->StaysFlat(face, from, to))
      {
        return false;
      }
    }
    for (const Face& face : atTo)
    {
      nearTo.insert(face.begin(), face.end());
    }
    std::set_intersection(nearFrom.begin(), nearFrom.end(), nearTo.begin(), nearTo.end(),
      std::inserter(shared, shared.end()));
    constexpr std::size_t endsAndTips = 4; // of the two triangles at the edge
    return beside == 2 && shared.size() == endsAndTips;
  }

  std::vector<Face> SurfaceAt(PointId id) const
  {
    std::vector<Face> faces;
    for (const std::size_t t : this->Around[At(id)])
    {
      const TetrahedronPoints& p = this->Mesh.Tetrahedra[t];
      for (std::size_t i = 0; i < 4; ++i)
      {
        const Face face = FaceOf(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]);
        if (p[i] != id && this->Surface.count(face) > 0)
        {
          faces.push_back(face);
        }
      }
    }
    return faces;
  }

  bool StaysFlat(const Face& face, PointId from, PointId to) const
  {
    Face moved = face;
    std::replace(moved.begin(), moved.end(), from, to);
    const auto normal = [this](const Face& f) {
      const auto& p = this->Mesh.Positions;
      return AreaVector(p[At(f[0])], p[At(f[1])], p[At(f[2])]);
    };
    const Vector3 before = normal(face), after = normal(moved);
    return Dot(before, after) > flattest * Norm(before) * Norm(after);
  }

  // Sides of layers move too: smoke that kept to its emission step would be squeezed.
  void Move(PointId from, PointId to, double density)
  {
    for (const std::size_t t : this->Around[At(from)])
    {
      TetrahedronPoints& points = this->Mesh.Tetrahedra[t];
      for (const PointId id : points)
      {
        this->Touched[At(id)] = 1;
      }
      if (Has(points, to))
      {
        this->Gone[t] = 1;
        continue;
      }
      std::replace(points.begin(), points.end(), from, to);
      this->Mesh.Masses[t] = density * std::abs(VolumeOf(points, this->Mesh.Positions));
    }
  }

  StreakMesh& Mesh;
  const MergingLimits& Limits;
  std::vector<std::vector<std::size_t>> Around; // the tetrahedra at each point
  std::vector<unsigned char> Fixed;             // on the front
  std::vector<unsigned char> OnSurface;
  std::vector<unsigned char> Touched; // beside a point that has moved
  std::vector<unsigned char> Gone;    // tetrahedra
  std::unordered_set<Face, FaceHash> Surface;
};
}

std::size_t MergeShortEdges(StreakMesh& mesh, const MergingLimits& limits)
{
  return limits.MinimumEdgeLength > 0.0 ? Merging(mesh, limits).Run() : 0;
}
}
