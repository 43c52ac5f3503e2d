// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeBisection.h"

#include "SmokeGeometry.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace nephoscope
{
namespace
{
struct Edge
{
  PointId A = 0; // the smaller
  PointId B = 0;

  bool operator==(const Edge& other) const { return this->A == other.A && this->B == other.B; }
};

struct EdgeHash
{
  std::size_t operator()(const Edge& edge) const
  {
    return static_cast<std::size_t>(Rank(edge.A) ^ (Rank(edge.B) << 1));
  }
};

// The longest is first; of equal ones always the same one.
struct QueuedEdge
{
  double Length = 0.0;
  Edge Ends;

  bool operator<(const QueuedEdge& other) const
  {
    return std::tie(this->Length, other.Ends.A, other.Ends.B) <
      std::tie(other.Length, this->Ends.A, this->Ends.B);
  }
};

class Bisection
{
public:
  Bisection(StreakMesh& mesh, const BisectionLimits& limits)
    : Mesh(mesh)
    , Limits(limits)
  {
    for (const HalvedEdge& edge : mesh.Front.Halved)
    {
      this->FrontMiddles.insert(edge.Middle);
    }
  }

  bool Run()
  {
    for (std::size_t t = 0; t < this->Mesh.Tetrahedra.size(); ++t)
    {
      this->QueueEdges(t);
    }
    return this->HalveAll();
  }

  std::size_t RunOnce(const std::vector<unsigned char>& marks)
  {
    this->IsOnce = true;
    for (std::size_t t = 0; t < marks.size(); ++t)
    {
      if (marks[t])
      {
        this->ForLongEdges(t, [this](const Edge& edge, double length) {
          if (this->Users.emplace(edge, std::vector<std::size_t>()).second)
          {
            this->Queue.push({ length, edge });
          }
        });
      }
    }
    for (std::size_t t = 0; t < this->Mesh.Tetrahedra.size(); ++t)
    {
      this->QueueEdges(t);
    }
    const std::size_t before = this->Mesh.Positions.size();
    this->HalveAll();
    return this->Mesh.Positions.size() - before;
  }

private:
  bool IsOnFront(PointId id) const
  {
    const StreakFront& front = this->Mesh.Front;
    return (id >= front.First && id < front.First + static_cast<PointId>(front.Count)) ||
      this->FrontMiddles.count(id) > 0;
  }

  bool HalveAll()
  {
    while (!this->Queue.empty())
    {
      const Edge edge = this->Queue.top().Ends;
      this->Queue.pop();
      const std::vector<std::size_t> users = this->TakeUsers(edge);
      if (this->Mesh.Tetrahedra.size() + users.size() > this->Limits.MaximumNumberOfTetrahedra)
      {
        return false;
      }
      this->Halve(edge, users);
    }
    return true;
  }

  template <typename Action>
  void ForLongEdges(std::size_t t, Action&& act)
  {
    const TetrahedronPoints& points = this->Mesh.Tetrahedra[t];
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = i + 1; j < 4; ++j)
      {
        const Edge edge{ std::min(points[i], points[j]), std::max(points[i], points[j]) };
        const double length = Distance(this->Mesh.Positions[static_cast<std::size_t>(edge.A)],
          this->Mesh.Positions[static_cast<std::size_t>(edge.B)]);
        if (length > this->Limits.MaximumEdgeLength && std::isfinite(length))
        {
          act(edge, length);
        }
      }
    }
  }

  void QueueEdges(std::size_t t)
  {
    this->ForLongEdges(t, [&](const Edge& edge, double length) {
      const auto place = this->IsOnce ? this->Users.find(edge)
                                      : this->Users.emplace(edge, std::vector<std::size_t>()).first;
      if (place == this->Users.end())
      {
        return; // not one of those that are halved once
      }
      if (!this->IsOnce && place->second.empty())
      {
        this->Queue.push({ length, edge });
      }
      place->second.push_back(t);
    });
  }

  // A tetrahedron may be listed twice, and may have lost the edge since.
  std::vector<std::size_t> TakeUsers(const Edge& edge)
  {
    const auto place = this->Users.find(edge);
    std::vector<std::size_t> users = std::move(place->second);
    this->Users.erase(place);
    std::sort(users.begin(), users.end());
    users.erase(std::unique(users.begin(), users.end()), users.end());
    const auto lost = [&](std::size_t t) {
      const TetrahedronPoints& points = this->Mesh.Tetrahedra[t];
      return std::find(points.begin(), points.end(), edge.A) == points.end() ||
        std::find(points.begin(), points.end(), edge.B) == points.end();
    };
    users.erase(std::remove_if(users.begin(), users.end(), lost), users.end());
    return users;
  }

  void Halve(const Edge& edge, const std::vector<std::size_t>& users)
  {
    const PointId middle = this->Mesh.AddMiddle(edge.A, edge.B);
    // A tetrahedron has at most one side on the front, so an edge between two
    // of its points is one of its edges.
    if (this->IsOnFront(edge.A) && this->IsOnFront(edge.B))
    {
      this->Mesh.Front.Halved.push_back({ edge.A, edge.B, middle });
      this->FrontMiddles.insert(middle);
    }
    for (const std::size_t t : users)
    {
      const TetrahedronPoints whole = this->Mesh.Tetrahedra[t];
      TetrahedronPoints half = whole;
      std::replace(
        this->Mesh.Tetrahedra[t].begin(), this->Mesh.Tetrahedra[t].end(), edge.A, middle);
      std::replace(half.begin(), half.end(), edge.B, middle);
      this->Mesh.Masses[t] *= 0.5;
      this->Mesh.AddTetrahedron(half, this->Mesh.Masses[t], this->Mesh.EmissionSteps[t]);
      this->QueueEdges(t);
      this->QueueEdges(this->Mesh.Tetrahedra.size() - 1);
    }
  }

  StreakMesh& Mesh;
  const BisectionLimits& Limits;
  bool IsOnce = false; // only the edges that are in the queue at first
  std::unordered_set<PointId> FrontMiddles;
  std::priority_queue<QueuedEdge> Queue;
  std::unordered_map<Edge, std::vector<std::size_t>, EdgeHash> Users;
};
}

