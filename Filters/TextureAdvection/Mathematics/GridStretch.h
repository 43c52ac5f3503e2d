// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How much a map of the points of a grid stretches their surroundings. Plain C++17.
#ifndef nephoscope_GridStretch_h
#define nephoscope_GridStretch_h

#include "FlowMapStretch.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{
struct StretchGrid
{
  std::array<int, 3> Points; // axis 0 fastest
  int Axes = 3;              // 2: within the layers of axis 2
  bool Closed = false;       // the last points of axis 0 are the first ones
};

// By differences of neighbours to either side, on any curvilinear grid: the images of the grid's
// own directions are made those of orthonormal ones. Axes of one point, or on which neighbours
// coincide, do not count.
class GridStretch
{
public:
  GridStretch(const StretchGrid& grid, const std::vector<std::array<double, 3>>& from,
    const std::vector<std::array<double, 3>>& to)
    : Grid(grid)
    , From(from)
    , To(to)
  {
  }

  double At(const std::array<int, 3>& point) const
  {
    Matrix3 images{};
    Matrix3 directions{};
    std::size_t found = 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(this->Grid.Axes); ++axis)
    {
      Vector way = this->Difference(this->From, point, axis);
      Vector image = this->Difference(this->To, point, axis);
      const double whole = Length(way);
      for (std::size_t e = 0; e < found; ++e)
      {
        const double along =
          way[0] * directions[e][0] + way[1] * directions[e][1] + way[2] * directions[e][2];
        Add(way, -along, directions[e]);
        Add(image, -along, images[e]);
      }
      const double length = Length(way);
      if (length > 1e-9 * whole && whole > 1e-14 * this->Scale())
      {
        Add(directions[found], 1.0 / length, way);
        Add(images[found], 1.0 / length, image);
        ++found;
      }
    }
    return found > 0 ? LargestStretch(images) : 1.0;
  }

private:
  using Vector = std::array<double, 3>;

  static double Length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }
  double Scale() const { return Length(this->From.front()) + Length(this->From.back()); }

  static void Add(Vector& sum, double factor, const Vector& v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += factor * v[c];
    }
  }

  Vector Difference(
    const std::vector<Vector>& values, const std::array<int, 3>& point, std::size_t axis) const
  {
    const int last = this->Grid.Points[axis] - 1;
    std::array<int, 3> low = point;
    std::array<int, 3> high = point;
    const bool closed = axis == 0 && this->Grid.Closed;
    low[axis] = point[axis] > 0 ? point[axis] - 1 : closed ? last - 1 : 0;
    high[axis] = point[axis] < last ? point[axis] + 1 : closed ? 1 : last;
    Vector difference = values[this->Index(high)];
    Add(difference, -1.0, values[this->Index(low)]);
    return difference;
  }

  std::size_t Index(const std::array<int, 3>& p) const
  {
    const auto& n = this->Grid.Points;
    return static_cast<std::size_t>(
      p[0] + std::int64_t{ n[0] } * (p[1] + std::int64_t{ n[1] } * p[2]));
  }

  StretchGrid Grid;
  const std::vector<Vector>& From;
  const std::vector<Vector>& To;
};
}

#endif
