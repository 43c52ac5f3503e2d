// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthTiles.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr double pixelsAround = 3.0;   // splats smaller than a pixel are spread over some
constexpr float depthMargin = 2.0e-5f; // more than a rasterizer errs in depth
}

DepthTiles::DepthTiles(vtkRenderer* renderer, const int viewport[4])
  : Width((viewport[2] + Side - 1) / Side)
  , Height((viewport[3] + Side - 1) / Side)
  , Pixels{ double(viewport[2]), double(viewport[3]) }
  , Ranges(std::size_t(this->Width) * this->Height, { 1.0f, 0.0f })
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* matrix =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      this->Matrix[i][j] = matrix->GetElement(i, j);
    }
  }
  this->IsParallel = camera->GetParallelProjection() != 0;
}

std::array<double, 3> DepthTiles::ToDevice(double x, double y, double z) const
{
  const auto row = [&](int i) {
    const double* m = this->Matrix[i];
    return m[0] * x + m[1] * y + m[2] * z + m[3];
  };
  const double w = row(3);
  return { { row(0) / w, row(1) / w, row(2) / w } };
}

float DepthTiles::DepthAt(double z) const
{
  const double depth = this->IsParallel || z < 0 ? 0.5 + 0.5 * this->ToDevice(0, 0, z)[2] : 0.0;
  return static_cast<float>(std::min(std::max(depth, 0.0), 1.0));
}

// Device coordinates of the rectangle around a cube; all of the screen for one around the eye.
DepthTiles::Rectangle DepthTiles::RectangleOf(
  const std::array<double, 3>& place, double reach) const
{
  if (!this->IsParallel && place[2] + reach >= 0)
  {
    return { { -1, -1 }, { 1, 1 } };
  }
  constexpr double farAway = std::numeric_limits<double>::max();
  Rectangle rectangle = { { farAway, farAway }, { -farAway, -farAway } };
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto side = [&](int axis) { return (corner >> axis & 1) != 0 ? reach : -reach; };
    const std::array<double, 3> seen =
      this->ToDevice(place[0] + side(0), place[1] + side(1), place[2] + side(2));
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      rectangle.Low[axis] = std::min(rectangle.Low[axis], seen[axis]);
      rectangle.High[axis] = std::max(rectangle.High[axis], seen[axis]);
    }
  }
  return rectangle;
}

void DepthTiles::Add(const std::array<double, 3>& place, double reach)
{
  const double nearest = place[2] + reach, farthest = place[2] - reach;
  if (!this->IsParallel && farthest >= 0)
  {
    return; // behind the eye
  }
  const Rectangle rectangle = this->RectangleOf(place, reach);
  const int size[2] = { this->Width, this->Height };
  int first[2], last[2];
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const auto tile = [&](double device, double more) {
      const double pixel = (0.5 + 0.5 * device) * this->Pixels[axis] + more;
      return static_cast<int>(std::floor(std::min(std::max(pixel / Side, -1.0), size[axis] + 1.0)));
    };
    first[axis] = std::max(tile(rectangle.Low[axis], -pixelsAround), 0);
    last[axis] = std::min(tile(rectangle.High[axis], pixelsAround), size[axis] - 1);
  }
  const float nearDepth = std::max(this->DepthAt(nearest) - depthMargin, 0.0f),
              farDepth = std::min(this->DepthAt(farthest) + depthMargin, 1.0f);
  for (int j = first[1]; j <= last[1]; ++j)
  {
    for (int i = first[0]; i <= last[0]; ++i)
    {
      std::array<float, 2>& range = this->Ranges[std::size_t(j) * this->Width + i];
      range = { std::min(range[0], nearDepth), std::max(range[1], farDepth) };
    }
  }
}

double DepthTiles::GetFilling(double nearest, double farthest) const
{
  const double* z = this->Matrix[2];
  const double* w = this->Matrix[3];
  const auto distance = [&](float depth) { // solves the equation of DepthAt
    const double device = 2.0 * depth - 1.0;
    return -(device * w[3] - z[3]) / (z[2] - device * w[2]);
  };
  double sum = 0;
  for (const std::array<float, 2>& range : this->Ranges)
  {
    if (range[0] < range[1])
    {
      sum += std::max(
        std::min(distance(range[1]), farthest) - std::max(distance(range[0]), nearest), 0.0);
    }
  }
  return nearest < farthest ? sum / ((farthest - nearest) * this->Ranges.size()) : 0.0;
}

} // namespace nephoscope
