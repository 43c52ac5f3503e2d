// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The samples of a dataset that become splats: where they are and which shape they have.
 *
 * A sample is a point, or the centre of a cell where the data are on cells. Its shape is the
 * Jacobian of its grid cell: three edge vectors, by central differences on structured grids. Where
 * there is no grid (particles, unstructured points) it is a ball of the cell size that is asked
 * for, or of the mean spacing; samples of unstructured cells have the shape of those
 * (CellSamples.h).
 *
 * Samples stand in an order that does not depend on the order of the input: by x, then y, then z,
 * then their values.
 */
#ifndef nephoscope_SplatSamples_h
#define nephoscope_SplatSamples_h

#include "SampleIds.h"
#include "SplatShapes.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

struct SplatSamples
{
  using Float3 = std::array<float, 3>;
  using Jacobian = std::array<Float3, 3>; ///< columns

  double Center[3] = { 0, 0, 0 }; ///< positions are relative to it
  std::vector<Float3> Positions;
  bool HaveOneShape = false;
  std::vector<Jacobian>
    Jacobians; ///< one for each sample, or a single one for all; none after FreeJacobians
  std::vector<Jacobian>
    SomeJacobians;           ///< of every StrideOfSome()-th sample, which stay; or the single one
  std::vector<float> Shares; ///< of each sample, the part of its cell that counts; empty: all of it
  SampleIds Ids;             ///< of the point or cell

  double LongestEdge = 0; ///< largest factor by which any Jacobian stretches a length
  /** Dimensions of the structured grid whose samples these are: Ids count along x, y, z. */
  int Dimensions[3] = { 0, 0, 0 };

  /**
   * Whether these are voxels of a sparse volume, with the edges Voxel; FirstVoxel (relative to the
   * centre) is where indices are 0.
   */
  bool AreVoxels = false;
  SplatMatrix Voxel{};
  Vector3 FirstVoxel{};

  // Left out, for the mapper to report.
  std::size_t NumberNowhere = 0;      ///< a coordinate is not finite
  std::size_t NumberOfWrongSizes = 0; ///< of the array of sizes: not positive or not finite

  std::size_t Size() const { return this->Positions.size(); }
  const Jacobian& JacobianOf(std::size_t i) const
  {
    return this->Jacobians[this->HaveOneShape ? 0 : i];
  }
  /** So that means over the samples need 10,000 to 20,000 of them. */
  std::size_t StrideOfSome() const { return std::max<std::size_t>(1, this->Size() / 10000); }
  const Jacobian& SomeJacobianOf(std::size_t i) const
  {
    return this->SomeJacobians[this->HaveOneShape ? 0 : i / this->StrideOfSome()];
  }
  /** To be called while the samples have them. */
  void FreeJacobians();
  float ShareOf(std::size_t i) const { return this->Shares.empty() ? 1.0f : this->Shares[i]; }
};

/** Bounds of the points with finite positions. */
void FindPlaceBounds(vtkDataSet* data, double bounds[6]);

/**
 * Edge of a cube that each of so many samples would have if they filled the bounds; 1 where they
 * are all in one place.
 */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT double MeanSpacing(
  const double bounds[6], std::size_t count);

/** Along which the bounds have an extent. */
int NumberOfAxes(const double bounds[6]);

/** Those of samples that have been found with these shapes. */
void FindJacobians(const SplatShapes& shapes, SplatSamples& samples);

/**
 * Hidden and duplicate samples, and those without a finite position, are left out. Empty result or
 * `error`.
 */
SplatSamples FindSplatSamples(vtkDataSet* data, const SplatSampling& sampling, std::string& error);

} // namespace nephoscope

#endif
