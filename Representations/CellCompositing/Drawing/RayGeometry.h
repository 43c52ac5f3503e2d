// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The rays of a view's pixels, in model coordinates relative to the centre of the data.
 *
 * The ray at p = (x, y) in device coordinates goes through a point and in a direction that are both
 * linear in p. The point lies at the depth of the data's centre, not at the eye: near the data,
 * floats resolve the distance between a ray and a vertex.
 */
#ifndef nephoscope_RayGeometry_h
#define nephoscope_RayGeometry_h

#include "CellDrawing.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

class RayGeometry
{
public:
  using Linear = std::array<float, 9>; ///< columns: constant, times x, times y

  explicit RayGeometry(const CellView& view)
    : View(view)
  {
    vtkNew<vtkMatrix4x4> clip;
    vtkMatrix4x4::Multiply4x4(view.ViewToDevice, view.ModelToView, clip);
    vtkMatrix4x4::Invert(clip, this->ModelFromDevice);
    this->FindRays();
  }

  Linear& Point() { return this->Points; }
  Linear& Direction() { return this->Directions; }
  /** From the eye's plane to the points, which lie in one parallel to it. */
  double Distance() const { return this->PlaneDistance; }

  /** Distances from the eye's plane between which lies all within `radius` of the centre. */
  std::array<float, 2> DepthRange(double radius) const
  {
    double scale = 0; // no direction is stretched by more
    for (int i = 0; i < 9; ++i)
    {
      scale += std::pow(this->View.ModelToView->GetElement(i / 3, i % 3), 2);
    }
    const double reach = 1.001 * radius * std::sqrt(scale);
    const double center = -this->View.ModelToView->GetElement(2, 3);
    return { { static_cast<float>(center - reach), static_cast<float>(center + reach) } };
  }

private:
  using Vector = std::array<double, 3>;

  Vector Unproject(double x, double y, double z) const
  {
    double p[4] = { x, y, z, 1.0 };
    this->ModelFromDevice->MultiplyPoint(p, p);
    return { { p[0] / p[3], p[1] / p[3], p[2] / p[3] } };
  }

  double DistanceFromEyePlane(const Vector& p) const
  {
    const double point[4] = { p[0], p[1], p[2], 1.0 };
    double viewed[4];
    this->View.ModelToView->MultiplyPoint(point, viewed);
    return -viewed[2];
  }

  void FindRays()
  {
    const double corners[3][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    Vector points[3], directions[3];
    for (int k = 0; k < 3; ++k)
    {
      const Vector near = this->Unproject(corners[k][0], corners[k][1], -1.0);
      const Vector far = this->Unproject(corners[k][0], corners[k][1], 1.0);
      const double nearDistance = this->DistanceFromEyePlane(near);
      const double farDistance = this->DistanceFromEyePlane(far);
      const double distance = std::max(this->DistanceFromEyePlane({ { 0, 0, 0 } }), nearDistance);
      this->PlaneDistance = distance;
      const double t = (distance - nearDistance) / (farDistance - nearDistance);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        points[k][axis] = near[axis] + t * (far[axis] - near[axis]);
        directions[k][axis] = far[axis] - near[axis];
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Points[3 * k + axis] =
          static_cast<float>(points[k][axis] - (k ? points[0][axis] : 0.0));
        this->Directions[3 * k + axis] =
          static_cast<float>(directions[k][axis] - (k ? directions[0][axis] : 0.0));
      }
    }
  }

  const CellView& View;
  vtkNew<vtkMatrix4x4> ModelFromDevice;
  Linear Points, Directions;
  double PlaneDistance = 0;
};

} // namespace nephoscope

#endif
