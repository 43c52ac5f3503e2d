// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrontMerging.h"

#include "SmokeGeometry.h"

#include <iterator>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr double cosineOfStraight = 0.9961946980917455; // 5 degrees
constexpr double cosineOfFold = 0.5;                    // of a triangle against its old self

std::size_t Index(PointId point)
{
  return static_cast<std::size_t>(point);
}

class EdgeMerger
{
public:
  EdgeMerger(const SmokeFront& below, SmokeFront& above, const MergeLimits& limits, Slab& slab)
    : Below(below)
    , Above(above)
    , Limits(limits)
    , Between(slab)
  {
    slab.Patches.assign(above.Triangles.size(), -1);
    this->FindNeighbors();
  }

  std::size_t Merge(const std::vector<std::size_t>& candidates)
  {
    std::size_t merged = 0;
    for (std::size_t edge : candidates)
    {
      const PointId a = this->Above.Edges.Points[edge][0], b = this->Above.Edges.Points[edge][1];
      merged += this->CollectRing(a, b) && this->IsSimple(edge, a, b) && this->TryEnds(edge, a, b);
    }
    return merged;
  }

private:
  // The triangles around every point, and how many edges of the boundary end there.
  void FindNeighbors()
  {
    const std::size_t count = this->Above.Positions.size();
    this->Starts.assign(count + 1, 0);
    this->BoundaryEdges.assign(count, 0);
    for (const FrontTriangle& triangle : this->Above.Triangles)
    {
      for (PointId point : triangle.Points)
      {
        ++this->Starts[Index(point) + 1];
      }
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Around.resize(this->Starts.back());
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    for (std::size_t t = 0; t < this->Above.Triangles.size(); ++t)
    {
      for (PointId point : this->Above.Triangles[t].Points)
      {
        this->Around[next[Index(point)]++] = t;
      }
    }
    for (std::size_t e = 0; e < this->Above.Edges.Size(); ++e)
    {
      for (PointId point : this->Above.Edges.Points[e])
      {
        this->BoundaryEdges[Index(point)] += this->Above.Edges.Uses[e] != 2;
      }
    }
  }

  // The triangles around both ends; false if one cannot change.
  bool CollectRing(PointId a, PointId b)
  {
    this->Ring.clear();
    for (PointId end : { a, b })
    {
      for (std::size_t i = this->Starts[Index(end)]; i < this->Starts[Index(end) + 1]; ++i)
      {
        this->Ring.push_back(this->Around[i]);
      }
    }
    std::sort(this->Ring.begin(), this->Ring.end());
    this->Ring.erase(std::unique(this->Ring.begin(), this->Ring.end()), this->Ring.end());
    return std::none_of(this->Ring.begin(), this->Ring.end(),
      [this](std::size_t t) { return this->Between.Patches[t] >= 0; });
  }

  // A point at rest is part of older layers too. The ends' common neighbours must be the tips of
  // the triangles beside the edge, or two sheets would be glued together.
  bool IsSimple(std::size_t edge, PointId a, PointId b)
  {
    if (this->IsAtRest(a) || this->IsAtRest(b) || this->Above.Edges.Uses[edge] > 2)
    {
      return false;
    }
    const std::vector<PointId> one = this->Neighbors(a), other = this->Neighbors(b);
    std::vector<PointId> common;
    std::set_intersection(
      one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(common));
    return common.size() == this->Above.Edges.Uses[edge] && this->Ring.size() > common.size();
  }

  bool IsAtRest(PointId point) const
  {
    return this->Above.Ids[Index(point)] == this->Below.Ids[Index(point)];
  }

  std::vector<PointId> Neighbors(PointId point) const
  {
    std::vector<PointId> neighbors;
    for (std::size_t i = this->Starts[Index(point)]; i < this->Starts[Index(point) + 1]; ++i)
    {
      for (PointId corner : this->Above.Triangles[this->Around[i]].Points)
      {
        if (corner != point)
        {
          neighbors.push_back(corner);
        }
      }
    }
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    return neighbors;
  }

  bool TryEnds(std::size_t edge, PointId a, PointId b)
  {
    const Vector3 p = this->Above.Positions[Index(a)], q = this->Above.Positions[Index(b)];
    const bool aOnBoundary = this->BoundaryEdges[Index(a)] > 0;
    const bool bOnBoundary = this->BoundaryEdges[Index(b)] > 0;
    if (!aOnBoundary && !bOnBoundary)
    {
      return this->TryMerge(a, b, Midpoint(p, q));
    }
    if (aOnBoundary != bOnBoundary)
    {
      return aOnBoundary ? this->TryMerge(a, b, p) : this->TryMerge(b, a, q);
    }
    return this->Above.Edges.Uses[edge] == 1 &&
      ((this->IsStraight(b, a) && this->TryMerge(a, b, p)) ||
        (this->IsStraight(a, b) && this->TryMerge(b, a, q)));
  }

  // Whether the boundary goes straight on through `point` as it comes from its neighbour `from`.
  bool IsStraight(PointId point, PointId from) const
  {
    if (this->BoundaryEdges[Index(point)] != 2)
    {
      return false;
    }
    const Vector3& here = this->Above.Positions[Index(point)];
    const Vector3 in = Normalized(here - this->Above.Positions[Index(from)]);
    for (std::size_t i = this->Starts[Index(point)]; i < this->Starts[Index(point) + 1]; ++i)
    {
      const std::size_t t = this->Around[i];
      for (std::size_t edge : this->Above.Edges.Of[t])
      {
        const auto& ends = this->Above.Edges.Points[edge];
        const PointId to = ends[0] == point ? ends[1] : ends[0];
        if (this->Above.Edges.Uses[edge] == 1 && (ends[0] == point || ends[1] == point) &&
          to != from)
        {
          return Dot(in, Normalized(this->Above.Positions[Index(to)] - here)) > cosineOfStraight;
        }
      }
    }
    return false;
  }

  bool TryMerge(PointId kept, PointId removed, const Vector3& position)
  {
    const Vector3 old = this->Above.Positions[Index(kept)];
    std::vector<Vector3> normals;
    for (std::size_t t : this->Ring)
    {
      normals.push_back(this->Normal(t));
    }
    this->Above.Positions[Index(kept)] = position;
    this->Between.TopOf[Index(removed)] = kept;
    bool good = true;
    for (std::size_t i = 0; good && i < this->Ring.size(); ++i)
    {
      good = this->IsGood(this->Ring[i], normals[i]);
    }
    if (!good)
    {
      this->Above.Positions[Index(kept)] = old;
      this->Between.TopOf[Index(removed)] = removed;
      return false;
    }
    for (std::size_t t : this->Ring)
    {
      this->Between.Patches[t] = this->Between.NumberOfPatches;
    }
    ++this->Between.NumberOfPatches;
    return true;
  }

  TrianglePoints Corners(std::size_t t) const
  {
    const TrianglePoints& points = this->Above.Triangles[t].Points;
    const auto& top = this->Between.TopOf;
    return { { top[Index(points[0])], top[Index(points[1])], top[Index(points[2])] } };
  }

  Vector3 Normal(std::size_t t) const
  {
    const TrianglePoints c = this->Corners(t);
    const auto& p = this->Above.Positions;
    return AreaVector(p[Index(c[0])], p[Index(c[1])], p[Index(c[2])]);
  }

  bool IsGood(std::size_t t, const Vector3& oldNormal) const
  {
    const TrianglePoints c = this->Corners(t);
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0])
    {
      const Vector3 normal = this->Normal(t);
      if (!(Dot(normal, oldNormal) > cosineOfFold * Norm(normal) * Norm(oldNormal)))
      {
        return false;
      }
      for (std::size_t i = 0; this->Limits.Longest > 0.0 && i < 3; ++i)
      {
        const auto& p = this->Above.Positions;
        if (Distance(p[Index(c[i])], p[Index(c[(i + 1) % 3])]) > this->Limits.Longest)
        {
          return false;
        }
      }
    }
    return SmallestTetrahedron(this->Between, this->Above.Triangles[t].Points) >
      this->Between.SmallestVolume;
  }

  const SmokeFront& Below;
  SmokeFront& Above;
  MergeLimits Limits;
  Slab& Between;
  std::vector<std::size_t> Starts,
    Around; // the triangles around point i: Around[Starts[i]] up to Starts[i + 1]
  std::vector<int> BoundaryEdges;
  std::vector<std::size_t> Ring;
};

