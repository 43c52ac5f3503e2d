// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellPick.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace nephoscope
{
namespace
{
struct Crossing
{
  std::int64_t Tetrahedron;
  double Begin, End;
  Vector4 Weights, Slopes; // barycentric coordinates: Weights + parameter * Slopes
};

/**
 * Tells of most tetrahedra that the ray misses them: all vertices lie on one side of a plane
 * through the ray.
 */
class SidesOfRay
{
public:
  explicit SidesOfRay(const PickRay& ray)
    : Start(ray.Start)
  {
    const Vector3& d = ray.Direction;
    const auto least = std::min_element(
      d.begin(), d.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    Vector3 axis = { { 0, 0, 0 } };
    axis[static_cast<std::size_t>(least - d.begin())] = 1;
    this->Normals[0] = Cross(d, axis);
    this->Normals[1] = Cross(d, this->Normals[0]);
  }

  bool Miss(const std::array<Vector3, 4>& p) const
  {
    return std::any_of(this->Normals.begin(), this->Normals.end(), [&](const Vector3& normal) {
      int before = 0, behind = 0;
      for (const Vector3& x : p)
      {
        const double side = Dot(normal, Difference(x, this->Start));
        before += side > 0;
        behind += side < 0;
      }
      return before == 4 || behind == 4;
    });
  }

private:
  Vector3 Start;
  std::array<Vector3, 2> Normals;
};

bool FindCrossing(const std::array<Vector3, 4>& p, const PickRay& ray, Crossing& c)
{
  const Vector4 start = { { ray.Start[0], ray.Start[1], ray.Start[2], 1.0 } };
  const Vector4 direction = { { ray.Direction[0], ray.Direction[1], ray.Direction[2], 0.0 } };
  c.Weights = EyeCoordinates(p, start);
  c.Slopes = EyeCoordinates(p, direction);
  c.Begin = ray.Begin;
  c.End = ray.End;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double w = c.Weights[i], s = c.Slopes[i];
    if (!std::isfinite(w) || !std::isfinite(s) || (s == 0 && w < 0))
    {
      return false; // a flat tetrahedron, or a ray beside a face
    }
    c.Begin = s > 0 ? std::max(c.Begin, -w / s) : c.Begin;
    c.End = s < 0 ? std::min(c.End, -w / s) : c.End;
  }
  return c.Begin < c.End;
}

std::vector<Crossing> FindCrossings(const CellGeometry& geometry, const PickRay& ray)
{
  const SidesOfRay sides(ray);
  std::vector<Crossing> crossings;
  std::mutex mutex;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      std::array<Vector3, 4> p;
      const auto numbers = geometry.PointNumbers(i);
      for (std::size_t k = 0; k < 4; ++k)
      {
        p[k] = geometry.Position(static_cast<std::int32_t>(numbers[k]));
      }
      Crossing crossing;
      crossing.Tetrahedron = i;
      if (!sides.Miss(p) && !geometry.IsHidden(i) && FindCrossing(p, ray, crossing))
      {
        const std::lock_guard<std::mutex> lock(mutex);
        crossings.push_back(crossing);
      }
    }
  });
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::make_pair(a.Begin + a.End, a.Tetrahedron) <
      std::make_pair(b.Begin + b.End, b.Tetrahedron);
  });
  return crossings;
}

std::int64_t ValueNumber(const CellGeometry& geometry, std::int64_t tetrahedron)
{
  return !geometry.Hexahedra.empty() ? tetrahedron / geometry.TetrahedraPerHexahedron()
    : geometry.Grid.IsEmpty()        ? tetrahedron
                                     : tetrahedron / ChessboardGrid::TetrahedraPerCell;
}

/** Scalars along one crossing. */
class Values
{
public:
  Values(const CellGeometry& geometry, const PickMedium& medium, const Crossing& crossing)
    : Geometry(geometry)
    , Medium(medium)
    , At(crossing)
    , Points(geometry.PointNumbers(crossing.Tetrahedron))
    , Number(static_cast<std::size_t>(ValueNumber(geometry, crossing.Tetrahedron)))
  {
  }

  double Color(double parameter) const
  {
    if (!this->Geometry.CellScalars.empty())
    {
      return this->Geometry.CellScalars[this->Number];
    }
    return this->Medium.Scalar
      ? this->Medium.Scalar(CellOfTetrahedron(this->Geometry, this->At.Tetrahedron), parameter)
      : this->Interpolate(
          parameter, [&](std::size_t point) { return this->Geometry.Points[point].Scalar; });
  }

  double Opacity(double parameter) const
  {
    const std::vector<float>& values = this->Geometry.OpacityScalars;
    return !this->Geometry.HasOpacityScalars ? this->Color(parameter)
      : this->Geometry.OpacityOnCells        ? values[this->Number]
      : this->Medium.OpacityScalar
      ? this->Medium.OpacityScalar(
          CellOfTetrahedron(this->Geometry, this->At.Tetrahedron), parameter)
      : this->Interpolate(parameter, [&](std::size_t point) { return values[point]; });
  }

