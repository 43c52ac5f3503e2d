// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSlices.h"

#include "ProgressLoop.h"

#include <algorithm>
#include <limits>

namespace nephoscope
{

void FaceSlices::SetFaces(
  const CellGeometry& geometry, const std::vector<BoundaryFace>& faces, std::size_t count)
{
  this->Corners.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const CellGeometry::Point& p = geometry.Points[static_cast<std::size_t>(faces[i][corner])];
      const std::array<float, 3> position = { { p.X, p.Y, p.Z } };
      std::copy(position.begin(), position.end(), this->Corners[i].begin() + 3 * corner);
    }
  }
  this->Slices.clear();
  this->Vertices.clear();
}

void FaceSlices::Sort(const std::array<double, 4>& toDepth, double error)
{
  this->Ranges.resize(this->Corners.size());
  ForEachIndex(this->Corners.size(), {}, [&](std::size_t i) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t corner = 0; corner < 9; corner += 3)
    {
      const float* p = &this->Corners[i][corner];
      const double depth = toDepth[0] * p[0] + toDepth[1] * p[1] + toDepth[2] * p[2] + toDepth[3];
      low = std::min(low, depth);
      high = std::max(high, depth);
    }
    this->Ranges[i] = { static_cast<float>(low - error), static_cast<float>(high + error) };
  });
  // Every slice is a pass over the picture at least, which is worth some thousands of faces; few
  // large ones cost by the pixel.
  constexpr std::size_t mostSlices = 256, facesPerSlice = 8192, fewestPerSlice = 64,
                        slicesOfFew = 16;
  const std::size_t mostListed = std::max<std::size_t>(4 * this->Corners.size(), 1 << 16);
  std::size_t slices = std::min(this->Corners.size() / fewestPerSlice + 1, slicesOfFew);
  slices = std::min(std::max(this->Corners.size() / facesPerSlice, slices), mostSlices);
  Ends ends = this->FindEnds(slices);
  while (!ends.empty() && this->CountListed(ends) > mostListed)
  {
    slices /= 2;
    ends = this->FindEnds(slices);
  }
  this->Slices.clear();
  for (std::size_t s = 0; s <= ends.size(); ++s)
  {
    const float largest = std::numeric_limits<float>::max();
    this->Slices.push_back(
      { s == 0 ? -largest : ends[s - 1], s == ends.size() ? largest : ends[s], 0, 0 });
  }
  const auto forEachListed = [&](auto visit) {
    for (std::size_t i = 0; i < this->Ranges.size(); ++i)
    {
      const std::array<std::size_t, 2> reach = Reach(ends, this->Ranges[i]);
      for (std::size_t s = reach[0]; s <= reach[1]; ++s)
      {
        visit(i, this->Slices[s]);
      }
    }
  };
  forEachListed([](std::size_t, Slice& slice) { slice.Count += 3; });
  std::size_t first = 0;
  for (Slice& slice : this->Slices)
  {
    slice.First = first;
    first += slice.Count;
    slice.Count = 0;
  }
  this->Vertices.resize(first);
  forEachListed([this](std::size_t face, Slice& slice) {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      this->Vertices[slice.First + slice.Count++] = static_cast<std::uint32_t>(3 * face + corner);
    }
  });
}

// Where slices end but the last one, ascending: with as many faces in each, by the middle of some
// thousand of them.
FaceSlices::Ends FaceSlices::FindEnds(std::size_t slices) const
{
  constexpr std::size_t samples = 4096;
  const std::size_t step = std::max<std::size_t>(this->Ranges.size() / samples, 1);
  Ends middles;
  for (std::size_t i = 0; i < this->Ranges.size(); i += step)
  {
    middles.push_back(0.5f * (this->Ranges[i].Low + this->Ranges[i].High));
  }
  std::sort(middles.begin(), middles.end());
  Ends ends;
  for (std::size_t s = 1; s < slices && !middles.empty(); ++s)
  {
    ends.push_back(middles[s * middles.size() / slices]);
  }
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

// The first and the last slice into which the range reaches.
std::array<std::size_t, 2> FaceSlices::Reach(const Ends& ends, const Range& range)
{
  const auto sliceOf = [&](float depth) {
    return static_cast<std::size_t>(
      std::upper_bound(ends.begin(), ends.end(), depth) - ends.begin());
  };
  return { { sliceOf(range.Low), sliceOf(range.High) } };
}

std::size_t FaceSlices::CountListed(const Ends& ends) const
{
  std::size_t count = 0;
  for (const Range& range : this->Ranges)
  {
    const std::array<std::size_t, 2> reach = Reach(ends, range);
    count += reach[1] - reach[0] + 1;
  }
  return count;
}

} // namespace nephoscope
