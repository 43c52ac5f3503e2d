// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceNeighbors.h"

#include "BoundarySurface.h"
#include "Buckets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
/** A face on its way to meeting its partner: the two larger places, and whose face it is. */
struct OpenFace
{
  std::int32_t Middle, Largest;
  std::int32_t Tetrahedron;
  std::int32_t Opposite;
  bool SameFace(const OpenFace& other) const
  {
    return this->Middle == other.Middle && this->Largest == other.Largest;
  }
  bool operator<(const OpenFace& other) const
  {
    return std::tie(this->Middle, this->Largest, this->Tetrahedron, this->Opposite) <
      std::tie(other.Middle, other.Largest, other.Tetrahedron, other.Opposite);
  }
};

std::size_t hashOfPlace(const CellGeometry::Point& p)
{
  std::uint64_t hash = 0;
  for (const float x : { p.X, p.Y, p.Z })
  {
    const float positive = x + 0.0f; // -0 is at the same place
    std::uint32_t bits;
    std::memcpy(&bits, &positive, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

std::array<std::int32_t, 3> sortedPlaces(
  const Tetrahedron& t, int opposite, const std::vector<std::int32_t>& places)
{
  std::array<std::int32_t, 3> points;
  for (int k = 0; k < 3; ++k)
  {
    points[k] = places[static_cast<std::size_t>(t[tetrahedronFaces[opposite][k]])];
  }
  std::sort(points.begin(), points.end());
  return points;
}

/** The vertex of the second tetrahedron that is not in the face that it shares with the first. */
Vector3 vertexAcross(
  const std::array<Vector3, 4>& p, int opposite, const std::array<Vector3, 4>& other)
{
  const auto& f = tetrahedronFaces[opposite];
  return *std::find_if(other.begin(), other.begin() + 3,
    [&](const Vector3& x) { return x != p[f[0]] && x != p[f[1]] && x != p[f[2]]; });
}
}

std::vector<std::int32_t> findPlaces(const CellGeometry& geometry, const Progress& progress)
{
  const auto& points = geometry.Points;
  const auto place = [&points](std::int32_t i) {
    const CellGeometry::Point& p = points[static_cast<std::size_t>(i)];
    return std::tie(p.X, p.Y, p.Z);
  };
  std::vector<std::int32_t> places(points.size());
  std::iota(places.begin(), places.end(), 0);
  Buckets<std::int32_t> buckets;
  const std::size_t size = std::max<std::size_t>(points.size(), 1);
  const bool done =
    buckets.Fill(points.size(), size, progress.Part(0, 0.5), [&](std::size_t i, auto add) {
      const CellGeometry::Point& p = points[i];
      if (p.X == p.X && p.Y == p.Y && p.Z == p.Z) // NaN has no place in an order, and is in no tetrahedron
      {
        add(hashOfPlace(p) % size, static_cast<std::int32_t>(i));
      }
    }) &&
    buckets.ForEach(progress.Part(0.5, 1), [&](std::int32_t* begin, std::int32_t* end) {
      std::sort(begin, end, [&](std::int32_t a, std::int32_t b) {
        return std::tuple_cat(place(a), std::tie(a)) < std::tuple_cat(place(b), std::tie(b));
      });
      for (std::int32_t* i = begin; i != end && i + 1 != end; ++i)
      {
        if (place(i[0]) == place(i[1]))
        {
          places[static_cast<std::size_t>(i[1])] = places[static_cast<std::size_t>(i[0])];
        }
      }
    });
  if (!done)
  {
    places.clear();
  }
  return places;
}

double findCoordinateError(const CellGeometry& geometry)
{
  float largest = 0;
  for (const CellGeometry::Point& p : geometry.Points)
  {
    largest = std::max({ largest, std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }
  return std::isfinite(largest) ? largest * std::numeric_limits<float>::epsilon() : 0.0;
}

int planeSideWithin(const Vector3& a, const Vector3& b, const Vector3& c, const Vector4& e, double error)
{
  const Vector3 ab = difference(b, a);
  const Vector3 ac = difference(c, a);
  const Vector3 ae = { e[0] - e[3] * a[0], e[1] - e[3] * a[1], e[2] - e[3] * a[2] };
  const double side = dot(cross(ab, ac), ae);
  const double lengths[3] = { std::sqrt(dot(ab, ab)), std::sqrt(dot(ac, ac)), std::sqrt(dot(ae, ae)) };
  const double areas = (lengths[0] + lengths[1]) * lengths[2] + e[3] * lengths[0] * lengths[1];
  return std::abs(side) > 3 * error * areas ? (side > 0) - (side < 0) : 0;
}

bool FaceNeighbors::Connect(const CellGeometry& geometry, const Progress& progress)
{
  *this = FaceNeighbors();
  this->CoordinateError = findCoordinateError(geometry);
  this->Places = findPlaces(geometry, progress.Part(0, 0.15));
  if (this->Places.size() != geometry.Points.size() || !this->MatchFaces(geometry, progress.Part(0.15, 0.7)) ||
    !this->FindFolds(geometry, progress.Part(0.7, 0.9)))
  {
    *this = FaceNeighbors();
    return false;
  }
  this->Convex =
    isConvexSurface(geometry, this->Boundary, this->Places, this->CoordinateError, progress.Part(0.9, 1));
  this->Connected = progress.Report(1);
  return this->Connected;
}

bool FaceNeighbors::MatchFaces(const CellGeometry& geometry, const Progress& progress)
{
  const std::size_t n = geometry.Tetrahedra.size();
  this->Neighbors.assign(4 * n, None);
  Buckets<OpenFace> buckets; // by smallest place
  return buckets.Fill(n, std::max<std::size_t>(geometry.Points.size(), 1), progress.Part(0, 0.6),
           [&](std::size_t i, auto add) {
             for (int face = 0; face < 4; ++face)
             {
               const auto points = sortedPlaces(geometry.Tetrahedra[i], face, this->Places);
               add(static_cast<std::size_t>(points[0]),
                 OpenFace{ points[1], points[2], static_cast<std::int32_t>(i), face });
             }
           }) &&
    buckets.ForEach(progress.Part(0.6, 1), [&](OpenFace* begin, OpenFace* end) {
      std::sort(begin, end);
      for (OpenFace* f = begin; end - f >= 2; ++f)
      {
        OpenFace* g = f + 1;
        if (f->SameFace(*g))
        {
          this->Neighbors[4 * static_cast<std::size_t>(f->Tetrahedron) + f->Opposite] = g->Tetrahedron;
          this->Neighbors[4 * static_cast<std::size_t>(g->Tetrahedron) + g->Opposite] = f->Tetrahedron;
          ++f; // a third one at the same face overlaps its neighbours: it stays unrelated
        }
      }
    });
}

// Marks faces whose two owners lie on one side, and lists those with one owner.
bool FaceNeighbors::FindFolds(const CellGeometry& geometry, const Progress& progress)
{
  const auto sideOf = [&](const std::array<Vector3, 4>& p, int face, const Vector3& x) {
    const auto& f = tetrahedronFaces[face];
    const double side = planeSide(p[f[0]], p[f[1]], p[f[2]], { { x[0], x[1], x[2], 1.0 } });
    return (side > 0) - (side < 0);
  };
  const std::size_t n = geometry.Tetrahedra.size();
  std::vector<std::uint8_t> folded(n, 0); // bit per face: marks are made only after all neighbours were read
  return forEach(n, progress.Part(0, 0.6),
           [&](std::size_t i) {
             const std::array<Vector3, 4> p = geometry.Vertices(i);
             for (int face = 0; face < 4; ++face)
             {
               const std::int32_t other = this->Get(i, face);
               if (other >= 0)
               {
                 const Vector3 far = vertexAcross(p, face, geometry.Vertices(static_cast<std::size_t>(other)));
                 folded[i] |= (sideOf(p, face, p[static_cast<std::size_t>(face)]) == sideOf(p, face, far)) << face;
               }
             }
           }) &&
    forEachInTurn(n, progress.Part(0.6, 1), [&](std::size_t i) {
      for (int face = 0; face < 4; ++face)
      {
        std::int32_t& neighbor = this->Neighbors[4 * i + static_cast<std::size_t>(face)];
        neighbor = (folded[i] >> face) & 1 ? std::int32_t(Folded) : neighbor;
        if (neighbor == None)
        {
          this->Boundary.push_back({ static_cast<std::int32_t>(i), face });
        }
      }
    });
}

std::int64_t FaceNeighbors::GetNumberOfInteriorFaces() const
{
  return std::count_if(
           this->Neighbors.begin(), this->Neighbors.end(), [](std::int32_t n) { return n != None; }) /
    2;
}

} // namespace nephoscope
