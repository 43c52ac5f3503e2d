// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointGradients.h"

#include "CellGeometry.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
/** The cells of a geometry, tetrahedra or hexahedra, by their corners. Each has edges to three others. */
class CornersOfCells
{
public:
  explicit CornersOfCells(const CellGeometry& geometry)
    : Geometry(geometry)
    , OfHexahedra(!geometry.Hexahedra.empty())
  {
  }

  std::int64_t CountCells() const
  {
    return this->OfHexahedra ? static_cast<std::int64_t>(this->Geometry.Hexahedra.size())
                             : this->Geometry.CountTetrahedra();
  }
  std::size_t PerCell() const { return this->OfHexahedra ? 8 : 4; }
  bool IsHidden(std::int64_t cell) const
  {
    return !this->OfHexahedra && this->Geometry.IsHidden(cell);
  }

  std::array<std::int64_t, 8> Points(std::int64_t cell) const
  {
    std::array<std::int64_t, 8> points{};
    if (this->OfHexahedra)
    {
      const Hexahedron& vertices = this->Geometry.Hexahedra[static_cast<std::size_t>(cell)];
      std::copy(vertices.begin(), vertices.end(), points.begin());
    }
    else
    {
      const std::array<std::int64_t, 4> vertices = this->Geometry.PointNumbers(cell);
      std::copy(vertices.begin(), vertices.end(), points.begin());
    }
    return points;
  }

  /** The corners at the other ends of the edges of one. */
  std::array<std::size_t, 3> Neighbors(std::size_t corner) const
  {
    return this->OfHexahedra
      ? std::array<std::size_t, 3>{ { corner ^ 1, corner ^ 2, corner ^ 4 } }
      : std::array<std::size_t, 3>{ { (corner + 1) % 4, (corner + 2) % 4, (corner + 3) % 4 } };
  }

private:
  const CellGeometry& Geometry;
  bool OfHexahedra;
};

/** The corners of cells that lie at each place: corner k of cell c is c times the corners per cell, plus k. */
struct Corners
{
  std::vector<std::int32_t> Place; // of each point
  std::vector<std::int64_t> First; // of each place, in List
  std::vector<std::int64_t> List;  // ascending within a place
};

// Points in the order of their coordinates; equal ones share a place.
std::vector<std::int32_t> findPlaces(const CellGeometry& geometry, std::size_t& count)
{
  const auto key = [&](std::int32_t i) {
    const CellGeometry::Point& p = geometry.Points[static_cast<std::size_t>(i)];
    return std::make_tuple(p.X, p.Y, p.Z);
  };
  std::vector<std::int32_t> order(geometry.Points.size());
  std::iota(order.begin(), order.end(), 0);
  // Points that are not finite belong to no tetrahedron, and would break the order.
  order.erase(std::remove_if(order.begin(), order.end(),
                [&](std::int32_t i) {
                  const auto p = geometry.Position(i);
                  return !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
                }),
    order.end());
  vtkSMPTools::Sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return std::make_tuple(key(a), a) < std::make_tuple(key(b), b);
  });
  std::vector<std::int32_t> places(geometry.Points.size(), 0);
  count = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    count += i == 0 || key(order[i - 1]) != key(order[i]);
    places[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(count - 1);
  }
  return places;
}

Corners findCorners(const CellGeometry& geometry)
{
  Corners corners;
  std::size_t places = 0;
  corners.Place = findPlaces(geometry, places);
  corners.First.assign(places + 1, 0);
  const auto placeOf = [&](std::int64_t point) {
    return static_cast<std::size_t>(corners.Place[static_cast<std::size_t>(point)]);
  };
  const CornersOfCells cells(geometry);
  const std::int64_t count = cells.CountCells();
  for (std::int64_t cell = 0; cell < count; ++cell)
  {
    const auto points = cells.Points(cell);
    for (std::size_t k = 0; k < cells.PerCell(); ++k)
    {
      corners.First[placeOf(points[k]) + 1] += !cells.IsHidden(cell);
    }
  }
  std::partial_sum(corners.First.begin(), corners.First.end(), corners.First.begin());
  corners.List.resize(static_cast<std::size_t>(corners.First.back()));
  std::vector<std::int64_t> next(corners.First.begin(), corners.First.end() - 1);
  for (std::int64_t cell = 0; cell < count; ++cell)
  {
    const auto points = cells.Points(cell);
    for (std::size_t k = 0; k < cells.PerCell() && !cells.IsHidden(cell); ++k)
    {
      corners.List[static_cast<std::size_t>(next[placeOf(points[k])]++)] =
        cell * static_cast<std::int64_t>(cells.PerCell()) + static_cast<std::int64_t>(k);
    }
  }
  return corners;
}