std::vector<std::size_t> ShortEdges(const SmokeFront& front, double shortest)
{
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t e = 0; e < front.Edges.Size(); ++e)
  {
    const double length = Distance(front.Positions[Index(front.Edges.Points[e][0])],
      front.Positions[Index(front.Edges.Points[e][1])]);
    if (length < shortest)
    {
      sorted.emplace_back(length, e);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> edges;
  for (const auto& edge : sorted)
  {
    edges.push_back(edge.second);
  }
  return edges;
}

// Volume that crosses a triangle, for a step: the triangle's share of the patch's mass. Never
// nothing at all, so that the mass stays whatever happens.
double Flux(const SmokeFront& front, const std::vector<Vector3>& chords, const TrianglePoints& t)
{
  const auto& p = front.Positions;
  const Vector3 area = AreaVector(p[Index(t[0])], p[Index(t[1])], p[Index(t[2])]);
  const Vector3 chord = chords[Index(t[0])] + chords[Index(t[1])] + chords[Index(t[2])];
  return std::max(Dot(area, chord), 1e-6 * Norm(area) * Norm(chord));
}
}

std::size_t MergeShortEdges(
  const SmokeFront& below, SmokeFront& above, const MergeLimits& limits, Slab& slab)
{
  const std::vector<std::size_t> edges = ShortEdges(above, limits.Shortest);
  return edges.empty() ? 0 : EdgeMerger(below, above, limits, slab).Merge(edges);
}

void RemoveMergedTriangles(SmokeFront& above, const std::vector<Vector3>& chords, const Slab& slab)
{
  const auto count = Index(slab.NumberOfPatches);
  std::vector<double> masses(count, 0.0), fluxes(count, 0.0);
  std::vector<FrontTriangle> left;
  std::vector<int> patches;
  for (std::size_t t = 0; t < above.Triangles.size(); ++t)
  {
    FrontTriangle triangle = above.Triangles[t];
    TrianglePoints& p = triangle.Points;
    for (PointId& point : p)
    {
      point = slab.TopOf[Index(point)];
    }
    const int patch = slab.Patches[t];
    if (patch >= 0)
    {
      masses[Index(patch)] += triangle.Mass;
    }
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0])
    {
      left.push_back(triangle);
      patches.push_back(patch);
    }
  }
  for (std::size_t t = 0; t < left.size(); ++t)
  {
    if (patches[t] >= 0)
    {
      left[t].Mass = Flux(above, chords, left[t].Points);
      fluxes[Index(patches[t])] += left[t].Mass;
    }
  }
  for (std::size_t t = 0; t < left.size(); ++t)
  {
    if (patches[t] >= 0)
    {
      left[t].Mass *= masses[Index(patches[t])] / fluxes[Index(patches[t])];
    }
  }
  above.Triangles.swap(left);
}
}