  double Contoured(double parameter) const
  {
    return this->Medium.Contoured
      ? this->Interpolate(
          parameter, [&](std::size_t point) { return (*this->Medium.Contoured)[point]; })
      : this->Color(parameter);
  }

  std::int64_t NearestPoint(double parameter) const
  {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 4; ++k)
    {
      best = this->Weight(k, parameter) > this->Weight(best, parameter) ? k : best;
    }
    return this->Points[best];
  }

private:
  double Weight(std::size_t k, double parameter) const
  {
    return this->At.Weights[k] + parameter * this->At.Slopes[k];
  }

  template <typename Value>
  double Interpolate(double parameter, Value value) const
  {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      sum += this->Weight(k, parameter) * value(static_cast<std::size_t>(this->Points[k]));
    }
    return sum;
  }

  const CellGeometry& Geometry;
  const PickMedium& Medium;
  const Crossing& At;
  std::array<std::int64_t, 4> Points;
  std::size_t Number;
};

/** Parameters between which the extinction is linear, both ends included. */
std::vector<double> LinearPieces(
  const Values& values, const TransferFunctionTable& table, double begin, double end)
{
  std::vector<double> pieces = { begin };
  const double low = values.Opacity(begin), high = values.Opacity(end);
  for (const float node : table.Nodes)
  {
    const double u = (node - low) / (high - low);
    if (u > 0 && u < 1)
    {
      pieces.push_back(begin + u * (end - begin));
    }
  }
  pieces.push_back(end);
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

/**
 * Lessens the optical depth that is left by that of [begin, end]; returns where none is left, or
 * -1.
 */
double Walk(const Values& values, const TransferFunctionTable& table, double scale, double begin,
  double end, double& left)
{
  const std::vector<double> pieces = LinearPieces(values, table, begin, end);
  const auto extinction = [&](double t) {
    return scale * double(table.Evaluate(static_cast<float>(values.Opacity(t)))[3]);
  };
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
  {
    const double length = pieces[i + 1] - pieces[i];
    const double a = extinction(pieces[i] + 0.25 * length),
                 b = extinction(pieces[i] + 0.75 * length);
    const double depth = 0.5 * (a + b) * length;
    if (depth > 0 && depth >= left)
    {
      const double first = std::max(1.5 * a - 0.5 * b, 0.0), slope = 2 * (b - a);
      const double root = std::sqrt(std::max(first * first + 2 * slope * left / length, 0.0));
      return pieces[i] + std::min(2 * left / (first + root), length);
    }
    left -= depth;
  }
  return -1;
}

/**
 * The surfaces between two parameters, in the order of the ray: where, and their optical depths.
 */
std::vector<std::pair<double, double>> FindSurfaces(
  const Values& values, const PickMedium& medium, double begin, double end)
{
  std::vector<std::pair<double, double>> found;
  if (medium.Surfaces.empty())
  {
    return found;
  }
  const double front = values.Contoured(begin), back = values.Contoured(end);
  for (const PickMedium::Surface& surface : medium.Surfaces)
  {
    if ((front >= surface.Value) != (back >= surface.Value))
    {
      const double part = (surface.Value - front) / (back - front);
      found.emplace_back(begin + part * (end - begin), -std::log1p(-surface.Opacity));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/** The same as Walk(), and surfaces on the way. */
double WalkWithSurfaces(const Values& values, const PickMedium& medium,
  const TransferFunctionTable& table, double begin, double end, double& left)
{
  for (const auto& surface : FindSurfaces(values, medium, begin, end))
  {
    const double at = Walk(values, table, medium.ExtinctionScale, begin, surface.first, left);
    left -= surface.second;
    if (at >= 0 || left <= 0)
    {
      return at >= 0 ? at : surface.first;
    }
    begin = surface.first;
  }
  return Walk(values, table, medium.ExtinctionScale, begin, end, left);
}
}

std::int64_t CellOfTetrahedron(const CellGeometry& geometry, std::int64_t tetrahedron)
{
  const std::int64_t number = ValueNumber(geometry, tetrahedron);
  return geometry.Cells.empty() ? number : geometry.Cells[static_cast<std::size_t>(number)];
}

PickedCell PickCell(
  const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray, double opticalDepth)
{
  constexpr int steps = 16; // where the scalar is a polynomial of third degree
  double left = opticalDepth;
  for (const Crossing& c : FindCrossings(geometry, ray))
  {
    const Values values(geometry, medium, c);
    const std::size_t number = medium.TablesOfTetrahedra.empty()
      ? 0
      : static_cast<std::size_t>(
          medium.TablesOfTetrahedra[static_cast<std::size_t>(c.Tetrahedron)]);
    const int n = medium.Scalar ? steps : 1;
    const double step = (c.End - c.Begin) / n;
    for (int i = 0; i < n; ++i)
    {
      const double at = WalkWithSurfaces(
        values, medium, medium.Tables[number], c.Begin + i * step, c.Begin + (i + 1) * step, left);
      if (at >= 0)
      {
        return { c.Tetrahedron, values.NearestPoint(at), at, values.Color(at) };
      }
    }
  }
  return {};
}

} // namespace nephoscope
