// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProjectionOrder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace nephoscope
{
namespace
{
/** Larger is farther. */
double Farness(const CellGeometry& geometry, std::size_t tetrahedron, const Vector4& eye)
{
  const std::array<Vector3, 4> p = geometry.Vertices(tetrahedron);
  Vector3 d;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    d[axis] = 0.25 * (p[0][axis] + p[1][axis] + p[2][axis] + p[3][axis]) - eye[3] * eye[axis];
  }
  return eye[3] == 0.0 ? -Dot(d, { { eye[0], eye[1], eye[2] } }) : Dot(d, d);
}

/** Those that are equally far in input order. */
bool SortByCentroid(const CellGeometry& geometry, const Vector4& eye,
  std::vector<std::int32_t>& order, const Progress& progress)
{
  std::vector<float> far(geometry.Tetrahedra.size());
  const bool done = ForEachIndex(far.size(), progress,
    [&](std::size_t i) { far[i] = static_cast<float>(Farness(geometry, i, eye)); });
  vtkSMPTools::Sort(order.begin(), order.end(), [&far](std::int32_t a, std::int32_t b) {
    const float fa = far[static_cast<std::size_t>(a)], fb = far[static_cast<std::size_t>(b)];
    return fa > fb || (fa == fb && a < b);
  });
  return done;
}

/** Which tetrahedra are directly behind others, across shared faces. */
class Relations
{
public:
  Relations(const CellGeometry& geometry, const FaceNeighbors& faces)
    : Faces(faces)
    , Flags(geometry.Tetrahedra.size())
  {
  }

  bool Find(const CellGeometry& geometry, const Vector4& eye, const Progress& progress)
  {
    const double error = FindCoordinateError(geometry);
    return ForEachIndex(this->Flags.size(), progress,
      [&](std::size_t i) { this->Flags[i] = this->FlagsOf(geometry, i, eye, error); });
  }

  /** The tetrahedron behind the face opposite a vertex, or -1. */
  std::int32_t Behind(std::int32_t tetrahedron, int face) const
  {
    const std::size_t i = static_cast<std::size_t>(tetrahedron);
    return (this->Flags[i] >> face) & 1 ? this->Faces.Get(i, face) : -1;
  }

private:
  // A face hides its neighbour when the eye is on the same side of it as the tetrahedron itself.
  // Where the eye is in the plane, to within rounding, neither hides the other.
  std::uint8_t FlagsOf(
    const CellGeometry& geometry, std::size_t tetrahedron, const Vector4& eye, double error) const
  {
    const std::array<Vector3, 4> p = geometry.Vertices(tetrahedron);
    int flags = 0;
    for (int face = 0; face < 4; ++face)
    {
      const auto& f = tetrahedronFaces[face];
      const Vector3& apex = p[static_cast<std::size_t>(face)];
      const double own =
        PlaneSide(p[f[0]], p[f[1]], p[f[2]], { { apex[0], apex[1], apex[2], 1.0 } });
      const int eyeSide = PlaneSideWithin(p[f[0]], p[f[1]], p[f[2]], eye, error);
      const bool hides =
        this->Faces.Get(tetrahedron, face) != FaceNeighbors::None && eyeSide * own > 0;
      flags |= hides << face;
    }
    return static_cast<std::uint8_t>(flags);
  }

  const FaceNeighbors& Faces;
  std::vector<std::uint8_t> Flags; // per tetrahedron, bit k: what is across face k is behind it
};

/**
 * Strongly connected components of the relations, each after all that are behind it (Tarjan1972,
 * without recursion).
 */
class TopologicalSort
{
public:
  TopologicalSort(const Relations& relations, ProjectionOrder& order)
    : Behind(relations)
    , Order(order)
    , Low(order.Tetrahedra.size(), 0)
  {
  }

  /**
   * Starts from the tetrahedra in their order, and puts them in the new one. False when stopped.
   */
  bool Run(const Progress& progress)
  {
    const std::vector<std::int32_t> starts(std::move(this->Order.Tetrahedra));
    this->Order.Tetrahedra.clear();
    this->Order.Tetrahedra.reserve(starts.size());
    const bool done = ForEachInTurn(starts.size(), progress, [&](std::size_t i) {
      if (this->LowOf(starts[i]) == 0)
      {
        this->Visit(starts[i]);
      }
    });
    if (this->Order.NumberOfCycles > 0)
    {
      this->CountBroken();
    }
    return done;
  }

private:
  struct Step
  {
    std::int32_t Tetrahedron;
    int Face;
    std::uint32_t Number; // of the visit; Low falls below it except for the first of a component
  };

  std::uint32_t& LowOf(std::int32_t i) { return this->Low[static_cast<std::size_t>(i)]; }

  void Begin(std::int32_t tetrahedron)
  {
    this->LowOf(tetrahedron) = ++this->Visited;
    this->Path.push_back({ tetrahedron, 0, this->Visited });
  }

  void Visit(std::int32_t start)
  {
    this->Begin(start);
    while (!this->Path.empty())
    {
      Step& step = this->Path.back();
      if (step.Face == 4)
      {
        this->End();
        continue;
      }
      const std::int32_t self = step.Tetrahedron;
      const std::int32_t other = this->Behind.Behind(self, step.Face++);
      if (other >= 0 && this->LowOf(other) == 0)
      {
        this->Begin(other);
      }
      else if (other >= 0)
      {
        this->LowOf(self) = std::min(this->LowOf(self), this->LowOf(other));
      }
    }
  }

  void End()
  {
    const Step step = this->Path.back();
    this->Path.pop_back();
    const std::uint32_t low = this->LowOf(step.Tetrahedron);
    if (!this->Path.empty())
    {
      std::uint32_t& before = this->LowOf(this->Path.back().Tetrahedron);
      before = std::min(before, low);
    }
    this->Open.push_back(step.Tetrahedron);
    if (low == step.Number)
    {
      this->Emit(step.Number);
    }
  }

  // The component of all open ones that were visited since.
  void Emit(std::uint32_t number)
  {
    std::size_t first = this->Open.size();
    while (first > 0 && this->LowOf(this->Open[first - 1]) >= number)
    {
      --first;
    }
    const std::size_t count = this->Open.size() - first;
    for (std::size_t i = first; i < this->Open.size(); ++i)
    {
      this->LowOf(this->Open[i]) = static_cast<std::uint32_t>(-1);
      this->Order.Tetrahedra.push_back(this->Open[i]);
    }
    this->Open.resize(first);
    this->Order.NumberOfCycles += count > 1;
    this->Order.NumberOfCyclicTetrahedra += count > 1 ? static_cast<std::int64_t>(count) : 0;
  }

  void CountBroken()
  {
    std::vector<std::size_t> rank(this->Order.Tetrahedra.size());
    for (std::size_t i = 0; i < rank.size(); ++i)
    {
      rank[static_cast<std::size_t>(this->Order.Tetrahedra[i])] = i;
    }
    for (const std::int32_t front : this->Order.Tetrahedra)
    {
      for (int face = 0; face < 4; ++face)
      {
        const std::int32_t behind = this->Behind.Behind(front, face);
        this->Order.NumberOfBrokenRelations += behind >= 0 &&
          rank[static_cast<std::size_t>(behind)] > rank[static_cast<std::size_t>(front)];
      }
    }
  }

  const Relations& Behind;
  ProjectionOrder& Order;
  std::vector<std::uint32_t>
    Low; // 0: not visited; then the least visit that is reached; then the greatest number
  std::vector<Step> Path;
  std::vector<std::int32_t> Open; // whose component is not complete
  std::uint32_t Visited = 0;
};
}

bool ProjectionOrder::Sort(Kind kind, const CellGeometry& geometry, const FaceNeighbors& faces,
  const Vector4& eye, const Progress& progress)
{
  *this = ProjectionOrder();
  this->Tetrahedra.resize(geometry.Tetrahedra.size());
  std::iota(this->Tetrahedra.begin(), this->Tetrahedra.end(), 0);
  bool done =
    kind == Kind::None || SortByCentroid(geometry, eye, this->Tetrahedra, progress.Part(0, 0.4));
  if (done && kind == Kind::Topological)
  {
    Relations relations(geometry, faces);
    done = relations.Find(geometry, eye, progress.Part(0.4, 0.6)) &&
      TopologicalSort(relations, *this).Run(progress.Part(0.6, 1));
  }
  if (!done)
  {
    *this = ProjectionOrder();
  }
  return done;
}

} // namespace nephoscope
