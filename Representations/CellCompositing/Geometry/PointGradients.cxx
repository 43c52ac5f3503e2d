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
/** The corners of tetrahedra that lie at each place: corner k of tetrahedron t is 4 t + k. */
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
  const std::int64_t count = geometry.CountTetrahedra();
  for (std::int64_t t = 0; t < count; ++t)
  {
    for (const std::int64_t point : geometry.PointNumbers(t))
    {
      corners.First[placeOf(point) + 1] += !geometry.IsHidden(t);
    }
  }
  std::partial_sum(corners.First.begin(), corners.First.end(), corners.First.begin());
  corners.List.resize(static_cast<std::size_t>(corners.First.back()));
  std::vector<std::int64_t> next(corners.First.begin(), corners.First.end() - 1);
  for (std::int64_t t = 0; t < count; ++t)
  {
    const std::array<std::int64_t, 4> points = geometry.PointNumbers(t);
    for (std::size_t k = 0; k < 4 && !geometry.IsHidden(t); ++k)
    {
      corners.List[static_cast<std::size_t>(next[placeOf(points[k])]++)] =
        4 * t + static_cast<std::int64_t>(k);
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
  NormalEquations equations;
  for (std::int64_t i = corners.First[place]; i < corners.First[place + 1]; ++i)
  {
    const std::int64_t corner = corners.List[static_cast<std::size_t>(i)];
    const std::array<std::int64_t, 4> t = geometry.PointNumbers(corner / 4);
    const std::int64_t center = t[static_cast<std::size_t>(corner % 4)];
    for (const std::int64_t other : t)
    {
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
