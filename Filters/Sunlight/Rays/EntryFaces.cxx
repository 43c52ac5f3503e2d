// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EntryFaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nephoscope
{
EntryFaces::EntryFaces(const std::vector<SunPoint>& points, std::vector<Face> faces)
  : Faces(std::move(faces))
  , Size(static_cast<std::int32_t>(
      std::min(std::max(std::sqrt(double(this->Faces.size())), 1.0), 1024.0)))
{
  SunBox box;
  for (const Face& face : this->Faces)
  {
    for (const std::int32_t p : face.Points)
    {
      box.Add(points[p]);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double length = box.Most[axis] - box.Least[axis];
    this->Origin[axis] = box.Least[axis];
    this->PerLength[axis] = length > 0 ? this->Size / length : 0;
    this->Rounding = std::max(this->Rounding, 1e-9 * length);
  }
  this->First.assign(std::size_t(this->Size) * this->Size + 1, 0);
  this->ForPixels(points, [this](std::size_t pixel, std::int32_t) { ++this->First[pixel + 1]; });
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  this->InPixel.resize(this->First.back());
  std::vector<std::size_t> place(this->First.begin(), this->First.end() - 1);
  this->ForPixels(
    points, [&](std::size_t pixel, std::int32_t face) { this->InPixel[place[pixel]++] = face; });
}

template <typename Body>
void EntryFaces::ForPixels(const std::vector<SunPoint>& points, Body body) const
{
  for (std::size_t face = 0; face < this->Faces.size(); ++face)
  {
    SunBox box;
    for (const std::int32_t p : this->Faces[face].Points)
    {
      box.Add(points[p]);
    }
    for (std::int32_t j = this->Pixel(box.Least[1], 1); j <= this->Pixel(box.Most[1], 1); ++j)
    {
      for (std::int32_t i = this->Pixel(box.Least[0], 0); i <= this->Pixel(box.Most[0], 0); ++i)
      {
        body(i + this->Size * std::size_t(j), static_cast<std::int32_t>(face));
      }
    }
  }
}

std::int32_t EntryFaces::Pixel(double x, int axis) const
{
  const double pixel = (x - this->Origin[axis]) * this->PerLength[axis];
  return pixel > 0 ? static_cast<std::int32_t>(std::min(pixel, this->Size - 1.0)) : 0;
}

std::int32_t EntryFaces::Next(const std::vector<SunPoint>& points, double last, SunRay& ray,
  std::array<std::int32_t, 3>& entered) const
{
  std::int32_t tetrahedron = -1;
  if (this->Faces.empty())
  {
    return tetrahedron;
  }
  const double from = ray.Height() - this->Rounding;
  const SunRay left = ray;
  const std::size_t pixel =
    this->Pixel(ray.Across(0), 0) + this->Size * std::size_t(this->Pixel(ray.Across(1), 1));
  for (std::size_t k = this->First[pixel]; k < this->First[pixel + 1]; ++k)
  {
    const Face& face = this->Faces[this->InPixel[k]];
    const auto& p = face.Points;
    SunRay at = left;
    const int turn = at.Enter(points[p[0]], points[p[1]], points[p[2]]);
    if (turn != 0 && at.Height() >= from && at.Height() > last &&
      (tetrahedron < 0 || at.Height() < ray.Height()))
    {
      ray = at;
      tetrahedron = face.Tetrahedron;
      entered = turn > 0 ? p : std::array<std::int32_t, 3>{ { p[0], p[2], p[1] } };
    }
  }
  return tetrahedron;
}
}
