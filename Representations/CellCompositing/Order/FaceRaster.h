// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pixel centres that a triangle covers, and its depth there, without clipping: edge functions in homogeneous pixel
 * coordinates (OlanoGreer1997) do not mind corners behind the eye.
 *
 * An edge function is evaluated from the corners in an order that depends on the corners alone. The two triangles at an edge
 * thus see the same number, of which 0 counts as positive: exactly one of them covers the pixel centre.
 */
#ifndef FaceRaster_h
#define FaceRaster_h

#include "OrderView.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{

class FaceRaster
{
public:
  FaceRaster(const OrderView& view, const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const Vector3* model[3] = { &a, &b, &c };
    double z[3];
    for (int k = 0; k < 3; ++k)
    {
      this->Corners[k] = Project(view, *model[k], z[k]);
    }
    const double determinant = dot(this->Corners[0], cross(this->Corners[1], this->Corners[2]));
    this->Positive = determinant > 0;
    this->Visible = determinant != 0 && std::isfinite(determinant);
    Vector3 depth = { { 0, 0, 0 } };
    for (int k = 0; k < 3 && this->Visible; ++k)
    {
      const Vector3& p = this->Corners[(k + 1) % 3];
      const Vector3& q = this->Corners[(k + 2) % 3];
      this->Turned[k] = q < p;
      this->Edges[k] = this->Turned[k] ? cross(q, p) : cross(p, q);
      for (int axis = 0; axis < 3; ++axis)
      {
        depth[axis] += (this->Turned[k] ? -1 : 1) * this->Edges[k][axis] * z[k] / determinant;
      }
    }
    this->Depth = depth;
    this->FindBox(view);
  }

  /** Rows [FirstRow, LastRow) may hold covered pixels. */
  int FirstRow = 0, LastRow = 0;

  /** visit(column, depth) for each pixel of the row that is covered; depth grows along the ray. */
  template <typename Visit>
  void VisitRow(int row, Visit visit) const
  {
    const double y = row + 0.5;
    double base[3];
    for (int k = 0; k < 3; ++k)
    {
      base[k] = this->Edges[k][1] * y + this->Edges[k][2];
    }
    for (int column = this->FirstColumn; column < this->LastColumn; ++column)
    {
      const double x = column + 0.5;
      if (this->Covers(0, this->Edges[0][0] * x + base[0]) &&
        this->Covers(1, this->Edges[1][0] * x + base[1]) &&
        this->Covers(2, this->Edges[2][0] * x + base[2]))
      {
        visit(column, this->Depth[0] * x + this->Depth[1] * y + this->Depth[2]);
      }
    }
  }

private:
  /** Homogeneous pixel coordinates; z is that of the device, not divided by w. */
  static Vector3 Project(const OrderView& view, const Vector3& p, double& z)
  {
    double c[4];
    for (int row = 0; row < 4; ++row)
    {
      const double* m = &view.ModelToDevice[static_cast<std::size_t>(4 * row)];
      c[row] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
    }
    z = c[2];
    return { { 0.5 * view.Width * (c[0] + c[3]), 0.5 * view.Height * (c[1] + c[3]), c[3] } };
  }

  /** Inside all edges, that is on the side of the determinant's sign, lies what is in front of the eye. */
  bool Covers(int edge, double value) const
  {
    return ((value >= 0) != this->Turned[edge]) == this->Positive;
  }

  void FindBox(const OrderView& view)
  {
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    const auto include = [&](const Vector3& p) {
      for (int axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], p[axis] / p[2]);
        high[axis] = std::max(high[axis], p[axis] / p[2]);
      }
    };
    const double largest =
      std::max({ this->Corners[0][2], this->Corners[1][2], this->Corners[2][2] });
    const double nearest =
      1e-6 * largest; // what lies nearer to the eye's plane covers the rest of the picture
    for (int k = 0; k < 3 && largest > 0; ++k)
    {
      const Vector3& p = this->Corners[k];
      const Vector3& q = this->Corners[(k + 1) % 3];
      if (p[2] >= nearest)
      {
        include(p);
      }
      if ((p[2] >= nearest) != (q[2] >= nearest))
      {
        const double u = (nearest - p[2]) / (q[2] - p[2]);
        include({ { p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1]), nearest } });
      }
    }
    const auto clamp = [](double x, int size) {
      return static_cast<int>(std::min(std::max(x, 0.0), double(size)));
    };
    if (this->Visible && low[0] <= high[0] && low[1] <= high[1])
    {
      // A pixel centre is half a pixel in; a little more than that, for rounding.
      this->FirstColumn = clamp(std::floor(low[0] - 0.501), view.Width);
      this->LastColumn = clamp(std::ceil(high[0] + 0.501), view.Width);
      this->FirstRow = clamp(std::floor(low[1] - 0.501), view.Height);
      this->LastRow = clamp(std::ceil(high[1] + 0.501), view.Height);
    }
  }

  std::array<Vector3, 3> Corners, Edges; // edge k is opposite corner k
  Vector3 Depth;
  bool Turned[3] = { false, false, false };
  bool Positive = false;
  bool Visible = false;
  int FirstColumn = 0, LastColumn = 0;
};

} // namespace nephoscope

#endif
