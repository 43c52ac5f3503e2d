// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EyeTetrahedron.h"

#include "ClearStart.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
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
    const auto key = [](std::int64_t n, const ClearStart& s) { return std::make_tuple(-s.Clearance, s.Moved, n); };
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
  result.Found = true;
  const Vertices vertices = geometry.PointNumbers(found.Number);
  result.Start = found.Start.Position;
  const Vector4& weights = found.Start.Weights;
  const bool second = geometry.HasOpacityScalars && !geometry.OpacityOnCells;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const std::size_t point = std::size_t(vertices[k]);
    result.Vertices[k] = geometry.Grid.IsEmpty() ? neighbors.Merged(vertices[k]) : std::int32_t(vertices[k]);
    result.Weights[k] = float(weights[k]);
    result.Scalar += float(weights[k] * geometry.Points[point].Scalar);
    result.Opacity += second ? float(weights[k] * geometry.OpacityScalars[point]) : 0.0f;
  }
  result.Opacity = second ? result.Opacity : result.Scalar;
  result.Place[0] = std::int32_t(found.Number);
  if (!geometry.Grid.IsEmpty())
  {
    const std::array<int, 3> cell = geometry.Grid.CellIndex(found.Number / ChessboardGrid::TetrahedraPerCell);
    std::copy(cell.begin(), cell.end(), result.Place.begin());
    result.Place[3] = found.Number % ChessboardGrid::TetrahedraPerCell == 0 ? -1 : std::int32_t(vertices[0]);
  }
  return result;
}

} // namespace nephoscope
