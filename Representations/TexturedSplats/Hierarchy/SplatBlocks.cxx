// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatBlocks.h"

#include "SplatClasses.h"
#include "SplatSamples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr double largestNode = 4096; // of a sparse volume's tree, in voxels
constexpr std::uint32_t mostBlocks = 1u << BlockOrder::mostBits;

// Lengths of the cells of some of the samples, in the mean.
std::array<double, 3> MeanEdges(const SplatSamples& samples, const SplatClasses& classes)
{
  const std::size_t stride = 1 + classes.Samples.size() / 10000;
  std::array<double, 3> edges{};
  for (std::size_t i = 0; i < classes.Samples.size(); i += stride)
  {
    const auto& j = samples.JacobianOf(static_cast<std::size_t>(classes.Samples[i]));
    for (std::size_t c = 0; c < 3; ++c)
    {
      edges[c] += Norm(ToDouble(j[c]));
    }
  }
  return edges;
}
}

SplatBlocks::SplatBlocks(const SplatSamples& samples, const SplatClasses& classes)
  : Samples(samples)
  , Classes(classes)
{
  const auto& n = samples.Dimensions;
  if (n[0] > 0)
  {
    this->As = Kind::Grid;
    this->Order = BlockOrder({ { std::uint32_t(n[0]), std::uint32_t(n[1]), std::uint32_t(n[2]) } },
      MeanEdges(samples, classes));
  }
  else if (!samples.AreVoxels || !this->UseVoxels())
  {
    this->UseSpace();
  }
}

template <typename Place>
void SplatBlocks::FindRange(Place placeOf, Vector3& low, Vector3& high) const
{
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-low[0]);
  for (const std::int32_t sample : this->Classes.Samples)
  {
    const Vector3 p = placeOf(static_cast<std::size_t>(sample));
    for (std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  }
}

// The middle of a tile is that of a voxel in it.
std::array<double, 3> SplatBlocks::VoxelIndex(std::size_t sample) const
{
  Vector3 index =
    Times(this->ToVoxels, ToDouble(this->Samples.Positions[sample]) - this->Samples.FirstVoxel);
  for (double& i : index)
  {
    i = std::floor(i + 0.5);
  }
  return index;
}

// False if they are too far apart for the codes.
bool SplatBlocks::UseVoxels()
{
  this->ToVoxels = Inverse(this->Samples.Voxel);
  Vector3 high;
  this->FindRange([&](std::size_t sample) { return this->VoxelIndex(sample); }, this->Corner, high);
  BlockOrder::Index sizes;
  std::array<double, 3> edges;
  for (std::size_t c = 0; c < 3; ++c)
  {
    this->Corner[c] = std::floor(this->Corner[c] / largestNode) * largestNode;
    const double size = high[c] - this->Corner[c] + 1.0;
    if (!(size <= mostBlocks))
    {
      return false;
    }
    sizes[c] = static_cast<std::uint32_t>(size);
    edges[c] = Norm(this->Samples.Voxel[c]);
  }
  this->As = Kind::Voxels;
  this->Order = BlockOrder(sizes, edges);
  return true;
}

void SplatBlocks::UseSpace()
{
  Vector3 high;
  this->FindRange([&](std::size_t sample) { return ToDouble(this->Samples.Positions[sample]); },
    this->Corner, high);
  const double edge =
    std::max({ high[0] - this->Corner[0], high[1] - this->Corner[1], high[2] - this->Corner[2] });
  this->BlocksPerLength = edge > 0.0 ? (mostBlocks - 1) / edge : 0.0;
  this->Order = BlockOrder({ { mostBlocks, mostBlocks, mostBlocks } }, { { 1.0, 1.0, 1.0 } });
}

BlockOrder::Index SplatBlocks::IndexOf(std::size_t sample) const
{
  if (this->As == Kind::Grid)
  {
    const vtkIdType nx = this->Samples.Dimensions[0], ny = this->Samples.Dimensions[1];
    const vtkIdType id = this->Samples.Ids[sample];
    return { { static_cast<std::uint32_t>(id % nx), static_cast<std::uint32_t>(id / nx % ny),
      static_cast<std::uint32_t>(id / nx / ny) } };
  }
  const bool voxels = this->As == Kind::Voxels;
  const Vector3 place =
    (voxels ? this->VoxelIndex(sample) : ToDouble(this->Samples.Positions[sample])) - this->Corner;
  const double scale = voxels ? 1.0 : this->BlocksPerLength;
  return { { static_cast<std::uint32_t>(place[0] * scale),
    static_cast<std::uint32_t>(place[1] * scale), static_cast<std::uint32_t>(place[2] * scale) } };
}

} // namespace nephoscope
