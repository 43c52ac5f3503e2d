// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CycleSplitter.h"

#include "StrongComponents.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
double farness(const std::array<Vector3, 4>& p, const Vector4& eye)
{
  double far = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double x = 0.25 * (p[0][axis] + p[1][axis] + p[2][axis] + p[3][axis]);
    far += eye[3] == 0 ? -x * eye[axis] : (x - eye[axis]) * (x - eye[axis]);
  }
  return far;
}

CutTetrahedron whole(const std::array<Vector3, 4>& p)
{
  CutTetrahedron t;
  for (std::size_t k = 0; k < 4; ++k)
  {
    t[k].Position = p[k];
    t[k].Weights = { { 0, 0, 0, 0 } };
    t[k].Weights[k] = 1;
  }
  return t;
}
}

CycleSplitter::CycleSplitter(const CellGeometry& geometry, const Vector4& eye,
  double coordinateError, std::size_t maximumPieces)
  : Geometry(geometry)
  , Eye(eye)
  , CoordinateError(coordinateError)
  , MaximumPieces(maximumPieces)
{
}

bool CycleSplitter::Append(const std::vector<std::int32_t>& members,
  const std::vector<Relation>& relations, CellPieces& pieces, std::vector<std::int32_t>& order,
  const Progress& progress)
{
  this->Members = &members;
  this->Pieces = &pieces;
  this->Result = &order;
  this->Listener = &progress;
  this->Finished = 0;
  this->NodeOf.assign(members.size(), -1);
  this->Mark.assign(members.size(), 0);
  this->NumberOfHalves = 0;
  Group group;
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    group.Parts.push_back({ static_cast<std::int32_t>(i), {}, {} });
  }
  group.Relations = relations;
  return this->Order(std::move(group));
}

std::array<Vector3, 4> CycleSplitter::VerticesOf(std::int32_t member) const
{
  return this->Geometry.Vertices(
    static_cast<std::size_t>((*this->Members)[static_cast<std::size_t>(member)]));
}

// A sliver as thin as this is not cut off: it would be all rounding, and out of order it cannot be seen.
double CycleSplitter::ToleranceOf(const std::array<Vector3, 4>& p) const
{
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Vector3 edge = difference(p[i], p[j]);
      longest = std::max(longest, dot(edge, edge));
    }
  }
  return std::max(2 * this->CoordinateError, 1e-5 * std::sqrt(longest));
}

bool CycleSplitter::Order(Group group)
{
  for (Group& cycle : this->FindGroups(group))
  {
    if (cycle.Parts.size() == 1)
    {
      this->Emit(cycle.Parts[0]);
    }
    else if (this->Pieces->Tetrahedra.size() >= this->MaximumPieces)
    {
      this->EmitBroken(cycle);
    }
    else
    {
      const Plane plane = this->ChoosePlane(cycle);
      Group far, near;
      this->Split(cycle, plane, far, near);
      cycle = Group();
      if (!this->Order(std::move(far)) || !this->Order(std::move(near)))
      {
        return false;
      }
    }
    if (!this->Report())
    {
      return false;
    }
  }
  return true;
}

// Nobody knows how much is left: the fraction approaches 1.
bool CycleSplitter::Report()
{
  const Clock::time_point now = Clock::now();
  if (now - this->LastReport < std::chrono::milliseconds(10))
  {
    return true;
  }
  this->LastReport = now;
  const double finished = static_cast<double>(this->Finished);
  return this->Listener->Report(finished / (static_cast<double>(this->Members->size()) + finished));
}

