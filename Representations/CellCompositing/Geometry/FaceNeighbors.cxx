// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceNeighbors.h"

#include "Buckets.h"
#include "CoincidentPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/** The vertex of a tetrahedron that is not in the face of these places. */
Vector3 vertexAcross(const CellGeometry& geometry, const Tetrahedron& other,
  const std::array<std::int32_t, 3>& face, const std::vector<std::int32_t>& places)
{
  return geometry.Position(*std::find_if(other.begin(), other.begin() + 3, [&](std::int32_t p) {
    return std::find(face.begin(), face.end(), places[static_cast<std::size_t>(p)]) == face.end();
  }));
}

/** What the rounding of these coordinates may be. */
double roundingOf(const std::array<Vector3, 4>& p, const Vector3& q)
{
  double largest = 0;
  for (const Vector3& x : { p[0], p[1], p[2], p[3], q })
  {
    largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
  return largest * std::numeric_limits<float>::epsilon();
}
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

int planeSideWithin(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector4& e, double error)
{
  const Vector3 ab = difference(b, a);
  const Vector3 ac = difference(c, a);
  const Vector3 ae = { e[0] - e[3] * a[0], e[1] - e[3] * a[1], e[2] - e[3] * a[2] };
  const double side = dot(cross(ab, ac), ae);
  const double lengths[3] = { std::sqrt(dot(ab, ab)), std::sqrt(dot(ac, ac)),
    std::sqrt(dot(ae, ae)) };
  const double areas = (lengths[0] + lengths[1]) * lengths[2] + e[3] * lengths[0] * lengths[1];
  return std::abs(side) > 3 * error * areas ? (side > 0) - (side < 0) : 0;
}

bool FaceNeighbors::Connect(const CellGeometry& geometry, const Progress& progress)
{
  *this = FaceNeighbors();
  this->Places = findPlaces(geometry, progress.Part(0, 0.1));
  if (this->Places.size() != geometry.Points.size() ||
    !weldPlaces(geometry, this->Places, progress.Part(0.1, 0.2)) ||
    !this->MatchFaces(geometry, progress.Part(0.2, 0.7)) ||
    !this->UnfoldFaces(geometry, progress.Part(0.7, 1)))
  {
    *this = FaceNeighbors();
    return false;
  }
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
          this->Neighbors[4 * static_cast<std::size_t>(f->Tetrahedron) + f->Opposite] =
            g->Tetrahedron;
          this->Neighbors[4 * static_cast<std::size_t>(g->Tetrahedron) + g->Opposite] =
            f->Tetrahedron;
          ++f; // a third one at the same face overlaps its neighbours: it stays unrelated
        }
      }
    });
}

// Whether both tetrahedra of a face lie on the same side of it.
bool FaceNeighbors::IsFolded(const CellGeometry& geometry, std::size_t tetrahedron, int face) const
{
  const std::int32_t other = this->Get(tetrahedron, face);
  if (other == None)
  {
    return false;
  }
  const std::array<Vector3, 4> p = geometry.Vertices(tetrahedron);
  const auto& f = tetrahedronFaces[face];
  const Vector3 far = vertexAcross(geometry, geometry.Tetrahedra[static_cast<std::size_t>(other)],
    sortedPlaces(geometry.Tetrahedra[tetrahedron], face, this->Places), this->Places);
  const double error = roundingOf(p, far);
  const auto side = [&](const Vector3& x) {
    return planeSideWithin(p[f[0]], p[f[1]], p[f[2]], { { x[0], x[1], x[2], 1.0 } }, error);
  };
  const int near = side(p[static_cast<std::size_t>(face)]);
  return near != 0 && near == side(far);
}

bool FaceNeighbors::UnfoldFaces(const CellGeometry& geometry, const Progress& progress)
{
  std::vector<std::int32_t> found(this->Neighbors.size());
  const bool done = forEach(geometry.Tetrahedra.size(), progress, [&](std::size_t i) {
    for (int face = 0; face < 4; ++face)
    {
      found[4 * i + static_cast<std::size_t>(face)] =
        this->IsFolded(geometry, i, face) ? None : this->Get(i, face);
    }
  });
  this->Neighbors.swap(found);
  return done;
}

} // namespace nephoscope
