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
/**
 * The tetrahedron, among those that touch the eye, with the clearest start for rays; the nearest of
 * equals, then the lowest number.
 */
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

std::array<Vector3, 4> Positions(const CellGeometry& geometry, const Vertices& v)
{
  const auto at = [&](std::int64_t p) { return geometry.Position(std::int32_t(p)); };
  return { { at(v[0]), at(v[1]), at(v[2]), at(v[3]) } };
}

// False, at little cost, for nearly all tetrahedra.
bool IsNearBox(const std::array<Vector3, 4>& p, const Vector4& eye, double margin)
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

Candidate Search(const CellGeometry& geometry, const Vector4& eye, double clearance)
{
  vtkSMPThreadLocal<Candidate> candidates;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    Candidate& candidate = candidates.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      const std::array<Vector3, 4> p = Positions(geometry, geometry.PointNumbers(i));
      if (IsNearBox(p, eye, clearance))
      {
        const ClearStart start = FindClearStart(p, eye, clearance);
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

EyeTetrahedron Describe(const CellGeometry& geometry, const TetrahedronNeighbors& neighbors,
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
  const int perHexahedron = geometry.TetrahedraPerHexahedron();
  result.Place[0] = std::int32_t(geometry.Hexahedra.empty() ? number : number / perHexahedron);
  if (geometry.DividesHexahedra)
  {
    const int part = static_cast<int>(number % perHexahedron);
    const auto corners = geometry.PartCorners(part);
    std::copy(corners.begin(), corners.end(), result.Vertices.begin());
    result.Place[3] = part == 0 ? -1 : result.Vertices[0];
  }
  if (!geometry.Grid.IsEmpty())
  {
    const std::array<int, 3> cell =
      geometry.Grid.CellIndex(number / ChessboardGrid::TetrahedraPerCell);
    std::copy(cell.begin(), cell.end(), result.Place.begin());
    result.Place[3] =
      number % ChessboardGrid::TetrahedraPerCell == 0 ? -1 : std::int32_t(vertices[0]);
  }
  result.Hexahedron = result.Place;
  return result;
}

/**
 * How far a position is inside of a hexahedron with bilinear faces, in fractions of its width;
 * negative: outside.
 */
double DepthInHexahedron(const std::array<Vector3, 8>& p, const Vector3& x)
{
  constexpr double outside = -1e30;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto less = [axis](const Vector3& a, const Vector3& b) { return a[axis] < b[axis]; };
    const auto range = std::minmax_element(p.begin(), p.end(), less);
    if (x[axis] < (*range.first)[axis] || x[axis] > (*range.second)[axis])
    {
      return outside;
    }
  }
  Vector3 place = { 0.5, 0.5, 0.5 };
  for (int i = 0; i < 16; ++i)
  {
    Vector3 away = x;
    std::array<Vector3, 3> along = {}; // the directions in which the place grows
    for (std::size_t c = 0; c < 8; ++c)
    {
      double weight[3], slope[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const bool high = (c >> k & 1) != 0;
        weight[k] = high ? place[k] : 1 - place[k];
        slope[k] = high ? 1 : -1;
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        away[axis] -= weight[0] * weight[1] * weight[2] * p[c][axis];
        along[0][axis] += slope[0] * weight[1] * weight[2] * p[c][axis];
        along[1][axis] += weight[0] * slope[1] * weight[2] * p[c][axis];
        along[2][axis] += weight[0] * weight[1] * slope[2] * p[c][axis];
      }
    }
    const double volume = Dot(along[0], Cross(along[1], along[2]));
    if (!(std::abs(volume) > 0))
    {
      return outside;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double step = Dot(away, Cross(along[(k + 1) % 3], along[(k + 2) % 3])) / volume;
      place[k] = std::max(-1.0, std::min(2.0, place[k] + step));
    }
  }
  return std::min({ place[0], place[1], place[2], 1 - place[0], 1 - place[1], 1 - place[2] });
}

/** The deepest of those cells around the start that are not outside. */
class HexahedronSearch
{
public:
  HexahedronSearch(const CellGeometry& geometry, EyeTetrahedron& eye)
    : Geometry(geometry)
    , Eye(eye)
    , Start({ eye.Start[0], eye.Start[1], eye.Start[2] })
  {
  }

  void InList()
  {
    const std::vector<Hexahedron>& cells = this->Geometry.Hexahedra;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      this->Offer(
        { { std::int32_t(i), 0, 0, 0 } }, [&](std::size_t corner) { return cells[i][corner]; });
    }
  }

  void InGrid()
  {
    const ChessboardGrid& grid = this->Geometry.Grid;
    const std::array<std::int32_t, 4> middle = this->Eye.Place;
    for (int neighbor = 0; neighbor < 27; ++neighbor)
    {
      std::array<std::int32_t, 4> c = { { middle[0] + neighbor % 3 - 1,
        middle[1] + neighbor / 3 % 3 - 1, middle[2] + neighbor / 9 - 1, -1 } };
      c[0] = grid.WrapCells > 0 ? (c[0] + grid.WrapCells) % grid.WrapCells : c[0];
      if (c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < grid.Size[0] - 1 &&
        c[1] < grid.Size[1] - 1 && c[2] < grid.Size[2] - 1)
      {
        this->Offer(c, [&](std::size_t corner) {
          return std::int32_t(grid.PointNumber(
            c[0] + int(corner & 1), c[1] + int(corner >> 1 & 1), c[2] + int(corner >> 2 & 1)));
        });
      }
    }
  }

private:
  template <typename VertexOf>
  void Offer(const std::array<std::int32_t, 4>& place, VertexOf vertexOf)
  {
    std::array<Vector3, 8> p;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      p[corner] = this->Geometry.Position(vertexOf(corner));
    }
    const double depth = DepthInHexahedron(p, this->Start);
    if (depth > this->Deepest)
    {
      this->Deepest = depth;
      this->Eye.Hexahedron = place;
    }
  }

  const CellGeometry& Geometry;
  EyeTetrahedron& Eye;
  Vector3 Start;
  double Deepest = -1e-3;
};

