// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How a particle's mass is shared by the eight voxels around it (HockneyEastwood1988, Sec. 5-2:
// cloud in cell). Plain C++17.
#ifndef nephoscope_CloudInCell_h
#define nephoscope_CloudInCell_h

#include <array>
#include <cmath>

namespace nephoscope
{
struct CloudInCell
{
  std::array<int, 3> First{};    // voxel with the lowest indices
  std::array<double, 3> Upper{}; // share of its upper neighbour along each axis

  // Weights are not negative, their sum is 1, and their mean place is the particle's: mass and its
  // centre are kept.
  double Weight(int corner) const
  {
    double weight = 1;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      weight *= corner >> axis & 1 ? this->Upper[axis] : 1 - this->Upper[axis];
    }
    return weight;
  }
  std::array<int, 3> Voxel(int corner) const
  {
    return { { this->First[0] + (corner & 1), this->First[1] + (corner >> 1 & 1),
      this->First[2] + (corner >> 2 & 1) } };
  }
};

// `index` is the place in indices of voxel centres, below 2^30 each.
inline CloudInCell CloudInCellAt(const std::array<double, 3>& index)
{
  CloudInCell share;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double below = std::floor(index[axis]);
    share.First[axis] = static_cast<int>(below);
    share.Upper[axis] = index[axis] - below;
  }
  return share;
}
}

#endif
