// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties of a grid that do not depend on the field: neighbours and their distances, hidden
// points, masses, and the number of passes for rows near a pole.
#ifndef nephoscope_SmoothingPlan_h
#define nephoscope_SmoothingPlan_h

#include "DualCells.h"
#include "GridTopology.h"

#include "vtkType.h" // for vtkIdType

#include <array>
#include <string>
#include <vector>

class vtkDataSet;

namespace nephoscope
{
enum class GridCoordinates
{
  Automatic, // longitude and latitude if axis 0 is periodic and goes round in 360, and axis 1 stays
             // within +-90
  Cartesian,
  LongitudeLatitude // degrees, degrees, level
};

struct SmoothingSettings
{
  std::array<bool, 3> Periodic = { { false, false, false } };
  bool FindSeam = true;
  bool Conservative = false;
  bool Isotropic = false;
  GridCoordinates Coordinates = GridCoordinates::Automatic;
  std::string MassArrayName; // instead of volumes; empty: none
};

class SmoothingPlan
{
public:
  // Returns the problem with the grid and its remedy, or an empty string. The grid must outlive the
  // plan.
  std::string Read(vtkDataSet* grid, const SmoothingSettings& settings);

  const GridTopology& Topology() const { return this->Topology_; }

  // True if the first and the last point of a ring are neighbours in space too, as on a globe but
  // not on a map.
  bool ClosesInSpace(int axis) const { return this->ClosedInSpace[axis]; }

  // The mass of every stored point; 0 for points that repeat others, so that sums count each
  // position once.
  const std::vector<double>& Masses() const { return this->Masses_; }
  vtkIdType PointsWithoutMass() const { return this->WithoutMass; }

  bool IsHidden(vtkIdType id) const { return !this->Hidden.empty() && this->Hidden[id] != 0; }

  // (step across / step along)^2 of the row through (0, j, k), the factor on the passes along axis
  // 0; 1 unless Isotropic.
  double RowRatio(int j, int k) const
  {
    return this->RowRatios.empty()
      ? 1.0
      : this->RowRatios[j + static_cast<std::size_t>(this->Topology_.Size[1]) * k];
  }

  Vector3 Position(const GridIndex& at) const;

  // From a point (distinct indices) to its neighbour, also across the seam. Zero where there is
  // none.
  Vector3 Displacement(int axis, const GridIndex& at, int step) const;

  // Position of a point, or of the one after the last of a ring.
  Vector3 PositionBeyond(const GridIndex& at) const;

private:
  std::string ReadShape(vtkDataSet* grid);
  std::string CheckCoordinates() const;
  void ReadHidden();
  bool IsLongitudeLatitude(const SmoothingSettings& settings) const;
  void FindRings(const SmoothingSettings& settings);
  void FindPoleRows();
  std::string FindMasses(const SmoothingSettings& settings);
  std::vector<double> CurvilinearMasses() const;
  std::vector<double> RectilinearMasses() const;
  void CountMasses();
  void FindRowRatios();
  double StepLength(int axis, const GridIndex& at, int step) const;

  vtkDataSet* Grid = nullptr;
  GridTopology Topology_;
  bool IsCurvilinear = false;
  bool LongitudeLatitude = false;
  std::array<std::vector<double>, 3> Axes; // of image and rectilinear grids
  std::array<bool, 3> ClosedInSpace = { { false, false, false } };
  std::vector<double> Masses_;
  std::vector<unsigned char> Hidden; // empty: none is
  std::vector<double> RowRatios;     // empty: all 1
  vtkIdType WithoutMass = 0;
};
}

#endif
