// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Judges an order by rays: every pixel's ray is clipped against every tetrahedron that is drawn, and what is drawn later must end
 * before what was drawn earlier begins.
 */
#ifndef RayOrder_h
#define RayOrder_h

#include "VisibilityOrder.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace nephoscope_test
{

using namespace nephoscope;

/** A camera whose projection is written down here, with the rays of its pixel centres. */
class PixelCamera
{
public:
  /** `half` is the tangent of half the view angle, or half the height of a parallel view. Places are relative to the centre. */
  PixelCamera(
    const Vector3& eye, const Vector3& focus, double half, bool parallel, int width, int height)
    : Eye(eye)
    , Forward(unit(difference(focus, eye)))
    , Right(unit(cross(this->Forward, { { 0.05, 0.02, 1 } })))
    , Up(cross(this->Right, this->Forward))
    , Half(half)
    , Parallel(parallel)
    , Width(width)
    , Height(height)
  {
  }

  OrderView GetView() const
  {
    OrderView view;
    view.Width = this->Width;
    view.Height = this->Height;
    view.Eye = this->Parallel
      ? Vector4{ { -this->Forward[0], -this->Forward[1], -this->Forward[2], 0 } }
      : Vector4{ { this->Eye[0], this->Eye[1], this->Eye[2], 1 } };
    const double near = 0.01, far = 100;
    for (std::size_t i = 0; i < 3; ++i)
    {
      view.ModelToDevice[i] = this->Right[i] / (this->Half * this->Aspect());
      view.ModelToDevice[4 + i] = this->Up[i] / this->Half;
      view.ModelToDevice[8 + i] =
        this->Forward[i] * (this->Parallel ? 2 / (far - near) : (far + near) / (far - near));
      view.ModelToDevice[12 + i] = this->Parallel ? 0 : this->Forward[i];
    }
    for (std::size_t row = 0; row < 4; ++row)
    {
      double* m = &view.ModelToDevice[4 * row];
      m[3] = -(m[0] * this->Eye[0] + m[1] * this->Eye[1] + m[2] * this->Eye[2]);
    }
    view.ModelToDevice[11] -=
      this->Parallel ? (far + near) / (far - near) : 2 * far * near / (far - near);
    view.ModelToDevice[15] += this->Parallel ? 1 : 0;
    return view;
  }

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

  void Ray(int i, int j, Vector3& origin, Vector3& direction) const
  {
    const double x = (2 * (i + 0.5) / this->Width - 1) * this->Half * this->Aspect();
    const double y = (2 * (j + 0.5) / this->Height - 1) * this->Half;
    origin = this->Eye;
    direction = this->Forward;
    Vector3& moved = this->Parallel ? origin : direction;
    for (std::size_t k = 0; k < 3; ++k)
    {
      moved[k] += x * this->Right[k] + y * this->Up[k];
    }
  }

private:
  static Vector3 unit(const Vector3& v)
  {
    const double length = std::sqrt(dot(v, v));
    return { { v[0] / length, v[1] / length, v[2] / length } };
  }
  double Aspect() const { return double(this->Width) / this->Height; }

  Vector3 Eye, Forward, Right, Up;
  double Half;
  bool Parallel;
  int Width, Height;
};

/** Where a ray enters and leaves a tetrahedron (not before its origin, if it has an eye there); false: it misses. */
inline bool clipRay(const std::array<Vector3, 4>& p, const Vector3& origin,
  const Vector3& direction, bool parallel, double& in, double& out)
{
  in = parallel ? -1e300 : 0;
  out = 1e300;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vector3 &a = p[(i + 1) % 4], &b = p[(i + 2) % 4], &c = p[(i + 3) % 4];
    const double inside = planeSide(a, b, c, { { p[i][0], p[i][1], p[i][2], 1 } });
    const double start = planeSide(a, b, c, { { origin[0], origin[1], origin[2], 1 } }) / inside;
    const double speed =
      planeSide(a, b, c, { { direction[0], direction[1], direction[2], 0 } }) / inside;
    if (speed > 0)
    {
      in = std::max(in, -start / speed);
    }
    else if (speed < 0)
    {
      out = std::min(out, -start / speed);
    }
    else if (start < 0)
    {
      return false;
    }
  }
  return out > in;
}

struct RayCheck
{
  std::int64_t Crossings = 0; ///< of rays and what is drawn
  std::int64_t Inversions =
    0;                   ///< what is drawn later ends behind where something drawn before begins
  double Deepest = 0;    ///< how far behind, at most
  double LargestGap = 0; ///< of a tetrahedron's path, not covered by its pieces
};

inline std::ostream& operator<<(std::ostream& out, const RayCheck& c)
{
  return out << c.Crossings << " crossings, " << c.Inversions << " inverted, by " << c.Deepest
             << " at most; gaps up to " << c.LargestGap;
}

/** Overlaps shorter than `tolerance` are those of rounding, and of cells that differ by rounding. */
inline RayCheck checkRays(const CellGeometry& geometry, const VisibilityOrder::Sorted& sorted,
  const PixelCamera& camera, double tolerance = 1e-4)
{
  const std::size_t whole = geometry.Tetrahedra.size();
  std::vector<std::array<Vector3, 4>> drawn;
  std::vector<std::int32_t> owner;
  for (const std::int32_t number : sorted.Order)
  {
    const std::size_t i = std::size_t(number);
    if (i < whole)
    {
      drawn.push_back(geometry.Vertices(i));
      owner.push_back(number);
      continue;
    }
    std::array<Vector3, 4> p;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const auto& point =
        sorted.Pieces
          .Points[std::size_t(sorted.Pieces.Tetrahedra[i - whole][k]) - geometry.Points.size()];
      p[k] = { { point.X, point.Y, point.Z } };
    }
    drawn.push_back(p);
    owner.push_back(sorted.Pieces.Owners[i - whole]);
  }
  const bool parallel = camera.GetView().Eye[3] == 0;
  RayCheck check;
  for (int j = 0; j < camera.GetHeight(); ++j)
  {
    for (int i = 0; i < camera.GetWidth(); ++i)
    {
      Vector3 origin, direction;
      camera.Ray(i, j, origin, direction);
      double front = 1e300;
      std::map<std::int32_t, double> path; // of owners that are cut
      for (std::size_t k = 0; k < drawn.size(); ++k)
      {
        double in, out;
        if (clipRay(drawn[k], origin, direction, parallel, in, out))
        {
          ++check.Crossings;
          check.Inversions += out > front + tolerance;
          check.Deepest = std::max(check.Deepest, out - front);
          front = std::min(front, in);
          if (!sorted.Pieces.Owners.empty())
          {
            path[owner[k]] += out - in;
          }
        }
      }
      for (const auto& [tetrahedron, length] : path)
      {
        double in = 0, out = 0;
        clipRay(geometry.Vertices(std::size_t(tetrahedron)), origin, direction, parallel, in, out);
        check.LargestGap = std::max(check.LargestGap, std::abs(out - in - length));
      }
    }
  }
  return check;
}

} // namespace nephoscope_test

#endif
