// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceNormals.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double flat = 1e-9; // of the product of three lengths: a box without volume

Vector3 Blend(const Vector3& first, const Vector3& second, double share)
{
  return (1.0 - share) * first + share * second;
}

// Solves the symmetric system; zero if it has no single solution.
Vector3 Solve(const double m[3][3], const Vector3& right)
{
  const Vector3 a = { { m[0][0], m[0][1], m[0][2] } };
  const Vector3 b = { { m[1][0], m[1][1], m[1][2] } };
  const Vector3 c = { { m[2][0], m[2][1], m[2][2] } };
  const double determinant = Dot(a, Cross(b, c));
  if (!(std::abs(determinant) > flat * Norm(a) * Norm(b) * Norm(c)))
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  return (1.0 / determinant) *
    (right[0] * Cross(b, c) + right[1] * Cross(c, a) + right[2] * Cross(a, b));
}
}

FieldGradient::Neighbor FieldGradient::Look(int axis, const GridIndex& from, int step) const
{
  Neighbor found;
  found.At = from;
  found.At[axis] = this->Plan.Topology().Step(axis, from[axis], step);
  const std::int64_t id = this->Plan.Topology().Id(found.At);
  if (found.At[axis] == from[axis] || this->Missing[id])
  {
    return found;
  }
  found.Away = this->Plan.Displacement(axis, from, step);
  found.Distance = Norm(found.Away);
  found.Rise = this->Field[id] - this->Field[this->Plan.Topology().Id(from)];
  found.IsThere = found.Distance > 0.0;
  return found;
}

// The derivative at a point of the parabola through it and two others blends two slopes, from the
// nearer to the farther one.
FieldGradient::Slope FieldGradient::SlopeAlong(int axis, const GridIndex& at) const
{
  const Neighbor before = this->Look(axis, at, -1);
  const Neighbor after = this->Look(axis, at, +1);
  Slope slope;
  if (!before.IsThere && !after.IsThere)
  {
    return slope;
  }
  slope.HasValue = true;
  const double sign = after.IsThere ? 1.0 : -1.0; // of the step to the first neighbour
  const Neighbor& first = after.IsThere ? after : before;
  slope.Rise = sign * first.Rise / first.Distance;
  slope.Tangent = (sign / first.Distance) * first.Away;
  if (before.IsThere && after.IsThere)
  {
    const double share = after.Distance / (after.Distance + before.Distance);
    slope.Rise = (1.0 - share) * slope.Rise - share * before.Rise / before.Distance;
    slope.Tangent = Blend(slope.Tangent, (-1.0 / before.Distance) * before.Away, share);
    return slope;
  }
  const Neighbor second = this->Look(axis, first.At, after.IsThere ? +1 : -1);
  if (second.IsThere && second.At != at)
  {
    const double share = -first.Distance / (first.Distance + second.Distance);
    slope.Rise = (1.0 - share) * slope.Rise + share * sign * second.Rise / second.Distance;
    slope.Tangent = Blend(slope.Tangent, (sign / second.Distance) * second.Away, share);
  }
  return slope;
}

Vector3 FieldGradient::At(const GridIndex& at) const
{
  if (const PoleRow* pole = this->Plan.Topology().PoleAt(at))
  {
    return this->AtPole(at, *pole);
  }
  Slope slopes[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    slopes[axis] = this->SlopeAlong(axis, at);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!slopes[axis].HasValue) // nothing is known along this axis: as if nothing changed at right
                                // angles to the others
    {
      slopes[axis].Tangent = Cross(slopes[(axis + 1) % 3].Tangent, slopes[(axis + 2) % 3].Tangent);
    }
  }
  const double rows[3][3] = { { slopes[0].Tangent[0], slopes[0].Tangent[1], slopes[0].Tangent[2] },
    { slopes[1].Tangent[0], slopes[1].Tangent[1], slopes[1].Tangent[2] },
    { slopes[2].Tangent[0], slopes[2].Tangent[1], slopes[2].Tangent[2] } };
  return Solve(rows, { { slopes[0].Rise, slopes[1].Rise, slopes[2].Rise } });
}

Vector3 FieldGradient::AtPole(const GridIndex& at, const PoleRow& pole) const
{
  double matrix[3][3] = {};
  Vector3 right = { { 0.0, 0.0, 0.0 } };
  const auto add = [&](const Neighbor& n) {
    const double weight = n.IsThere ? 1.0 / (n.Distance * n.Distance) : 0.0;
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c < 3; ++c)
      {
        matrix[r][c] += weight * n.Away[r] * n.Away[c];
      }
      right[r] += weight * n.Away[r] * n.Rise;
    }
  };
  GridIndex around = at;
  for (around[pole.Along] = 0; around[pole.Along] < this->Plan.Topology().Distinct(pole.Along);
       ++around[pole.Along])
  {
    if (!this->Missing[this->Plan.Topology().Id(around)])
    {
      add(this->Look(pole.Across, around, pole.AtEnd ? -1 : +1));
    }
  }
  const int third = 3 - pole.Along - pole.Across;
  add(this->Look(third, at, -1));
  add(this->Look(third, at, +1));
  return Solve(matrix, right);
}

Vector3 FieldGradient::SteepestStep(const GridIndex& at) const
{
  Neighbor best;
  double steepest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int step : { -1, 1 })
    {
      const Neighbor n = this->Look(axis, at, step);
      if (n.IsThere && std::abs(n.Rise / n.Distance) > steepest)
      {
        steepest = std::abs(n.Rise / n.Distance);
        best = n;
      }
    }
  }
  return (best.Rise > 0.0 ? -1.0 : 1.0) * best.Away;
}

// A field that rises and falls again within three points has a gradient at a grid point that says
// nothing of the edge beside it. Where the two disagree in sign, and by much, the slope of the
// edge, which the surface crosses, is the truth. (By little they also disagree where a smooth
// surface touches the edge; there the gradient is the better one.)
Vector3 FieldGradient::TurnedToEdge(
  const Vector3& gradient, const GridIndex& a, const GridIndex& b) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Neighbor end = a[axis] != b[axis] ? this->Look(axis, a, +1) : Neighbor();
    if (end.IsThere)
    {
      const Vector3 along = (1.0 / end.Distance) * end.Away;
      const double slope = end.Rise / end.Distance;
      const double found = Dot(gradient, along);
      const bool opposed = found * slope <= 0.0 && std::abs(slope - found) > 0.5 * Norm(gradient);
      return opposed ? gradient + (slope - found) * along : gradient;
    }
  }
  return gradient;
}

Vector3 FieldGradient::Outward(const GridIndex& a, const GridIndex& b, double share) const
{
  const Vector3 gradient =
    a == b ? this->At(a) : this->TurnedToEdge(Blend(this->At(a), this->At(b), share), a, b);
  Vector3 outward = -1.0 * gradient;
  double length = Norm(outward);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    outward = this->SteepestStep(a);
    length = Norm(outward);
  }
  return length > 0.0 ? (1.0 / length) * outward : Vector3{ { 0.0, 0.0, 1.0 } };
}
}
