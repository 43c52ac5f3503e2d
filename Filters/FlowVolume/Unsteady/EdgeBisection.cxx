// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeBisection.h"

#include "SmokeGeometry.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <unordered_map>

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
  }

  bool Run()
  {
    for (std::size_t t = 0; t < this->Mesh.Tetrahedra.size(); ++t)
    {
      this->QueueEdges(t);
    }
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

private:
  bool IsFixed(PointId id) const
  {
    return id >= this->Limits.FirstFixed &&
      id < this->Limits.FirstFixed + static_cast<PointId>(this->Limits.FixedPoints);
  }

  void QueueEdges(std::size_t t)
  {
    const TetrahedronPoints& points = this->Mesh.Tetrahedra[t];
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = i + 1; j < 4; ++j)
      {
        const Edge edge{ std::min(points[i], points[j]), std::max(points[i], points[j]) };
        const double length = Distance(this->Mesh.Positions[static_cast<std::size_t>(edge.A)],
          this->Mesh.Positions[static_cast<std::size_t>(edge.B)]);
        const bool isLong = length > this->Limits.MaximumEdgeLength && std::isfinite(length);
        if (isLong && !(this->IsFixed(edge.A) && this->IsFixed(edge.B)))
        {
          auto& users = this->Users[edge];
          if (users.empty())
          {
            this->Queue.push({ length, edge });
          }
          users.push_back(t);
        }
      }
    }
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
    const auto a = static_cast<std::size_t>(edge.A), b = static_cast<std::size_t>(edge.B);
    const PointId middle =
      this->Mesh.AddPoint(Midpoint(this->Mesh.Positions[a], this->Mesh.Positions[b]),
        this->Mesh.Hints[a], 1, 0.5 * (this->Mesh.ReleaseTimes[a] + this->Mesh.ReleaseTimes[b]));
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
  std::priority_queue<QueuedEdge> Queue;
  std::unordered_map<Edge, std::vector<std::size_t>, EdgeHash> Users;
};
}

bool BisectLongEdges(StreakMesh& mesh, const BisectionLimits& limits)
{
  return !(limits.MaximumEdgeLength > 0.0) || Bisection(mesh, limits).Run();
}
}
