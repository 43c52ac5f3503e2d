// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EyeTetrahedron.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
/** The tetrahedron in which the eye lies deepest: its least barycentric coordinate is largest. The lowest number of equals. */
struct Candidate
{
  std::int64_t Number = -1;
  double Depth = -1e-12;

  void Offer(std::int64_t number, double depth)
  {
    if (depth > this->Depth || (depth == this->Depth && (this->Number < 0 || number < this->Number)))
    {
      this->Number = number;
      this->Depth = depth;
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
bool isInBox(const std::array<Vector3, 4>& p, const Vector4& eye)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto range = std::minmax({ p[0][axis], p[1][axis], p[2][axis], p[3][axis] });
    if (eye[axis] < range.first || eye[axis] > range.second)
    {
      return false;
    }
  }
  return true;
}

Vertices verticesOf(const CellGeometry& geometry, std::int64_t number)
{
  if (geometry.Grid.IsEmpty())
  {
    const Tetrahedron& t = geometry.Tetrahedra[std::size_t(number)];
    return { { t[0], t[1], t[2], t[3] } };
  }
  constexpr int perCell = ChessboardGrid::TetrahedraPerCell;
  return geometry.Grid.Tetrahedra(number / perCell)[std::size_t(number % perCell)];
}

Candidate search(const CellGeometry& geometry, const Vector4& eye)
{
  const std::int64_t count = geometry.Grid.IsEmpty()
    ? std::int64_t(geometry.Tetrahedra.size())
    : ChessboardGrid::TetrahedraPerCell * geometry.Grid.NumberOfCells();
  vtkSMPThreadLocal<Candidate> candidates;
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    Candidate& candidate = candidates.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      const std::array<Vector3, 4> p = positions(geometry, verticesOf(geometry, i));
      if (isInBox(p, eye))
      {
        const Vector4 coordinates = eyeCoordinates(p, eye);
        const double depth = *std::min_element(coordinates.begin(), coordinates.end());
        if (std::isfinite(depth))
        {
          candidate.Offer(i, depth);
        }
      }
    }
  });
  Candidate best;
  for (const Candidate& candidate : candidates)
  {
    if (candidate.Number >= 0)
    {
      best.Offer(candidate.Number, candidate.Depth);
    }
  }
  return best;
}
}

EyeTetrahedron findEyeTetrahedron(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors, const Vector4& eye)
{
  EyeTetrahedron result;
  const double radius = geometry.Radius();
  if (eye[3] == 0 || eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2] > radius * radius)
  {
    return result;
  }
  const Candidate found = search(geometry, eye);
  if (found.Number < 0)
  {
    return result;
  }
  result.Found = true;
  const Vertices vertices = verticesOf(geometry, found.Number);
  const Vector4 weights = eyeCoordinates(positions(geometry, vertices), eye);
  const bool second = geometry.HasOpacityScalars && !geometry.OpacityOnCells;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const std::size_t point = std::size_t(vertices[k]);
    result.Vertices[k] = geometry.Grid.IsEmpty() ? neighbors.Merged(vertices[k]) : std::int32_t(vertices[k]);
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
