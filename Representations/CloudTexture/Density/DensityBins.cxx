// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityBins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr double mostBinsPerTetrahedron = 4;
constexpr double mostEntriesPerTetrahedron = 16;
// A fraction of a bin, by which tetrahedra are taken for larger: places along a ray are known to
// about 1e-6 of the whole.
constexpr double slack = 2e-3;
// A fraction of a bin, from the low end of the data to the first border: borders should not lie on
// those of regular cells.
constexpr double shift = 0.37;

using Box = std::array<double, 6>;
using Direction = std::array<double, 3>;

Box BoxOf(const DensityTetrahedra& cells, const DensityTetrahedra::Corners& corners)
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto less = [&](std::int32_t a, std::int32_t b) {
      return cells.Points[a][axis] < cells.Points[b][axis];
    };
    const auto ends = std::minmax_element(corners.begin(), corners.end(), less);
    box[2 * axis] = cells.Points[*ends.first][axis];
    box[2 * axis + 1] = cells.Points[*ends.second][axis];
  }
  return box;
}

/** The four planes of a tetrahedron: what is before one of them is outside. */
class Planes
{
public:
  Planes(const DensityTetrahedra& cells, const DensityTetrahedra::Corners& corners)
  {
    for (int face = 0; face < 4; ++face)
    {
      const auto &a = cells.Points[corners[(face + 1) & 3]],
                 &b = cells.Points[corners[(face + 2) & 3]],
                 &c = cells.Points[corners[(face + 3) & 3]], &inside = cells.Points[corners[face]];
      Direction u, v, toInside;
      for (int axis = 0; axis < 3; ++axis)
      {
        u[axis] = double(b[axis]) - a[axis];
        v[axis] = double(c[axis]) - a[axis];
        toInside[axis] = double(inside[axis]) - a[axis];
      }
      Direction& n = this->Normals[face];
      n = { { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] } };
      const double sign = n[0] * toInside[0] + n[1] * toInside[1] + n[2] * toInside[2] > 0 ? -1 : 1;
      this->Offsets[face] = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        n[axis] *= sign;
        this->Offsets[face] += n[axis] * a[axis];
      }
    }
  }

  bool Exclude(const Direction& low, const Direction& high) const
  {
    for (int face = 0; face < 4; ++face)
    {
      double least = -this->Offsets[face];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double n = this->Normals[face][axis];
        least += n * (n > 0 ? low[axis] : high[axis]);
      }
      if (least > 0)
      {
        return true;
      }
    }
    return false;
  }

private:
  Direction Normals[4]; // they point outwards
  double Offsets[4];
};
}

template <typename Visit>
void DensityBins::VisitBins(
  const DensityTetrahedra& cells, std::size_t tetrahedron, Visit visit) const
{
  const auto& corners = cells.Tetrahedra[tetrahedron];
  const Box box = BoxOf(cells, corners);
  const Planes planes(cells, corners);
  int first[3], last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto binOf = [&](double x, double more) {
      const double bin = std::floor((x - this->Low[axis]) / this->Size[axis] + more);
      return static_cast<int>(std::min(std::max(bin, 0.0), this->Counts[axis] - 1.0));
    };
    first[axis] = binOf(box[2 * axis], -slack);
    last[axis] = binOf(box[2 * axis + 1], slack);
  }
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        const int at[3] = { x, y, z };
        Direction low, high;
        for (int axis = 0; axis < 3; ++axis)
        {
          low[axis] = this->Low[axis] + (at[axis] - slack) * this->Size[axis];
          high[axis] = this->Low[axis] + (at[axis] + 1 + slack) * this->Size[axis];
        }
        if (!planes.Exclude(low, high))
        {
          visit(static_cast<std::size_t>(x + this->Counts[0] * (y + this->Counts[1] * z)));
        }
      }
    }
  }
}

// From a sample of the tetrahedra.
double DensityBins::EntriesPerTetrahedron(const DensityTetrahedra& cells) const
{
  const std::size_t step = 1 + this->Number / 1000;
  std::size_t entries = 0, looked = 0;
  for (std::size_t i = 0; i < this->Number; i += step, ++looked)
  {
    this->VisitBins(cells, i, [&entries](std::size_t) { ++entries; });
  }
  return static_cast<double>(entries) / static_cast<double>(looked);
}

void DensityBins::ChooseSize(const DensityTetrahedra& cells)
{
  this->Number = cells.Tetrahedra.size();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Bounds[2 * axis] = HUGE_VAL;
    this->Bounds[2 * axis + 1] = -HUGE_VAL;
    this->Extents[axis] = 0;
  }
  for (const auto& corners : cells.Tetrahedra)
  {
    const Box box = BoxOf(cells, corners);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] = std::min(this->Bounds[2 * axis], box[2 * axis]);
      this->Bounds[2 * axis + 1] = std::max(this->Bounds[2 * axis + 1], box[2 * axis + 1]);
      this->Extents[axis] +=
        (box[2 * axis + 1] - box[2 * axis]) / static_cast<double>(this->Number);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double all = this->Bounds[2 * axis + 1] - this->Bounds[2 * axis];
    this->Size[axis] = static_cast<float>(
      std::max(std::min(this->Extents[axis], std::cbrt(cells.MeanBoxVolume)), 1e-3 * all));
  }
  this->FindCounts();
  while (double(this->Counts[0]) * this->Counts[1] * this->Counts[2] >
      64 + mostBinsPerTetrahedron * this->Number ||
    this->EntriesPerTetrahedron(cells) > mostEntriesPerTetrahedron)
  {
    for (float& size : this->Size)
    {
      size *= 1.25f;
    }
    this->FindCounts();
  }
}

void DensityBins::FindCounts()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double all = this->Bounds[2 * axis + 1] - this->Bounds[2 * axis];
    this->Low[axis] = static_cast<float>(this->Bounds[2 * axis] - shift * this->Size[axis]);
    this->Counts[axis] = 1 + static_cast<int>(all / this->Size[axis] + shift + 2 * slack);
  }
}

void DensityBins::Sort(const DensityTetrahedra& cells)
{
  if (cells.Tetrahedra.empty())
  {
    return;
  }
  this->ChooseSize(cells);
  const std::size_t bins = std::size_t(this->Counts[0]) * this->Counts[1] * this->Counts[2];
  this->Lists.assign(bins + 1, 0);
  for (std::size_t i = 0; i < this->Number; ++i)
  {
    this->VisitBins(cells, i, [this](std::size_t bin) { ++this->Lists[bin]; });
  }
  std::int32_t next = static_cast<std::int32_t>(bins + 1);
  for (std::int32_t& count :
    this->Lists) // to the ends of the lists; filling moves them to their beginnings
  {
    next += count;
    count = next;
  }
  this->Lists.resize(static_cast<std::size_t>(next));
  for (std::size_t i = this->Number; i-- > 0;)
  {
    this->VisitBins(cells, i, [this, i](std::size_t bin) {
      this->Lists[static_cast<std::size_t>(--this->Lists[bin])] = static_cast<std::int32_t>(i);
    });
  }
}

} // namespace nephoscope
