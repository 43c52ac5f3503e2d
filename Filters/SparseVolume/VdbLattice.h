// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Grids from values on a lattice: the samples of an image, or points that represent voxels. */
#ifndef nephoscope_VdbLattice_h
#define nephoscope_VdbLattice_h

#include "VdbArrays.h"

class vtkImageData;
class vtkDataSet;

namespace nephoscope
{

struct LatticeCounts
{
  vtkIdType NotFinite = 0; ///< NaN and infinite values, which become background
};

/** Fills `grid`, which is of the type for the array, with the point or cell values of the image. */
LatticeCounts FillFromImage(openvdb::GridBase& grid, vtkImageData* image, vtkDataArray* array,
  bool onCells, double tolerance);

/** Points that represent voxels or tiles of a lattice. */
struct LatticePoints
{
  AffineMatrix IndexToWorld{};
  std::vector<openvdb::CoordBBox>
    Boxes; ///< of each point, in voxels; empty if they are no such points
};

/**
 * The points are voxels if they are as vtkSparseVolumeReader makes them: "IndexToWorld" in the
 * field data, and each at whole indices or, by "VoxelScale", in the middle of a tile.
 */
LatticePoints FindLatticePoints(vtkDataSet* data);

LatticeCounts FillFromPoints(
  openvdb::GridBase& grid, const LatticePoints& points, vtkDataArray* array);

} // namespace nephoscope

#endif
