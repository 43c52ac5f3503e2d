// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EyeTetrahedron.h"

#include "ClearStart.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace nephoscope
{
namespace
{
/** The tetrahedron, among those that touch the eye, with the clearest start for rays; the nearest of equals, then the lowest number. */
struct Candidate
{
  std::int64_t Number = -1;
  ClearStart Start;

  void Offer(std::int64_t number, const ClearStart& start)
  {
    const auto key = [](std::int64_t n, const ClearStart& s) {
      return std::make_tuple(-s.Clearance, s.Moved, n);
    };
    if (this->Number < 0 || key(number, start) < key(this->Number, this->Start))
    {
      this->Number = number;
      this->Start = start;
    }
  }
};

using Vertices = std::array<std::int64_t, 4>;

std::array<Vector3, 4> positions(const CellGeometry& geometry, const Vertices& v)
{
  const auto at = [&](std::int64_t p) { return geometry.Position(std::int32_t(p)); };
  return { { at(v[0]), at(v[1]), at(v[2]), at(v[3]) } };
}

// False, at little cost, for nearly all tetrahedra.
bool isNearBox(const std::array<Vector3, 4>& p, const Vector4& eye, double margin)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto range = std::minmax({ p[0][axis], p[1][axis], p[2][axis], p[3][axis] });
    if (eye[axis] < range.first - margin || eye[axis] > range.second + margin)
    {
      return false;
    }
  }
  return true;
}

Candidate search(const CellGeometry& geometry, const Vector4& eye, double clearance)
{
  vtkSMPThreadLocal<Candidate> candidates;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    Candidate& candidate = candidates.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      const std::array<Vector3, 4> p = positions(geometry, geometry.PointNumbers(i));
      if (isNearBox(p, eye, clearance))
      {
        const ClearStart start = findClearStart(p, eye, clearance);
        if (start.Found)
        {
          candidate.Offer(i, start);
        }
      }
    }
  });
  Candidate best;
  for (const Candidate& candidate : candidates)
  {
    if (candidate.Number >= 0)
    {
      best.Offer(candidate.Number, candidate.Start);
    }
  }
  return best;
}

EyeTetrahedron describe(const CellGeometry& geometry, const TetrahedronNeighbors& neighbors,
  std::int64_t number, const Vector3& start, const Vector4& weights)
{
  EyeTetrahedron result;
  result.Found = true;
  const Vertices vertices = geometry.PointNumbers(number);
  result.Start = start;
  const bool second = geometry.HasOpacityScalars && !geometry.OpacityOnCells;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const std::size_t point = std::size_t(vertices[k]);
    result.Vertices[k] =
      geometry.Grid.IsEmpty() ? neighbors.Merged(vertices[k]) : std::int32_t(vertices[k]);
    result.Weights[k] = float(weights[k]);
    result.Scalar += float(weights[k] * geometry.Points[point].Scalar);
    result.Opacity += second ? float(weights[k] * geometry.OpacityScalars[point]) : 0.0f;
  }
  result.Opacity = second ? result.Opacity : result.Scalar;
  result.Place[0] = std::int32_t(number);
  if (!geometry.Grid.IsEmpty())
  {
    const std::array<int, 3> cell =
      geometry.Grid.CellIndex(number / ChessboardGrid::TetrahedraPerCell);
    std::copy(cell.begin(), cell.end(), result.Place.begin());
    result.Place[3] =
      number % ChessboardGrid::TetrahedraPerCell == 0 ? -1 : std::int32_t(vertices[0]);
  }
  return result;
}

constexpr double inFace =
  1e-7; // barycentric coordinate: the start keeps more distance from the faces of its own tetrahedron

bool holds(const CellGeometry& geometry, std::int64_t number, const Vector4& start)
{
  const std::array<Vector3, 4> p = positions(geometry, geometry.PointNumbers(number));
  if (!isNearBox(p, start, inFace * geometry.Radius()))
  {
    return false;
  }
  const Vector4 q = eyeCoordinates(p, start);
  return std::all_of(q.begin(), q.end(), [](double x) { return x >= -inFace; });
}

/** The other tetrahedra that hold the start; of those that meet in a face, an edge or a vertex there, one. */
std::vector<EyeTetrahedron> findOverlapping(const CellGeometry& geometry,
  const TetrahedronNeighbors& neighbors, std::int64_t own, const Vector3& position)
{
  const Vector4 start = { { position[0], position[1], position[2], 1 } };
  vtkSMPThreadLocal<std::vector<std::int64_t>> parts;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      if (i != own && holds(geometry, i, start))
      {
        parts.Local().push_back(i);
      }
    }
  });
  std::vector<std::int64_t> numbers;
  for (const std::vector<std::int64_t>& part : parts)
  {
    numbers.insert(numbers.end(), part.begin(), part.end());
  }
  std::sort(numbers.begin(), numbers.end());
  std::set<std::set<std::int32_t>> met;
  std::vector<EyeTetrahedron> result;
  for (const std::int64_t number : numbers)
  {
    const Vertices vertices = geometry.PointNumbers(number);
    const Vector4 q = eyeCoordinates(positions(geometry, vertices), start);
    std::set<std::int32_t> around;
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (q[k] > inFace)
      {
        around.insert(neighbors.Merged(vertices[k]));
      }
    }
    if (around.size() == 4 || met.insert(around).second)
    {
      result.push_back(describe(geometry, neighbors, number, position, q));
    }
  }
  return result;
}
}

EyeTetrahedron findEyeTetrahedron(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors, const Vector4& eye)
{
  EyeTetrahedron result;
  const double clearance = eyeClearance * geometry.Radius();
  const double reach = geometry.Radius() + clearance;
  if (eye[3] == 0 || eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2] > reach * reach)
  {
    return result;
  }
  const Candidate found = search(geometry, eye, clearance);
  if (found.Number < 0)
  {
    return result;
  }
  result = describe(geometry, neighbors, found.Number, found.Start.Position, found.Start.Weights);
  if (geometry.Grid.IsEmpty())
  {
    result.Overlapping = findOverlapping(geometry, neighbors, found.Number, found.Start.Position);
  }
  return result;
}

} // namespace nephoscope
