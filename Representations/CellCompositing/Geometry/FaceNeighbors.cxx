// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceNeighbors.h"

#include "Buckets.h"
#include "CoincidentPoints.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

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

/** No places: no points coincide. */
std::int32_t placeOf(std::int32_t point, const std::vector<std::int32_t>& places)
{
  return places.empty() ? point : places[static_cast<std::size_t>(point)];
}

std::array<std::int32_t, 3> sortedPlaces(
  const Tetrahedron& t, int opposite, const std::vector<std::int32_t>& places)
{
  std::array<std::int32_t, 3> points;
  for (int k = 0; k < 3; ++k)
  {
    points[k] = placeOf(t[tetrahedronFaces[opposite][k]], places);
  }
  std::sort(points.begin(), points.end());
  return points;
}

/** The vertex of a tetrahedron that is not in the face of these places. */
Vector3 vertexAcross(const CellGeometry& geometry, const Tetrahedron& other,
  const std::array<std::int32_t, 3>& face, const std::vector<std::int32_t>& places)
{
  return geometry.Position(*std::find_if(other.begin(), other.begin() + 3, [&](std::int32_t p) {
    return std::find(face.begin(), face.end(), placeOf(p, places)) == face.end();
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

/** Whether both tetrahedra of a face, the second one perhaps None, lie on the same side of it. */
bool isFolded(const CellGeometry& geometry, const std::vector<std::int32_t>& places,
  std::size_t tetrahedron, int face, std::int32_t other)
{
  if (other == FaceNeighbors::None)
  {
    return false;
  }
  const std::array<Vector3, 4> p = geometry.Vertices(tetrahedron);
  const auto& f = tetrahedronFaces[face];
  const Vector3 far = vertexAcross(geometry, geometry.Tetrahedra[static_cast<std::size_t>(other)],
    sortedPlaces(geometry.Tetrahedra[tetrahedron], face, places), places);
  const double error = roundingOf(p, far);
  const auto side = [&](const Vector3& x) {
    return planeSideWithin(p[f[0]], p[f[1]], p[f[2]], { { x[0], x[1], x[2], 1.0 } }, error);
  };
  const int near = side(p[static_cast<std::size_t>(face)]);
  return near != 0 && near == side(far);
}

/** Which of the faces of a tetrahedron, by the vertex across, has these places; all of them in turn. */
template <typename Visit>
void forFacesAt(const Tetrahedron& t, const std::array<std::int32_t, 3>& face,
  const std::vector<std::int32_t>& places, Visit visit)
{
  const auto count = std::count_if(t.begin(), t.end(), [&](std::int32_t p) {
    return std::find(face.begin(), face.end(), placeOf(p, places)) != face.end();
  });
  for (int k = 0; k < 4 && count >= 3; ++k)
  {
    if (sortedPlaces(t, k, places) == face)
    {
      visit(k);
    }
  }
}
}

std::int32_t findNeighborAcross(const CellGeometry& geometry,
  const std::vector<std::int32_t>& places, std::size_t tetrahedron, int face)
{
  using Side = std::pair<std::int64_t, int>;
  const auto wanted = sortedPlaces(geometry.Tetrahedra[tetrahedron], face, places);
  vtkSMPThreadLocal<std::vector<Side>> found;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      forFacesAt(geometry.Tetrahedra[static_cast<std::size_t>(i)], wanted, places,
        [&](int k) { found.Local().emplace_back(i, k); });
    }
  });
  std::vector<Side> sides;
  for (const std::vector<Side>& part : found)
  {
    sides.insert(sides.end(), part.begin(), part.end());
  }
  std::sort(sides.begin(), sides.end()); // they meet in pairs, as in MatchFaces
  const auto own = std::find(sides.begin(), sides.end(), Side(tetrahedron, face));
  const std::size_t other = static_cast<std::size_t>(own - sides.begin()) ^ 1u;
  const std::int32_t neighbor =
    other < sides.size() ? static_cast<std::int32_t>(sides[other].first) : FaceNeighbors::None;
  return isFolded(geometry, places, tetrahedron, face, neighbor) ? FaceNeighbors::None : neighbor;
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

bool FaceNeighbors::UnfoldFaces(const CellGeometry& geometry, const Progress& progress)
{
  std::vector<std::int32_t> found(this->Neighbors.size());
  const bool done = forEach(geometry.Tetrahedra.size(), progress, [&](std::size_t i) {
    for (int face = 0; face < 4; ++face)
    {
      const std::int32_t neighbor = this->Get(i, face);
      found[4 * i + static_cast<std::size_t>(face)] =
        isFolded(geometry, this->Places, i, face, neighbor) ? None : neighbor;
    }
  });
  this->Neighbors.swap(found);
  return done;
}

} // namespace nephoscope