/** The normal equations of the least squares, m g = r with a symmetric m. */
struct NormalEquations
{
  double XX = 0, XY = 0, XZ = 0, YY = 0, YZ = 0, ZZ = 0;
  Vector3 Right = { { 0, 0, 0 } };

  void Add(const Vector3& d, double change)
  {
    const double weight = 1.0 / dot(d, d);
    this->XX += weight * d[0] * d[0];
    this->XY += weight * d[0] * d[1];
    this->XZ += weight * d[0] * d[2];
    this->YY += weight * d[1] * d[1];
    this->YZ += weight * d[1] * d[2];
    this->ZZ += weight * d[2] * d[2];
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Right[c] += weight * d[c] * change;
    }
  }

  Vector3 Solve() const
  {
    const Vector3 x = { { this->XX, this->XY, this->XZ } };
    const Vector3 y = { { this->XY, this->YY, this->YZ } };
    const Vector3 z = { { this->XZ, this->YZ, this->ZZ } };
    const Vector3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const double determinant = dot(x, yz);
    const double trace = this->XX + this->YY + this->ZZ;
    if (!(determinant > 1e-13 * trace * trace * trace))
    {
      return { { 0, 0, 0 } };
    }
    Vector3 g;
    for (std::size_t c = 0; c < 3; ++c)
    {
      g[c] =
        (this->Right[0] * yz[c] + this->Right[1] * zx[c] + this->Right[2] * xy[c]) / determinant;
    }
    return g;
  }
};

Vector3 gradientAt(const CellGeometry& geometry, const std::vector<float>& scalars,
  const Corners& corners, std::size_t place)
{
  const CornersOfCells cells(geometry);
  const auto perCell = static_cast<std::int64_t>(cells.PerCell());
  NormalEquations equations;
  for (std::int64_t i = corners.First[place]; i < corners.First[place + 1]; ++i)
  {
    const std::int64_t corner = corners.List[static_cast<std::size_t>(i)];
    const auto points = cells.Points(corner / perCell);
    const auto number = static_cast<std::size_t>(corner % perCell);
    const std::int64_t center = points[number];
    for (const std::size_t neighbor : cells.Neighbors(number))
    {
      const std::int64_t other = points[neighbor];
      const Vector3 d =
        difference(geometry.Position(std::int32_t(other)), geometry.Position(std::int32_t(center)));
      const double change = double(scalars[static_cast<std::size_t>(other)]) -
        double(scalars[static_cast<std::size_t>(center)]);
      if (dot(d, d) > 0 && std::isfinite(change))
      {
        equations.Add(d, change);
      }
    }
  }
  return equations.Solve();
}
}

std::vector<std::array<float, 4>> pointGradients(
  const CellGeometry& geometry, const std::vector<float>& scalars)
{
  const Corners corners = findCorners(geometry);
  std::vector<Vector3> ofPlaces(corners.First.size() - 1);
  vtkSMPTools::For(0, static_cast<vtkIdType>(ofPlaces.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      ofPlaces[static_cast<std::size_t>(i)] =
        gradientAt(geometry, scalars, corners, static_cast<std::size_t>(i));
    }
  });
  std::vector<std::array<float, 4>> gradients(
    geometry.Points.size(), std::array<float, 4>{ { 0, 0, 0, 0 } });
  for (std::size_t i = 0; i < gradients.size() && !ofPlaces.empty(); ++i)
  {
    const Vector3& g = ofPlaces[static_cast<std::size_t>(corners.Place[i])];
    gradients[i] = { { static_cast<float>(g[0]), static_cast<float>(g[1]), static_cast<float>(g[2]),
      0.0f } };
  }
  return gradients;
}

} // namespace nephoscope
