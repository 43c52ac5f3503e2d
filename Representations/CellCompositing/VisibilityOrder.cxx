// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibilityOrder.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
template <typename Body>
void parallelFor(std::size_t n, Body body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      body(static_cast<std::size_t>(i));
    }
  });
}

/** A face on its way to meeting its partner: the two larger canonical points, and whose face it is. */
struct OpenFace
{
  std::int32_t Middle, Largest;
  std::int32_t Tetrahedron;
  std::int32_t Face;
  bool SameFace(const OpenFace& other) const
  {
    return this->Middle == other.Middle && this->Largest == other.Largest;
  }
  bool operator<(const OpenFace& other) const
  {
    return std::tie(this->Middle, this->Largest, this->Tetrahedron, this->Face) <
      std::tie(other.Middle, other.Largest, other.Tetrahedron, other.Face);
  }
};

/** Sort key of a centroid: larger is farther. */
float farness(const CellGeometry& geometry, std::size_t i, const Vector4& eye)
{
  const std::array<Vector3, 4> p = geometry.Vertices(i);
  Vector3 centroid = { 0, 0, 0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    centroid[axis] = 0.25 * (p[0][axis] + p[1][axis] + p[2][axis] + p[3][axis]);
  }
  const Vector3 e = { eye[0], eye[1], eye[2] };
  if (eye[3] == 0.0)
  {
    return static_cast<float>(-dot(centroid, e));
  }
  const Vector3 d = difference(centroid, e);
  return static_cast<float>(dot(d, d));
}

constexpr int sign(double x)
{
  return (x > 0) - (x < 0);
}
}

void VisibilityOrder::Clear()
{
  *this = VisibilityOrder();
}

void VisibilityOrder::Connect(const CellGeometry& geometry)
{
  this->MergePoints(geometry);
  this->MatchFaces(geometry);
  this->OrientFaces(geometry);
  this->Connected = true;
}

std::int64_t VisibilityOrder::GetNumberOfInteriorFaces() const
{
  return std::count_if(
           this->Neighbors.begin(), this->Neighbors.end(), [](std::int32_t n) { return n >= 0; }) /
    2;
}

void VisibilityOrder::MergePoints(const CellGeometry& geometry)
{
  const auto& points = geometry.Points;
  const auto place = [&points](std::int32_t i) {
    const CellGeometry::Point& p = points[static_cast<std::size_t>(i)];
    return std::tie(p.X, p.Y, p.Z);
  };
  std::vector<std::int32_t> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const CellGeometry::Point& p = points[i];
    if (p.X == p.X && p.Y == p.Y && p.Z == p.Z) // NaN has no place in an order, and is in no tetrahedron
    {
      sorted.push_back(static_cast<std::int32_t>(i));
    }
  }
  vtkSMPTools::Sort(sorted.begin(), sorted.end(), [&](std::int32_t a, std::int32_t b) {
    return std::tuple_cat(place(a), std::tie(a)) < std::tuple_cat(place(b), std::tie(b));
  });
  this->CanonicalPoints.resize(points.size());
  std::iota(this->CanonicalPoints.begin(), this->CanonicalPoints.end(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (place(sorted[i - 1]) == place(sorted[i]))
    {
      this->CanonicalPoints[static_cast<std::size_t>(sorted[i])] =
        this->CanonicalPoints[static_cast<std::size_t>(sorted[i - 1])];
    }
  }
}

