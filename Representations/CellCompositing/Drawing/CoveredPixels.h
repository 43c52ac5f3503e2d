// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which pixels of a picture a box can cover: what lies outside is neither cleared nor drawn nor
 * laid over the scene.
 */
#ifndef nephoscope_CoveredPixels_h
#define nephoscope_CoveredPixels_h

#include "FloatLayer.h"
#include "ViewState.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nephoscope
{

/** Least and greatest coordinate along each axis, of nothing at first. */
struct PointBounds
{
  std::array<double, 3> Low = { { Largest, Largest, Largest } },
                        High = { { -Largest, -Largest, -Largest } };

  void Add(const std::array<double, 3>& p)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], p[axis]);
      this->High[axis] = std::max(this->High[axis], p[axis]);
    }
  }

private:
  static constexpr double Largest = std::numeric_limits<double>::max();
};

/** All pixels where the box reaches behind the eye. */
inline PixelRegion CoveredPixels(
  const SceneView& view, const PointBounds& bounds, const int viewport[4])
{
  constexpr int margin = 2;
  const PixelRegion all = { { 0, 0, viewport[2], viewport[3] } };
  vtkNew<vtkMatrix4x4> toDevice;
  vtkMatrix4x4::Multiply4x4(view.ViewToDevice, view.ModelToView, toDevice);
  double low[2] = { 1, 1 }, high[2] = { -1, -1 }; // device coordinates
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[4] = { 0, 0, 0, 1 };
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = (corner >> axis & 1 ? bounds.High : bounds.Low)[static_cast<std::size_t>(axis)];
    }
    toDevice->MultiplyPoint(p, p);
    for (int axis = 0; axis < 2; ++axis)
    {
      const double x = p[axis] / p[3];
      if (!(p[3] > 0) || !std::isfinite(x))
      {
        return all;
      }
      low[axis] = std::max(std::min(low[axis], x), -1.0);
      high[axis] = std::min(std::max(high[axis], x), 1.0);
    }
  }
  PixelRegion region;
  for (int axis = 0; axis < 2; ++axis)
  {
    const int size = viewport[2 + axis];
    const int first = static_cast<int>(std::floor(0.5 * (low[axis] + 1) * size)) - margin;
    const int end = static_cast<int>(std::ceil(0.5 * (high[axis] + 1) * size)) + margin;
    const std::size_t a = static_cast<std::size_t>(axis);
    region[a] = std::min(std::max(first, 0), size);
    region[2 + a] = std::max(std::min(end, size) - region[a], 0);
  }
  return region;
}

/** The least rectangle that holds both, of which one may be empty. */
inline PixelRegion UnionOf(const PixelRegion& a, const PixelRegion& b)
{
  if (a[2] <= 0 || a[3] <= 0 || b[2] <= 0 || b[3] <= 0)
  {
    return a[2] <= 0 || a[3] <= 0 ? b : a;
  }
  PixelRegion all;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    all[axis] = std::min(a[axis], b[axis]);
    all[2 + axis] = std::max(a[axis] + a[2 + axis], b[axis] + b[2 + axis]) - all[axis];
  }
  return all;
}

inline bool HaveCommonPixels(const PixelRegion& a, const PixelRegion& b)
{
  return std::max(a[0], b[0]) < std::min(a[0] + a[2], b[0] + b[2]) &&
    std::max(a[1], b[1]) < std::min(a[1] + a[3], b[1] + b[3]);
}

} // namespace nephoscope

#endif
