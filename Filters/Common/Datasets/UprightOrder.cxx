// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UprightOrder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nephoscope
{
UprightOrder::UprightOrder(const Sizes& sizes, const PlaceOf& placeOf, const UpAt& upAt)
  : Stored(sizes)
  , Ordered(sizes)
{
  double climbs[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    climbs[axis] = this->Climb(axis, placeOf, upAt);
  }
  int up = 2; // unless another axis is clearly steeper
  for (const int axis : { 0, 1 })
  {
    up = std::abs(climbs[axis]) > std::abs(climbs[up]) + 1e-6 ? axis : up;
  }
  this->Axes = { { up == 0 ? 1 : 0, up == 2 ? 1 : 2, up } };
  if (!this->IsClosed(this->Axes[0], placeOf) && this->IsClosed(this->Axes[1], placeOf))
  {
    std::swap(this->Axes[0], this->Axes[1]);
  }
  this->Downwards = climbs[up] < 0;
  this->Number();
}

UprightOrder UprightOrder::OfCells() const
{
  UprightOrder cells = *this;
  for (int& size : cells.Stored)
  {
    size = std::max(size - 1, 1);
  }
  cells.Number();
  return cells;
}

std::size_t UprightOrder::Stride(int axis) const
{
  return axis == 0 ? 1
    : axis == 1    ? std::size_t(this->Stored[0])
                   : std::size_t(this->Stored[0]) * this->Stored[1];
}

// The mean sine of the slope along this axis, from some thousand of its edges.
double UprightOrder::Climb(int axis, const PlaceOf& placeOf, const UpAt& upAt) const
{
  const std::size_t points = std::size_t(this->Stored[0]) * this->Stored[1] * this->Stored[2],
                    stride = this->Stride(axis), every = points / 4096 + 1;
  double sum = 0;
  int count = 0;
  for (std::size_t p = 0; p + stride < points; p += every)
  {
    const Vector3 here = placeOf(p), step = placeOf(p + stride) - here;
    const double length = Norm(step);
    const bool isLast = static_cast<int>(p / stride % this->Stored[axis]) == this->Stored[axis] - 1;
    if (!isLast && length > 0 && std::isfinite(length))
    {
      sum += Dot(step, upAt(here)) / length;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

// Whether the row in the middle of the grid ends where it begins.
bool UprightOrder::IsClosed(int axis, const PlaceOf& placeOf) const
{
  std::size_t first = 0;
  for (int other = 0; other < 3; ++other)
  {
    first += other == axis ? 0 : this->Stride(other) * (this->Stored[other] / 2);
  }
  const auto placeAt = [&](int index) { return placeOf(first + index * this->Stride(axis)); };
  const int last = this->Stored[axis] - 1;
  return last > 1 && Distance(placeAt(0), placeAt(last)) <= 1e-3 * Distance(placeAt(0), placeAt(1));
}

void UprightOrder::Number()
{
  for (int k = 0; k < 3; ++k)
  {
    this->Ordered[k] = this->Stored[this->Axes[k]];
  }
  this->Numbers.clear();
  if (!this->Downwards && this->Axes == std::array<int, 3>{ { 0, 1, 2 } })
  {
    return;
  }
  const std::size_t strides[3] = { this->Stride(this->Axes[0]), this->Stride(this->Axes[1]),
    this->Stride(this->Axes[2]) };
  this->Numbers.reserve(std::size_t(this->Ordered[0]) * this->Ordered[1] * this->Ordered[2]);
  for (int k = 0; k < this->Ordered[2]; ++k)
  {
    const std::size_t level = strides[2] * (this->Downwards ? this->Ordered[2] - 1 - k : k);
    for (int j = 0; j < this->Ordered[1]; ++j)
    {
      for (int i = 0; i < this->Ordered[0]; ++i)
      {
        this->Numbers.push_back(static_cast<std::int32_t>(level + j * strides[1] + i * strides[0]));
      }
    }
  }
}
}