constexpr double inFace = 1e-7; // barycentric coordinate: the start keeps more distance from the
                                // faces of its own tetrahedron

bool Holds(const CellGeometry& geometry, std::int64_t number, const Vector4& start, double margin)
{
  const std::array<Vector3, 4> p = Positions(geometry, geometry.PointNumbers(number));
  if (!IsNearBox(p, start, margin))
  {
    return false;
  }
  const Vector4 q = EyeCoordinates(p, start);
  return std::all_of(q.begin(), q.end(), [](double x) { return x >= -inFace; });
}

/**
 * Where hexahedra meet: what they have in common is not divided the same way, so that parts may
 * overlap by the bend of a face.
 */
bool IsBeside(const CellGeometry& geometry, const TetrahedronNeighbors& neighbors,
  std::int64_t part, std::int64_t other)
{
  if (geometry.Hexahedra.empty() || geometry.DividesHexahedra)
  {
    return false;
  }
  const Hexahedron& a = geometry.Hexahedra[std::size_t(part / 6)];
  const Hexahedron& b = geometry.Hexahedra[std::size_t(other / 6)];
  return std::any_of(a.begin(), a.end(), [&](std::int32_t p) {
    return std::any_of(b.begin(), b.end(),
      [&](std::int32_t q) { return neighbors.Merged(p) == neighbors.Merged(q); });
  });
}

/**
 * The other tetrahedra that hold the start; of those that meet in a face, an edge or a vertex
 * there, one.
 */
std::vector<EyeTetrahedron> FindOverlapping(const CellGeometry& geometry,
  const TetrahedronNeighbors& neighbors, std::int64_t own, const Vector3& position)
{
  const Vector4 start = { { position[0], position[1], position[2], 1 } };
  const double margin = inFace * geometry.Radius();
  vtkSMPThreadLocal<std::vector<std::int64_t>> parts;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      if (i != own && Holds(geometry, i, start, margin) && !IsBeside(geometry, neighbors, i, own))
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
    const Vector4 q = EyeCoordinates(Positions(geometry, vertices), start);
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
      result.push_back(Describe(geometry, neighbors, number, position, q));
    }
  }
  return result;
}

/** A walk through listed tetrahedra starts with a neighbour that it knows. */
void FindNeighbors(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors, EyeTetrahedron& eye)
{
  std::vector<std::size_t> numbers = { std::size_t(eye.Place[0]) };
  for (const EyeTetrahedron& other : eye.Overlapping)
  {
    numbers.push_back(std::size_t(other.Place[0]));
  }
  const auto found = neighbors.FindOneNeighbor(geometry, numbers);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EyeTetrahedron& start = i == 0 ? eye : eye.Overlapping[i - 1];
    std::copy(found[i].begin(), found[i].end(), start.Place.begin() + 1);
  }
}
}

EyeTetrahedron FindEyeTetrahedron(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors, const Vector4& eye)
{
  EyeTetrahedron result;
  const double clearance = eyeClearance * geometry.Radius();
  const double reach = geometry.Radius() + clearance;
  if (eye[3] == 0 || eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2] > reach * reach)
  {
    return result;
  }
  const Candidate found = Search(geometry, eye, clearance);
  if (found.Number < 0)
  {
    return result;
  }
  result = Describe(geometry, neighbors, found.Number, found.Start.Position, found.Start.Weights);
  if (!geometry.DividesHexahedra)
  {
    geometry.Grid.IsEmpty() ? HexahedronSearch(geometry, result).InList()
                            : HexahedronSearch(geometry, result).InGrid();
  }
  if (geometry.Grid.IsEmpty())
  {
    result.Overlapping = FindOverlapping(geometry, neighbors, found.Number, found.Start.Position);
  }
  if (geometry.Grid.IsEmpty() && geometry.Hexahedra.empty())
  {
    FindNeighbors(geometry, neighbors, result);
  }
  return result;
}

} // namespace nephoscope
