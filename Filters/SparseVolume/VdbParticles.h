// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Particles as the density of their mass, and means of their values weighted with it. */
#ifndef nephoscope_VdbParticles_h
#define nephoscope_VdbParticles_h

#include "VdbArrays.h"

class vtkDataSet;

namespace nephoscope
{

class VdbParticles
{
public:
  /** `masses` may be null: 1 for each. `voxelSize` 0: the mean spacing. */
  VdbParticles(vtkDataSet* data, vtkDataArray* masses, double voxelSize);

  /** Why there can be no grids; empty if there can. */
  const std::string& GetError() const { return this->Error; }
  /** Particles without a finite position, or whose mass is negative or not a number. */
  vtkIdType GetNumberOfLost() const { return this->Lost; }

  /** Mass over volume: its integral is the mass of the particles. */
  void FillDensity(openvdb::GridBase& grid) const;
  /**
   * Mean of the array at each voxel that has mass, weighted with the mass. Returns how many values
   * were not finite.
   */
  vtkIdType FillMean(openvdb::GridBase& grid, vtkDataArray* array) const;

private:
  template <typename Add>
  void ForAllShares(Add add) const;

  vtkDataSet* Data;
  double VoxelSize;
  std::vector<vtkIdType> Ids;
  std::vector<double> Masses; // of these
  vtkIdType Lost = 0;
  std::string Error;
  openvdb::DoubleGrid::Ptr Mass;
};

} // namespace nephoscope

#endif
