// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellPick.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>

namespace nephoscope
{
namespace
{
std::vector<PickCrossing> FindCrossings(const CellGeometry& geometry, const PickRay& ray)
{
  const SidesOfRay sides(ray);
  std::vector<PickCrossing> crossings;
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
      PickCrossing crossing;
      crossing.Tetrahedron = i;
      if (!sides.Miss(p) && !geometry.IsHidden(i) && FindCrossing(p, ray, crossing))
      {
        const std::lock_guard<std::mutex> lock(mutex);
        crossings.push_back(crossing);
      }
    }
  });
  std::sort(crossings.begin(), crossings.end(), IsBefore);
  return crossings;
}

/** Scalars along one crossing. */
class Values
{
public:
  Values(const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray,
    const PickCrossing& crossing)
    : Geometry(geometry)
    , Medium(medium)
    , Ray(ray)
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
      ? this->Medium.Scalar(
          CellOfTetrahedron(this->Geometry, this->At.Tetrahedron), this->Ray.At(parameter))
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
          CellOfTetrahedron(this->Geometry, this->At.Tetrahedron), this->Ray.At(parameter))
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
  const PickRay& Ray;
  const PickCrossing& At;
  std::array<std::int64_t, 4> Points;
  std::size_t Number;
};

/** A part of a ray along which the scalar of the opacity is linear, or nearly so. */
struct Step
{
  double Begin, End, Low, High; // parameters, and scalars there
  double Scalar(double parameter) const
  {
    return this->Low +
      (parameter - this->Begin) / (this->End - this->Begin) * (this->High - this->Low);
  }
};

Step StepBetween(const Values& values, double begin, double end)
{
  return { begin, end, values.Opacity(begin), values.Opacity(end) };
}

/**
 * Lessens the optical depth that is left by that of a step; returns where none is left, or -1. The
 * extinction is linear between the nodes of the table.
 */
double Walk(const Step& step, const TransferFunctionTable& table, double scale, double& left)
{
  const auto extinction = [&](double t) {
    return scale * double(table.Evaluate(static_cast<float>(step.Scalar(t)))[3]);
  };
  const std::vector<float>& nodes = table.Nodes;
  const auto first = std::upper_bound(nodes.begin(), nodes.end(), std::min(step.Low, step.High)),
             last = std::lower_bound(first, nodes.end(), std::max(step.Low, step.High));
  const auto count = last - first;
  double from = step.Begin;
  for (std::ptrdiff_t i = 0; i <= count && from < step.End; ++i)
  {
    double to = step.End;
    if (i < count)
    {
      const double node = step.Low < step.High ? first[i] : last[-1 - i];
      to = step.Begin + (node - step.Low) / (step.High - step.Low) * (step.End - step.Begin);
    }
    const double length = to - from;
    const double a = extinction(from + 0.25 * length), b = extinction(from + 0.75 * length);
    const double depth = 0.5 * (a + b) * length;
    if (depth > 0 && depth >= left)
    {
      const double begin = std::max(1.5 * a - 0.5 * b, 0.0), slope = 2 * (b - a);
      const double root = std::sqrt(std::max(begin * begin + 2 * slope * left / length, 0.0));
      return from + std::min(2 * left / (begin + root), length);
    }
    left -= depth;
    from = to;
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
  const TransferFunctionTable& table, double scale, double begin, double end, double& left)
{
  for (const auto& surface : FindSurfaces(values, medium, begin, end))
  {
    const double at = Walk(StepBetween(values, begin, surface.first), table, scale, left);
    left -= surface.second;
    if (at >= 0 || left <= 0)
    {
      return at >= 0 ? at : surface.first;
    }
    begin = surface.first;
  }
  return Walk(StepBetween(values, begin, end), table, scale, left);
}
}

SidesOfRay::SidesOfRay(const PickRay& ray)
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

bool SidesOfRay::Miss(const std::array<Vector3, 4>& p) const
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

bool FindCrossing(const std::array<Vector3, 4>& p, const PickRay& ray, PickCrossing& c)
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

std::int64_t ValueNumber(const CellGeometry& geometry, std::int64_t tetrahedron)
{
  return !geometry.Hexahedra.empty() ? tetrahedron / geometry.TetrahedraPerHexahedron()
    : geometry.Grid.IsEmpty()        ? tetrahedron
                                     : tetrahedron / ChessboardGrid::TetrahedraPerCell;
}

std::int64_t CellOfTetrahedron(const CellGeometry& geometry, std::int64_t tetrahedron)
{
  const std::int64_t number = ValueNumber(geometry, tetrahedron);
  return geometry.Cells.empty() ? number : geometry.Cells[static_cast<std::size_t>(number)];
}

PickedCell WalkCrossing(const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray,
  const PickCrossing& c, double& left)
{
  constexpr int steps = 16;       // where the scalar is a polynomial of third degree
  constexpr double little = 0.02; // of what is left: one step does
  const Values values(geometry, medium, ray, c);
  const std::size_t number = medium.TablesOfTetrahedra.empty()
    ? 0
    : static_cast<std::size_t>(
        medium.TablesOfTetrahedra[static_cast<std::size_t>(ValueNumber(geometry, c.Tetrahedron))]);
  const double scale = medium.ExtinctionScale * ray.Length;
  if (medium.Scalar && medium.Surfaces.empty())
  {
    double rest = left;
    const double at = Walk(StepBetween(values, c.Begin, c.End), medium.Tables[number], scale, rest);
    if (at < 0 && left - rest < little * left)
    {
      left = rest;
      return {};
    }
  }
  const int n = medium.Scalar ? steps : 1;
  const double step = (c.End - c.Begin) / n;
  for (int i = 0; i < n; ++i)
  {
    const double at = WalkWithSurfaces(values, medium, medium.Tables[number], scale,
      c.Begin + i * step, c.Begin + (i + 1) * step, left);
    if (at >= 0)
    {
      return { c.Tetrahedron, values.NearestPoint(at), at, values.Color(at) };
    }
  }
  return {};
}

PickedCell PickCell(
  const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray, double opticalDepth)
{
  double left = opticalDepth;
  for (const PickCrossing& c : FindCrossings(geometry, ray))
  {
    const PickedCell picked = WalkCrossing(geometry, medium, ray, c, left);
    if (picked.Tetrahedron >= 0)
    {
      return picked;
    }
  }
  return {};
}

} // namespace nephoscope
