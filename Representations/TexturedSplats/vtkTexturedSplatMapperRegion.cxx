// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a process in a picture that several draw together: SplatRegion.h.
#include "vtkTexturedSplatMapper.h"

#include "SplatPass.h"
#include "SplatRegion.h"
#include "SplatShapes.h"

#include <algorithm>

using nephoscope::SplatRegion;

namespace
{
SplatRegion ToRegion(const double bounds[6])
{
  SplatRegion region;
  std::copy_n(bounds, 6, region.begin());
  return region;
}
}

void vtkTexturedSplatMapper::SetCommonFrame(
  const double origin[3], double longestEdge, vtkIdType numberOfSamples)
{
  if (std::equal(origin, origin + 3, this->CommonOrigin) &&
    longestEdge == this->CommonLongestEdge && numberOfSamples == this->CommonNumberOfSamples)
  {
    return;
  }
  std::copy_n(origin, 3, this->CommonOrigin);
  this->CommonLongestEdge = longestEdge;
  this->CommonNumberOfSamples = numberOfSamples;
  this->Modified();
}

// Nodes of the hierarchy reach too far beyond the border to be exchanged. All processes must answer
// alike.
bool vtkTexturedSplatMapper::DrawsRegion(vtkRenderer* renderer) const
{
  vtkIdType most = 0;
  return nephoscope::IsRegion(ToRegion(this->Region)) &&
    !this->UsesHierarchy(renderer, this->CommonNumberOfSamples, most);
}

nephoscope::SplatSampling vtkTexturedSplatMapper::GetSampling(bool onCells) const
{
  nephoscope::SplatSampling sampling{ onCells, this->CellSize, this->ShapeArrayName,
    this->RadiusFactor };
  sampling.SizeArrayName = this->CellSizeArrayName;
  sampling.SizesAreVolumes = this->CellSizeArrayHoldsVolumes;
  sampling.FromCells = this->CellSizeFromCells;
  sampling.FromNeighbors = this->CellSizeFromNeighbors;
  sampling.WholeCells = onCells;
  if (nephoscope::IsRegion(ToRegion(this->Region)))
  {
    const double* o = this->CommonOrigin;
    sampling.Frame.Origin = std::array<double, 3>{ { o[0], o[1], o[2] } };
    sampling.Frame.LongestEdge = this->CommonLongestEdge * this->RadiusFactor;
    sampling.Frame.WithNeighbors = this->WithNeighbors;
  }
  return sampling;
}

void vtkTexturedSplatMapper::SetRegionOptions(nephoscope::SplatDrawingOptions& options) const
{
  if (!this->WithNeighbors)
  {
    return;
  }
  options.Region = ToRegion(this->Region);
  for (std::size_t i = 0; i < 6; ++i)
  {
    options.Region[i] -= this->CommonOrigin[i / 2];
  }
}