// The strongly connected components of the group, from back to front; takes its parts.
std::vector<CycleSplitter::Group> CycleSplitter::FindGroups(Group& group)
{
  const std::size_t n = group.Parts.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    this->NodeOf[static_cast<std::size_t>(group.Parts[i].Member)] = static_cast<std::int32_t>(i);
  }
  const auto nodeOf = [this](std::int32_t member) {
    return this->NodeOf[static_cast<std::size_t>(member)];
  };
  std::vector<std::int32_t> first(n + 1, 0), behind(group.Relations.size());
  for (const Relation& r : group.Relations)
  {
    ++first[static_cast<std::size_t>(nodeOf(r.Front)) + 1];
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    first[i + 1] += first[i];
  }
  std::vector<std::int32_t> next(first.begin(), first.end() - 1);
  for (const Relation& r : group.Relations)
  {
    behind[static_cast<std::size_t>(next[static_cast<std::size_t>(nodeOf(r.Front))]++)] =
      nodeOf(r.Behind);
  }

  std::vector<Group> groups;
  std::vector<std::size_t> groupOf(n);
  StrongComponents components;
  components.Find(
    n, {},
    [&](std::int32_t node, std::int32_t& cursor) {
      const std::int32_t at = first[static_cast<std::size_t>(node)] + cursor;
      return at < first[static_cast<std::size_t>(node) + 1]
        ? (++cursor, behind[static_cast<std::size_t>(at)])
        : -1;
    },
    [&](std::int32_t* begin, std::int32_t* end) {
      std::sort(begin, end);
      groups.emplace_back();
      for (std::int32_t* node = begin; node != end; ++node)
      {
        groupOf[static_cast<std::size_t>(*node)] = groups.size() - 1;
        groups.back().Parts.push_back(std::move(group.Parts[static_cast<std::size_t>(*node)]));
      }
    });
  for (const Relation& r : group.Relations)
  {
    const std::size_t g = groupOf[static_cast<std::size_t>(nodeOf(r.Front))];
    if (g == groupOf[static_cast<std::size_t>(nodeOf(r.Behind))])
    {
      groups[g].Relations.push_back(r);
    }
  }
  return groups;
}

Plane CycleSplitter::FindPlane(const Relation& relation) const
{
  const auto p = this->VerticesOf(relation.Front);
  const auto& f = tetrahedronFaces[relation.Opposite];
  Vector3 normal = cross(difference(p[f[1]], p[f[0]]), difference(p[f[2]], p[f[0]]));
  const double apex =
    dot(normal, difference(p[static_cast<std::size_t>(relation.Opposite)], p[f[0]]));
  const double scale = (apex > 0 ? 1 : -1) / std::sqrt(dot(normal, normal));
  for (double& x : normal)
  {
    x *= scale;
  }
  return { normal, dot(normal, p[f[0]]) };
}

// The plane of that relation, among a few, which cuts little and divides well.
Plane CycleSplitter::ChoosePlane(const Group& group) const
{
  constexpr std::size_t candidates = 24;
  const std::size_t n = group.Relations.size();
  const std::size_t step = std::max<std::size_t>(n / candidates, 1);
  Plane best = this->FindPlane(group.Relations[0]);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < n; i += step)
  {
    const Plane plane = this->FindPlane(group.Relations[i]);
    const std::int64_t cost = this->CostOf(plane, group);
    if (cost < least)
    {
      least = cost;
      best = plane;
    }
  }
  return best;
}

std::int64_t CycleSplitter::CostOf(const Plane& plane, const Group& group) const
{
  std::int64_t far = 0, near = 0, cut = 0;
  for (const Part& part : group.Parts)
  {
    const auto p = this->VerticesOf(part.Member);
    const double tolerance = this->ToleranceOf(p);
    const bool behind = std::any_of(
      p.begin(), p.end(), [&](const Vector3& x) { return plane.Distance(x) < -tolerance; });
    const bool before = std::any_of(
      p.begin(), p.end(), [&](const Vector3& x) { return plane.Distance(x) > tolerance; });
    far += behind;
    near += before;
    cut += behind && before;
  }
  return 4 * cut + std::max(far, near);
}

void CycleSplitter::Split(Group& group, const Plane& plane, Group& far, Group& near)
{
  for (Part& part : group.Parts)
  {
    this->SplitPart(part, plane, far, near);
  }
  this->KeepRelations(group, plane, -1, far);
  this->KeepRelations(group, plane, 1, near);
}

void CycleSplitter::SplitPart(Part& part, const Plane& plane, Group& far, Group& near) const
{
  const auto p = this->VerticesOf(part.Member);
  const double tolerance = this->ToleranceOf(p);
  bool behind = false, before = false;
  const auto look = [&](const Vector3& x) {
    behind = behind || plane.Distance(x) < -tolerance;
    before = before || plane.Distance(x) > tolerance;
  };
  for (const CutTetrahedron& t : part.Tetrahedra)
  {
    for (const CutCorner& corner : t)
    {
      look(corner.Position);
    }
  }
  if (part.Tetrahedra.empty())
  {
    std::for_each(p.begin(), p.end(), look);
  }
  if (!behind || !before)
  {
    (behind ? far : near).Parts.push_back(std::move(part));
    return;
  }
  this->AddRest(part, p, { plane, true }, far);
  this->AddRest(part, p, { plane, false }, near);
}

