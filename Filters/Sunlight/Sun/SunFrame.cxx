// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunFrame.h"

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
std::vector<SunPoint> SunPoints(const std::vector<Place>& places, const std::vector<Fields>& fields,
  const std::vector<std::int32_t>& merged, const Place& towardsSun, const Loop& loop)
{
  const Place helper = std::abs(towardsSun[2]) < 0.9 ? Place{ { 0, 0, 1 } } : Place{ { 1, 0, 0 } };
  Place x = Cross(helper, towardsSun);
  x = (1 / std::sqrt(Dot(x, x))) * x;
  const Place y = Cross(towardsSun, x);
  std::vector<SunPoint> points(places.size());
  loop(static_cast<std::int64_t>(places.size()), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      const std::size_t p = merged.empty() ? i : merged[i];
      points[i] = { Dot(places[p], x), Dot(places[p], y), Dot(places[p], towardsSun), fields[p] };
    }
  });
  return points;
}

namespace
{
constexpr double never = std::numeric_limits<double>::max();
}

SunBox::SunBox()
  : Least{ never, never }
  , Most{ -never, -never }
  , Height(-never)
{
}

void SunBox::Add(const SunPoint& point)
{
  const double at[2] = { point.X, point.Y };
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Least[axis] = std::min(this->Least[axis], at[axis]);
    this->Most[axis] = std::max(this->Most[axis], at[axis]);
  }
  this->Height = std::max(this->Height, point.Z);
}

LastClouds::LastClouds(const std::vector<SunPoint>& points)
  : Size(static_cast<int>(std::min(std::max(std::sqrt(double(points.size())), 16.0), 1024.0)))
  , Heights(std::size_t(this->Size) * this->Size, -never)
{
  SunBox box;
  for (const SunPoint& point : points)
  {
    box.Add(point);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double length = box.Most[axis] - box.Least[axis];
    this->Origin[axis] = box.Least[axis];
    this->PerLength[axis] = length > 0 ? this->Size / length : 0;
  }
}

int LastClouds::Pixel(double x, int axis) const
{
  const double pixel = (x - this->Origin[axis]) * this->PerLength[axis];
  return pixel > 0 ? static_cast<int>(std::min(pixel, this->Size - 1.0)) : 0;
}

// A little farther than the cell, since rays pass beside points.
void LastClouds::Raise(const SunBox& box)
{
  int from[2], to[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double beside = 1e-6 * (box.Most[axis] - box.Least[axis]);
    from[axis] = this->Pixel(box.Least[axis] - beside, axis);
    to[axis] = this->Pixel(box.Most[axis] + beside, axis);
  }
  for (int j = from[1]; j <= to[1]; ++j)
  {
    for (int i = from[0]; i <= to[0]; ++i)
    {
      double& height = this->Heights[i + this->Size * std::size_t(j)];
      height = std::max(height, box.Height);
    }
  }
}

std::vector<std::int32_t> MergedPoints(const std::vector<Place>& places)
{
  constexpr std::int32_t none = -1;
  double largest = 0;
  for (const Place& p : places)
  {
    for (const double x : p)
    {
      largest = std::isfinite(x) ? std::max(largest, std::abs(x)) : largest;
    }
  }
  const double step = std::max(largest, 1e-300) * 1e-9;
  std::size_t size = 1024;
  while (size < 2 * places.size())
  {
    size *= 2;
  }
  std::vector<std::int32_t> heads(size, none), next(places.size(), none), merged(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::uint64_t key = 0;
    for (const double x : places[i])
    {
      key = (key ^ static_cast<std::uint64_t>(std::isfinite(x) ? std::llround(x / step) : 0)) *
        0x9E3779B97F4A7C15ull;
      key ^= key >> 32;
    }
    std::int32_t& head = heads[key & (size - 1)];
    std::int32_t j = head;
    while (j != none &&
      !(std::abs(places[j][0] - places[i][0]) + std::abs(places[j][1] - places[i][1]) +
          std::abs(places[j][2] - places[i][2]) <=
        3 * step))
    {
      j = next[j];
    }
    merged[i] = j == none ? static_cast<std::int32_t>(i) : j;
    if (j == none)
    {
      next[i] = head;
      head = static_cast<std::int32_t>(i);
    }
  }
  return merged;
}
}
