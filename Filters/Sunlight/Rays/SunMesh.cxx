// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunMesh.h"

#include "SunRay.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace nephoscope
{
namespace
{
struct Face
{
  std::array<std::int32_t, 3> Points; // ascending
  std::int32_t Tetrahedron, Vertex;
};

constexpr std::int32_t none = -1;

// Whether the sun sees the point in front of the face.
bool IsAbove(const SunPoint& point, const SunPoint& a, const SunPoint& b, const SunPoint& c)
{
  const Place u{ { b.X - a.X, b.Y - a.Y, b.Z - a.Z } }, v{ { c.X - a.X, c.Y - a.Y, c.Z - a.Z } },
    normal = Cross(u, v);
  return normal[2] * Dot(normal, Place{ { point.X - a.X, point.Y - a.Y, point.Z - a.Z } }) > 0;
}

Face FaceOf(const SunMesh::Tetrahedron& t, std::int32_t number, int vertex)
{
  Face face{ { t[(vertex + 1) % 4], t[(vertex + 2) % 4], t[(vertex + 3) % 4] }, number, vertex };
  std::sort(face.Points.begin(), face.Points.end());
  return face;
}
}

SunMesh::SunMesh(std::vector<Tetrahedron> tetrahedra, std::vector<std::int32_t> merged)
  : Merged(std::move(merged))
  , Tetrahedra(std::move(tetrahedra))
  , Neighbours(this->Tetrahedra.size(), { { none, none, none, none } })
{
  this->FindNeighbours(this->Merged.size());
  this->FindTetrahedraOfPoints(this->Merged.size());
}

// With a vertex twice.
bool SunMesh::IsFlat(std::size_t tetrahedron) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
    t[2] == t[3];
}

