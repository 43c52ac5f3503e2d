// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridOrder.h"

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nephoscope
{
GridOrder::GridOrder(const Sizes& sizes, const std::vector<Place>& places,
  const std::function<Place(const Place&)>& upAt)
  : Stored(sizes)
  , Ordered(sizes)
{
  double climbs[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    climbs[axis] = this->Climb(axis, places, upAt);
  }
  int up = 2; // unless another axis is clearly steeper
  for (const int axis : { 0, 1 })
  {
    up = std::abs(climbs[axis]) > std::abs(climbs[up]) + 1e-6 ? axis : up;
  }
  std::array<int, 3> axes{ { up == 0 ? 1 : 0, up == 2 ? 1 : 2, up } };
  if (!this->IsClosed(axes[0], places) && this->IsClosed(axes[1], places))
  {
    std::swap(axes[0], axes[1]);
  }
  const bool downwards = climbs[up] < 0;
  if (downwards || axes != std::array<int, 3>{ { 0, 1, 2 } })
  {
    this->Number(axes, downwards);
  }
}

std::size_t GridOrder::Stride(int axis) const
{
  return axis == 0 ? 1
    : axis == 1    ? std::size_t(this->Stored[0])
                   : std::size_t(this->Stored[0]) * this->Stored[1];
}

// The mean sine of the slope along this axis, from some thousand of its edges.
double GridOrder::Climb(
  int axis, const std::vector<Place>& places, const std::function<Place(const Place&)>& upAt) const
{
  const std::size_t stride = this->Stride(axis), every = places.size() / 4096 + 1;
  double sum = 0;
  int count = 0;
  for (std::size_t p = 0; p + stride < places.size(); p += every)
  {
    const Place& here = places[p];
    const Place& next = places[p + stride];
    const Place step{ { next[0] - here[0], next[1] - here[1], next[2] - here[2] } };
    const double length = std::sqrt(dot(step, step));
    const bool isLast = static_cast<int>(p / stride % this->Stored[axis]) == this->Stored[axis] - 1;
    if (!isLast && length > 0 && std::isfinite(length))
    {
      sum += dot(step, upAt(here)) / length;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

// Whether the row in the middle of the grid ends where it begins.
bool GridOrder::IsClosed(int axis, const std::vector<Place>& places) const
{
  std::size_t first = 0;
  for (int other = 0; other < 3; ++other)
  {
    first += other == axis ? 0 : this->Stride(other) * (this->Stored[other] / 2);
  }
  const auto distance = [&](int from, int to) {
    const Place &a = places[first + from * this->Stride(axis)],
                &b = places[first + to * this->Stride(axis)];
    return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
  };
  const int last = this->Stored[axis] - 1;
  return last > 1 && distance(0, last) <= 1e-3 * distance(0, 1);
}

void GridOrder::Number(const std::array<int, 3>& axes, bool downwards)
{
  for (int k = 0; k < 3; ++k)
  {
    this->Ordered[k] = this->Stored[axes[k]];
  }
  this->Numbers.reserve(std::size_t(this->Ordered[0]) * this->Ordered[1] * this->Ordered[2]);
  for (int k = 0; k < this->Ordered[2]; ++k)
  {
    const int level = downwards ? this->Ordered[2] - 1 - k : k;
    for (int j = 0; j < this->Ordered[1]; ++j)
    {
      for (int i = 0; i < this->Ordered[0]; ++i)
      {
        this->Numbers.push_back(static_cast<std::int32_t>(
          i * this->Stride(axes[0]) + j * this->Stride(axes[1]) + level * this->Stride(axes[2])));
      }
    }
  }
}
}