std::array<std::int32_t, 3> VisibilityOrder::CanonicalFace(const Tetrahedron& t, int face) const
{
  std::array<std::int32_t, 3> points;
  for (int k = 0; k < 3; ++k)
  {
    points[k] = this->CanonicalPoints[static_cast<std::size_t>(t[tetrahedronFaces[face][k]])];
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Faces are thrown into one bucket per smallest point; partners meet in the same bucket.
void VisibilityOrder::MatchFaces(const CellGeometry& geometry)
{
  const std::size_t n = geometry.Tetrahedra.size();
  std::vector<std::int64_t> bucketEnd(geometry.Points.size() + 1, 0);
  for (const Tetrahedron& t : geometry.Tetrahedra)
  {
    for (int face = 0; face < 4; ++face)
    {
      ++bucketEnd[static_cast<std::size_t>(this->CanonicalFace(t, face)[0]) + 1];
    }
  }
  std::partial_sum(bucketEnd.begin(), bucketEnd.end(), bucketEnd.begin());
  std::vector<OpenFace> faces(4 * n);
  std::vector<std::int64_t> next(bucketEnd.begin(), bucketEnd.end() - 1);
  for (std::size_t i = 0; i < n; ++i)
  {
    for (int face = 0; face < 4; ++face)
    {
      const auto points = this->CanonicalFace(geometry.Tetrahedra[i], face);
      faces[static_cast<std::size_t>(next[static_cast<std::size_t>(points[0])]++)] = { points[1], points[2],
        static_cast<std::int32_t>(i), face };
    }
  }

  this->Neighbors.assign(4 * n, -1);
  parallelFor(geometry.Points.size(), [&](std::size_t bucket) {
    const auto begin = faces.begin() + bucketEnd[bucket];
    const auto end = faces.begin() + bucketEnd[bucket + 1];
    std::sort(begin, end);
    for (auto f = begin; f != end && f + 1 != end; ++f)
    {
      const OpenFace& g = *(f + 1);
      if (f->SameFace(g))
      {
        this->Neighbors[4 * static_cast<std::size_t>(f->Tetrahedron) + f->Face] = g.Tetrahedron;
        this->Neighbors[4 * static_cast<std::size_t>(g.Tetrahedron) + g.Face] = f->Tetrahedron;
        ++f; // a third one at the same face overlaps its neighbours: it stays unrelated
        if (f + 1 == end)
        {
          break;
        }
      }
    }
  });
}

void VisibilityOrder::OrientFaces(const CellGeometry& geometry)
{
  float largest = 0;
  for (const CellGeometry::Point& p : geometry.Points)
  {
    largest = std::max({ largest, std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }
  this->CoordinateError = std::isfinite(largest) ? largest * std::numeric_limits<float>::epsilon() : 0.0;
  const std::size_t n = geometry.Tetrahedra.size();
  this->Sides.assign(4 * n, 0);
  parallelFor(n, [&](std::size_t i) {
    for (int face = 0; face < 4; ++face)
    {
      const std::int32_t neighbor = this->Neighbors[4 * i + face];
      if (neighbor >= 0)
      {
        const auto f = this->CanonicalFace(geometry.Tetrahedra[i], face);
        const int own = this->FarVertexSide(geometry, f, geometry.Tetrahedra[i]);
        const int other = this->FarVertexSide(geometry, f, geometry.Tetrahedra[static_cast<std::size_t>(neighbor)]);
        // Both on one side: the mesh is folded there, and neither is in front.
        this->Sides[4 * i + face] = static_cast<std::int8_t>(own == other ? 0 : own != 0 ? own : -other);
      }
    }
  });
}

// Side of the face's plane on which the vertex of the tetrahedron lies that is not in the face.
int VisibilityOrder::FarVertexSide(
  const CellGeometry& geometry, const std::array<std::int32_t, 3>& face, const Tetrahedron& t) const
{
  const std::int32_t* vertex = std::find_if(t.data(), t.data() + 3, [&](std::int32_t v) {
    const std::int32_t point = this->CanonicalPoints[static_cast<std::size_t>(v)];
    return std::find(face.begin(), face.end(), point) == face.end();
  });
  const Vector3 p = geometry.Position(*vertex);
  return sign(planeSide(geometry.Position(face[0]), geometry.Position(face[1]), geometry.Position(face[2]),
    { { p[0], p[1], p[2], 1.0 } }));
}

// Side of the face's plane on which the eye lies, 0 where the rounding of the coordinates could turn the answer: moving each
// point by the error moves the determinant by at most three times the error times the areas it multiplies. A direction
// towards the eye has no error of its own.
int VisibilityOrder::EyeSide(
  const CellGeometry& geometry, const std::array<std::int32_t, 3>& face, const Vector4& eye) const
{
  const Vector3 a = geometry.Position(face[0]);
  const Vector3 ab = difference(geometry.Position(face[1]), a);
  const Vector3 ac = difference(geometry.Position(face[2]), a);
  const Vector3 ae = { eye[0] - eye[3] * a[0], eye[1] - eye[3] * a[1], eye[2] - eye[3] * a[2] };
  const double side = dot(cross(ab, ac), ae);
  const double lengths[3] = { std::sqrt(dot(ab, ab)), std::sqrt(dot(ac, ac)), std::sqrt(dot(ae, ae)) };
  const double areas = (lengths[0] + lengths[1]) * lengths[2] + eye[3] * lengths[0] * lengths[1];
  return std::abs(side) > 3 * this->CoordinateError * areas ? sign(side) : 0;
}

// behind[4 i + k]: the neighbour across face k that must be drawn before tetrahedron i, or -1.
void VisibilityOrder::FindRelations(
  const CellGeometry& geometry, const Vector4& eye, std::vector<std::int32_t>& behind) const
{
  behind.resize(this->Neighbors.size());
  parallelFor(geometry.Tetrahedra.size(), [&](std::size_t i) {
    for (int face = 0; face < 4; ++face)
    {
      const std::size_t slot = 4 * i + face;
      const std::int32_t neighbor = this->Neighbors[slot];
      behind[slot] = -1;
      if (neighbor >= 0)
      {
        // Both owners of the face evaluate the same plane with the same vertices: they always agree.
        const auto f = this->CanonicalFace(geometry.Tetrahedra[i], face);
        const int eyeSide = this->EyeSide(geometry, f, eye);
        behind[slot] = eyeSide != 0 && eyeSide == this->Sides[slot] ? neighbor : -1;
      }
    }
  });
}

std::int64_t VisibilityOrder::SortExact(
  const CellGeometry& geometry, const Vector4& eye, std::vector<std::int32_t>& order) const
{
  std::vector<std::int32_t> seeds;
  SortCentroids(geometry, eye, seeds);
  std::vector<std::int32_t> behind;
  this->FindRelations(geometry, eye, behind);

  enum : std::uint8_t
  {
    Untouched,
    OnPath = 1, // 1 + next face to look at: 1..5
    Drawn = 6
  };
  std::vector<std::uint8_t> state(seeds.size(), Untouched);
  std::vector<std::int32_t> path;
  std::int64_t broken = 0;
  order.clear();
  order.reserve(seeds.size());
  for (const std::int32_t seed : seeds)
  {
    if (state[static_cast<std::size_t>(seed)] != Untouched)
    {
      continue;
    }
    state[static_cast<std::size_t>(seed)] = OnPath;
    path.push_back(seed);
    while (!path.empty())
    {
      const std::size_t top = static_cast<std::size_t>(path.back());
      const int face = state[top] - OnPath;
      if (face == 4)
      {
        state[top] = Drawn;
        order.push_back(path.back());
        path.pop_back();
        continue;
      }
      ++state[top];
      const std::int32_t next = behind[4 * top + static_cast<std::size_t>(face)];
      if (next < 0 || state[static_cast<std::size_t>(next)] == Drawn)
      {
        continue;
      }
      if (state[static_cast<std::size_t>(next)] != Untouched)
      {
        ++broken; // it is on the path: this relation closes a cycle
        continue;
      }
      state[static_cast<std::size_t>(next)] = OnPath;
      path.push_back(next);
    }
  }
  return broken;
}

void VisibilityOrder::SortCentroids(
  const CellGeometry& geometry, const Vector4& eye, std::vector<std::int32_t>& order)
{
  std::vector<float> far(geometry.Tetrahedra.size());
  parallelFor(far.size(), [&](std::size_t i) { far[i] = farness(geometry, i, eye); });
  SortNone(geometry, order);
  vtkSMPTools::Sort(order.begin(), order.end(), [&far](std::int32_t a, std::int32_t b) {
    const float fa = far[static_cast<std::size_t>(a)];
    const float fb = far[static_cast<std::size_t>(b)];
    return fa > fb || (fa == fb && a < b);
  });
}

void VisibilityOrder::SortNone(const CellGeometry& geometry, std::vector<std::int32_t>& order)
{
  order.resize(geometry.Tetrahedra.size());
  std::iota(order.begin(), order.end(), 0);
}

} // namespace nephoscope