bool BisectLongEdges(StreakMesh& mesh, const BisectionLimits& limits)
{
  return !(limits.MaximumEdgeLength > 0.0) || Bisection(mesh, limits).Run();
}

std::size_t BisectMarked(
  StreakMesh& mesh, const BisectionLimits& limits, const std::vector<unsigned char>& marks)
{
  return limits.MaximumEdgeLength > 0.0 ? Bisection(mesh, limits).RunOnce(marks) : 0;
}

FrontDivision::FrontDivision(const StreakFront& front)
{
  for (const HalvedEdge& edge : front.Halved)
  {
    this->Cuts[{ edge.A, edge.B }] = { this->Cuts.size(), edge.Middle };
  }
}

std::vector<TetrahedronPoints> FrontDivision::Divide(const TetrahedronPoints& tetrahedron) const
{
  std::vector<TetrahedronPoints> parts = { tetrahedron };
  for (std::size_t p = 0; p < parts.size();)
  {
    const auto first = this->FirstCut(parts[p]);
    if (first == this->Cuts.end())
    {
      ++p;
      continue;
    }
    TetrahedronPoints half = parts[p];
    std::replace(parts[p].begin(), parts[p].end(), first->first.first, first->second.Middle);
    std::replace(half.begin(), half.end(), first->first.second, first->second.Middle);
    parts.push_back(half);
  }
  return parts;
}

// The edge of the tetrahedron that was halved before its others; the end if
// there is none.
auto FrontDivision::FirstCut(const TetrahedronPoints& points) const -> CutMap::const_iterator
{
  auto first = this->Cuts.end();
  for (std::size_t i = 0; i < 4 && !this->Cuts.empty(); ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      const auto cut = this->Cuts.find(std::minmax({ points[i], points[j] }));
      const bool isEarlier = cut != this->Cuts.end() &&
        (first == this->Cuts.end() || cut->second.Order < first->second.Order);
      first = isEarlier ? cut : first;
    }
  }
  return first;
}
}