void CycleSplitter::AddRest(
  const Part& part, const std::array<Vector3, 4>& p, const HalfSpace& border, Group& half) const
{
  const double tolerance = this->ToleranceOf(p);
  Part rest = { part.Member, {}, { whole(p) } };
  this->Clip(rest.Tetrahedra, border, tolerance);
  rest.Borders.push_back(border);
  for (const HalfSpace& older : part.Borders)
  {
    if (this->Clip(rest.Tetrahedra, older, tolerance))
    {
      rest.Borders.push_back(older);
    }
  }
  if (!rest.Tetrahedra.empty())
  {
    half.Parts.push_back(std::move(rest));
  }
}

// Keeps what is inside; false when that is all.
bool CycleSplitter::Clip(
  std::vector<CutTetrahedron>& tetrahedra, const HalfSpace& border, double tolerance) const
{
  const TetrahedronCut cut(border.Border, this->Eye);
  std::vector<CutTetrahedron> inside, outside;
  for (const CutTetrahedron& t : tetrahedra)
  {
    border.Far ? cut.Apply(t, tolerance, inside, outside)
               : cut.Apply(t, tolerance, outside, inside);
  }
  tetrahedra.swap(inside);
  return !outside.empty();
}

// A relation lives on in a half where both tetrahedra have a part and where the face between them reaches.
void CycleSplitter::KeepRelations(const Group& group, const Plane& plane, double side, Group& half)
{
  ++this->NumberOfHalves;
  for (const Part& part : half.Parts)
  {
    this->Mark[static_cast<std::size_t>(part.Member)] = this->NumberOfHalves;
  }
  const auto present = [this](std::int32_t member) {
    return this->Mark[static_cast<std::size_t>(member)] == this->NumberOfHalves;
  };
  for (const Relation& r : group.Relations)
  {
    if (present(r.Front) && present(r.Behind))
    {
      const auto p = this->VerticesOf(r.Front);
      const double tolerance = this->ToleranceOf(p);
      const auto& f = tetrahedronFaces[r.Opposite];
      if (std::any_of(f, f + 3, [&](int k) {
            return side * plane.Distance(p[static_cast<std::size_t>(k)]) > tolerance;
          }))
      {
        half.Relations.push_back(r);
      }
    }
  }
}

void CycleSplitter::EmitBroken(const Group& group)
{
  std::vector<std::pair<double, const Part*>> parts;
  for (const Part& part : group.Parts)
  {
    parts.emplace_back(-farness(this->VerticesOf(part.Member), this->Eye), &part);
  }
  std::sort(parts.begin(), parts.end());
  std::int32_t rank = 0;
  for (const auto& part : parts)
  {
    this->NodeOf[static_cast<std::size_t>(part.second->Member)] = rank++;
    this->Emit(*part.second);
  }
  this->Broken +=
    std::count_if(group.Relations.begin(), group.Relations.end(), [this](const Relation& r) {
      return this->NodeOf[static_cast<std::size_t>(r.Behind)] >
        this->NodeOf[static_cast<std::size_t>(r.Front)];
    });
}

void CycleSplitter::Emit(const Part& part)
{
  ++this->Finished;
  const std::int32_t owner = (*this->Members)[static_cast<std::size_t>(part.Member)];
  if (part.Tetrahedra.empty())
  {
    this->Result->push_back(owner);
    return;
  }
  const std::int32_t firstPoint = static_cast<std::int32_t>(this->Geometry.Points.size());
  const std::size_t firstTetrahedron = this->Geometry.Tetrahedra.size();
  for (const CutTetrahedron& t : part.Tetrahedra)
  {
    Tetrahedron corners;
    for (std::size_t k = 0; k < 4; ++k)
    {
      corners[k] =
        firstPoint + this->Pieces->AddPoint(this->Geometry, owner, t[k].Position, t[k].Weights);
    }
    this->Result->push_back(
      static_cast<std::int32_t>(firstTetrahedron + this->Pieces->Tetrahedra.size()));
    this->Pieces->Tetrahedra.push_back(corners);
    this->Pieces->Owners.push_back(owner);
  }
}

} // namespace nephoscope