// Faces sorted by their least point by counting, then compared with the few others of that point.
void SunMesh::FindNeighbours(std::size_t numberOfPoints)
{
  std::vector<Face> found;
  for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
  {
    for (int v = 0; v < 4; ++v)
    {
      if (!this->IsFlat(t))
      {
        found.push_back(FaceOf(this->Tetrahedra[t], static_cast<std::int32_t>(t), v));
      }
    }
  }
  std::vector<std::int32_t> first(numberOfPoints + 1, 0);
  for (const Face& face : found)
  {
    ++first[face.Points[0] + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Face> faces(found.size());
  std::vector<std::int32_t> place(first.begin(), first.end() - 1);
  for (const Face& face : found)
  {
    faces[place[face.Points[0]]++] = face;
  }
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    std::sort(faces.begin() + first[p], faces.begin() + first[p + 1],
      [](const Face& a, const Face& b) { return a.Points < b.Points; });
  }
  for (std::size_t f = 0; f + 1 < faces.size(); ++f)
  {
    if (faces[f].Points == faces[f + 1].Points)
    {
      this->Neighbours[faces[f].Tetrahedron][faces[f].Vertex] = faces[f + 1].Tetrahedron;
      this->Neighbours[faces[f + 1].Tetrahedron][faces[f + 1].Vertex] = faces[f].Tetrahedron;
    }
  }
}

void SunMesh::FindTetrahedraOfPoints(std::size_t numberOfPoints)
{
  std::vector<bool> flat(this->Tetrahedra.size());
  this->First.assign(numberOfPoints + 1, 0);
  for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
  {
    flat[t] = this->IsFlat(t);
    for (const std::int32_t p : this->Tetrahedra[t])
    {
      this->First[p + 1] += flat[t] ? 0 : 1;
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  this->OfPoint.resize(this->First.back());
  std::vector<std::int32_t> place(this->First.begin(), this->First.end() - 1);
  for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
  {
    for (const std::int32_t p : this->Tetrahedra[t])
    {
      if (!flat[t])
      {
        this->OfPoint[place[p]++] = static_cast<std::int32_t>(t);
      }
    }
  }
}

void SunMesh::Turn(std::vector<SunPoint> points)
{
  this->Points = std::move(points);
  this->Clouds = LastClouds(this->Points);
  for (const Tetrahedron& t : this->Tetrahedra)
  {
    this->Clouds.Add(this->Points, t);
  }
  this->Entries = EntryFaces(this->Points, this->FacesFromBelow());
}

// Boundary faces whose tetrahedron is on their side towards the sun.
std::vector<EntryFaces::Face> SunMesh::FacesFromBelow() const
{
  std::vector<EntryFaces::Face> faces;
  for (std::size_t number = 0; number < this->Tetrahedra.size(); ++number)
  {
    const Tetrahedron& t = this->Tetrahedra[number];
    for (int v = 0; v < 4; ++v)
    {
      const EntryFaces::Face face{ { { t[(v + 1) % 4], t[(v + 2) % 4], t[(v + 3) % 4] } },
        static_cast<std::int32_t>(number) };
      if (this->Neighbours[number][v] == none && !this->IsFlat(number) &&
        IsAbove(this->Points[t[v]], this->Points[face.Points[0]], this->Points[face.Points[1]],
          this->Points[face.Points[2]]))
      {
        faces.push_back(face);
      }
    }
  }
  return faces;
}

// The longest edge at a point, across the direction of the sun.
double SunMesh::SizeAt(std::int32_t point) const
{
  double size = 0;
  const SunPoint& here = this->Points[point];
  for (std::int32_t k = this->First[point]; k < this->First[point + 1]; ++k)
  {
    for (const std::int32_t p : this->Tetrahedra[this->OfPoint[k]])
    {
      const SunPoint& there = this->Points[p];
      size = std::max(size, std::abs(there.X - here.X) + std::abs(there.Y - here.Y));
    }
  }
  return size;
}

struct SunMesh::Path
{
  SunRay Ray;
  std::int32_t Next = none;           // tetrahedron
  std::array<std::int32_t, 3> Face{}; // where it is entered
  double LastEntry =
    std::numeric_limits<double>::lowest(); // height where the ray last entered the mesh
};

// In one of the tetrahedra at the point.
bool SunMesh::Begin(std::int32_t point, Path& path) const
{
  for (std::int32_t k = this->First[point]; k < this->First[point + 1]; ++k)
  {
    const std::int32_t number = this->OfPoint[k];
    const Tetrahedron& t = this->Tetrahedra[number];
    const auto v = std::find(t.begin(), t.end(), point) - t.begin();
    path.Face = { { t[(v + 1) % 4], t[(v + 2) % 4], t[(v + 3) % 4] } };
    const int turn = path.Ray.Start(
      this->Points[path.Face[0]], this->Points[path.Face[1]], this->Points[path.Face[2]]);
    if (turn != 0)
    {
      path.Next = this->Neighbours[number][v];
      turn < 0 ? std::swap(path.Face[1], path.Face[2]) : void();
      return true;
    }
  }
  return false;
}

// Through a tetrahedron, by its vertex that is not one of the face.
void SunMesh::Step(Path& path) const
{
  const Tetrahedron& t = this->Tetrahedra[path.Next];
  const auto isNew = [&](std::int32_t p) {
    return p != path.Face[0] && p != path.Face[1] && p != path.Face[2];
  };
  const std::int32_t vertex = *std::find_if(t.begin(), t.end() - 1, isNew);
  const int replaced = path.Ray.Step(this->Points[vertex]);
  const auto left = std::find(t.begin(), t.end(), path.Face[replaced]);
  path.Face[replaced] = vertex;
  path.Next = this->Neighbours[path.Next][left - t.begin()];
}

// Across a gap, if there is more of the mesh behind it.
bool SunMesh::Enter(Path& path) const
{
  path.Next = this->Entries.Next(this->Points, path.LastEntry, path.Ray, path.Face);
  path.LastEntry = path.Ray.Height();
  return path.Next != none;
}

std::array<double, 2> SunMesh::DepthsFrom(std::int32_t number) const
{
  Path path;
  const std::int32_t point = this->Merged[number];
  const SunPoint& here = this->Points[point];
  const double end = this->Clouds.HeightAt(here.X, here.Y);
  if (here.Z >= end)
  {
    return path.Ray.Depths();
  }
  const double size = 1e-9 * this->SizeAt(point);
  const auto starts = [&](const auto& begin) {
    return std::any_of(std::begin(sidesOfRay), std::end(sidesOfRay), [&](const auto& side) {
      path = Path{ SunRay(here, size * side[0], size * side[1]) };
      return begin();
    });
  };
  if (!starts([&] { return this->Begin(point, path); }) &&
    !starts([&] { return this->Enter(path); }))
  {
    return SunRay().Depths();
  }
  for (std::size_t left = this->Tetrahedra.size();
       left > 0 && path.Ray.Height() < end && !path.Ray.IsDark(); --left)
  {
    if (path.Next == none && !this->Enter(path))
    {
      break;
    }
    this->Step(path);
  }
  return path.Ray.Depths();
}
}
