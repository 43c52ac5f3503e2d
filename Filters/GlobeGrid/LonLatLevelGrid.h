// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One view of a rectilinear, image or structured grid of longitudes, latitudes and levels:
// coordinates by index, and the attributes that live there. With cell centres, the cells take the
// part of the points.
#ifndef nephoscope_LonLatLevelGrid_h
#define nephoscope_LonLatLevelGrid_h

#include "vtkType.h" // for vtkIdType

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkPoints;

namespace nephoscope
{
class LonLatLevelGrid
{
public:
  // Reads and checks the axes. Returns the problem and its remedy, or an empty string.
  std::string Read(vtkDataSet* grid, bool cellCentres);

  const std::array<int, 3>& Dimensions() const { return this->Size; }
  const std::array<int, 3>& FirstIndex() const { return this->First; }
  vtkIdType Id(const std::array<int, 3>& index) const
  {
    return index[0] +
      static_cast<vtkIdType>(this->Size[0]) *
      (index[1] + static_cast<vtkIdType>(this->Size[1]) * index[2]);
  }

  // Degrees east, degrees north (within +-90), level, as the input has them.
  std::array<double, 3> Coordinates(const std::array<int, 3>& index) const;

  // The longitude without a jump between neighbours.
  double UnwrappedLongitude(const std::array<int, 3>& index) const;

  // The unwrapped longitudes of the middle row, which decides on order and coverage.
  std::vector<double> MiddleRow() const;

  bool IsPoleRow(int j, int k) const;

  // False if the row is not at one latitude (on the lowest level).
  bool RowLatitude(int j, double& latitude) const;

  // True if longitude and latitude are given point by point.
  bool IsCurvilinear() const { return this->Points != nullptr; }

  // The data on the points of this view; and, without cell centres, those on the cells (else null).
  vtkDataSetAttributes* PointAttributes() const { return this->OnPoints; }
  vtkDataSetAttributes* CellAttributes() const { return this->OnCells; }

  // The named array, if it has one component; else null.
  vtkDataArray* Array(const std::string& name) const;
  std::string ArrayNames() const;

private:
  void ReadAxes(vtkDataSet* grid);
  void TakeCellCentres();
  std::string CheckAxes();
  std::string CheckPoints();
  void UnwrapRows();
  std::array<double, 3> Corner(const std::array<int, 3>& index) const;

  std::array<int, 3> Size = { 0, 0, 0 };
  std::array<int, 3> First = { 0, 0, 0 };
  std::array<int, 3> CornerSize = { 0, 0, 0 };
  std::array<std::vector<double>, 3> Axes; // empty if the grid is curvilinear
  std::vector<double> ReferenceLongitudes; // of the lowest level, if the grid is curvilinear
  vtkPoints* Points = nullptr;             // if the grid is curvilinear
  bool AtCellCentres = false;
  vtkDataSetAttributes* OnPoints = nullptr;
  vtkDataSetAttributes* OnCells = nullptr;
};

// True if the named arrays, or for want of them all arrays, are on cells and not on points.
bool DataAreOnCells(vtkDataSet* grid, const std::vector<std::string>& names);
}

#endif
