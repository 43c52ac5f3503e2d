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
std::int32_t PlaceOf(std::int32_t point, const std::vector<std::int32_t>& places)
{
  return places.empty() ? point : places[static_cast<std::size_t>(point)];
}

std::array<std::int32_t, 3> SortedPlaces(
  const Tetrahedron& t, int opposite, const std::vector<std::int32_t>& places)
{
  std::array<std::int32_t, 3> points;
  for (int k = 0; k < 3; ++k)
  {
    points[k] = PlaceOf(t[tetrahedronFaces[opposite][k]], places);
  }
  std::sort(points.begin(), points.end());
  return points;
}

/** The vertex of a tetrahedron that is not in the face of these places. */
Vector3 VertexAcross(const CellGeometry& geometry, const Tetrahedron& other,
  const std::array<std::int32_t, 3>& face, const std::vector<std::int32_t>& places)
{
  return geometry.Position(*std::find_if(other.begin(), other.begin() + 3, [&](std::int32_t p) {
    return std::find(face.begin(), face.end(), PlaceOf(p, places)) == face.end();
  }));
}

/** What the rounding of these coordinates may be. */
double RoundingOf(const std::array<Vector3, 5>& points)
{
  double largest = 0;
  for (const Vector3& x : points)
  {
    largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
  return largest * std::numeric_limits<float>::epsilon();
}

/**
 * Whether both tetrahedra of a face, the second one perhaps None, lie on the same side of it.
 * Either of them gives the same answer.
 */
bool IsFolded(const CellGeometry& geometry, const std::vector<std::int32_t>& places,
  std::size_t tetrahedron, int face, std::int32_t other)
{
  if (other == FaceNeighbors::None)
  {
    return false;
  }
  const Tetrahedron t = geometry.Tetrahedra[tetrahedron];
  const auto corners = SortedPlaces(t, face, places);
  const Vector3 a = geometry.Position(corners[0]), b = geometry.Position(corners[1]),
                c = geometry.Position(corners[2]);
  const Vector3 near = geometry.Position(t[static_cast<std::size_t>(face)]);
  const Vector3 far =
    VertexAcross(geometry, geometry.Tetrahedra[static_cast<std::size_t>(other)], corners, places);
  const double error = RoundingOf({ { a, b, c, near, far } });
  const auto side = [&](const Vector3& x) {
    return PlaneSideWithin(a, b, c, { { x[0], x[1], x[2], 1.0 } }, error);
  };
  return side(near) != 0 && side(near) == side(far);
}

using Face = std::array<std::int32_t, 3>;         // its places, ascending
using Side = std::tuple<Face, std::int64_t, int>; // and whose it is: tetrahedron, vertex across

/** The sides of some faces, which are sorted, in the order in which they meet in pairs. */
std::vector<Side> FindSides(const CellGeometry& geometry, const std::vector<std::int32_t>& places,
  const std::vector<Face>& faces)
{
  std::vector<bool> near(geometry.Points.size()); // in one of the faces
  for (const Face& face : faces)
  {
    std::for_each(face.begin(), face.end(), [&](std::int32_t p) { near[std::size_t(p)] = true; });
  }
  vtkSMPThreadLocal<std::vector<Side>> parts;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const Tetrahedron t = geometry.Tetrahedra[static_cast<std::size_t>(i)];
      const auto count = std::count_if(
        t.begin(), t.end(), [&](std::int32_t p) { return near[std::size_t(PlaceOf(p, places))]; });
      for (int k = 0; k < 4 && count >= 3; ++k)
      {
        const Face face = SortedPlaces(t, k, places);
        if (std::binary_search(faces.begin(), faces.end(), face))
        {
          parts.Local().emplace_back(face, i, k);
        }
      }
    }
  });
  std::vector<Side> sides;
  for (const std::vector<Side>& part : parts)
  {
    sides.insert(sides.end(), part.begin(), part.end());
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}
}

std::vector<std::int32_t> FindNeighborsAcross(const CellGeometry& geometry,
  const std::vector<std::int32_t>& places, const std::vector<std::size_t>& tetrahedra, int vertex)
{
  const auto faceOf = [&](std::size_t i) {
    return SortedPlaces(geometry.Tetrahedra[i], vertex, places);
  };
  std::vector<Face> faces(tetrahedra.size());
  std::transform(tetrahedra.begin(), tetrahedra.end(), faces.begin(), faceOf);
  std::sort(faces.begin(), faces.end());
  const std::vector<Side> sides = FindSides(geometry, places, faces);
  std::vector<std::int32_t> result;
  for (const std::size_t i : tetrahedra)
  {
    const Face face = faceOf(i);
    const auto first = std::lower_bound(sides.begin(), sides.end(), Side(face, -1, 0));
    const auto own = std::lower_bound(first, sides.end(), Side(face, i, vertex));
    const auto other = first + ((own - first) ^ 1); // they meet in pairs, as in MatchFaces
    const bool meets = other < sides.end() && std::get<0>(*other) == face;
    const std::int32_t neighbor =
      meets ? static_cast<std::int32_t>(std::get<1>(*other)) : FaceNeighbors::None;
    result.push_back(
      IsFolded(geometry, places, i, vertex, neighbor) ? FaceNeighbors::None : neighbor);
  }
  return result;
}

double FindCoordinateError(const CellGeometry& geometry)
{
  float largest = 0;
  for (const CellGeometry::Point& p : geometry.Points)
  {
    largest = std::max({ largest, std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }
  return std::isfinite(largest) ? largest * std::numeric_limits<float>::epsilon() : 0.0;
}

int PlaneSideWithin(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector4& e, double error)
{
  const Vector3 ab = Difference(b, a);
  const Vector3 ac = Difference(c, a);
  const Vector3 ae = { e[0] - e[3] * a[0], e[1] - e[3] * a[1], e[2] - e[3] * a[2] };
  const double side = Dot(Cross(ab, ac), ae);
  const double lengths[3] = { std::sqrt(Dot(ab, ab)), std::sqrt(Dot(ac, ac)),
    std::sqrt(Dot(ae, ae)) };
  const double areas = (lengths[0] + lengths[1]) * lengths[2] + e[3] * lengths[0] * lengths[1];
  return std::abs(side) > 3 * error * areas ? (side > 0) - (side < 0) : 0;
}

bool FaceNeighbors::Connect(const CellGeometry& geometry, const Progress& progress)
{
  *this = FaceNeighbors();
  this->Places = FindPlaces(geometry, progress.Part(0, 0.1));
  if (this->Places.size() != geometry.Points.size() ||
    !WeldPlaces(geometry, this->Places, progress.Part(0.1, 0.2)) ||
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
               const auto points = SortedPlaces(geometry.Tetrahedra[i], face, this->Places);
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
  const bool done = ForEachIndex(geometry.Tetrahedra.size(), progress, [&](std::size_t i) {
    for (int face = 0; face < 4; ++face)
    {
      const std::int32_t neighbor = this->Get(i, face);
      found[4 * i + static_cast<std::size_t>(face)] =
        IsFolded(geometry, this->Places, i, face, neighbor) ? None : neighbor;
    }
  });
  this->Neighbors.swap(found);
  return done;
}

} // namespace nephoscope
