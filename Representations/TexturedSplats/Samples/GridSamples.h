// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Shapes of the samples of structured grids. */
#ifndef nephoscope_GridSamples_h
#define nephoscope_GridSamples_h

#include "SplatMatrix.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * Positions and edges of the points, or of the cells, of an image, a rectilinear or a structured
 * grid.
 */
class GridSamples
{
public:
  /** `Dimensions` are all 0 if the data is not such a grid. */
  GridSamples(vtkDataSet* data, bool onCells);

  bool IsGrid() const { return this->Dimensions[0] > 0; }
  bool IsUniform() const { return this->Uniform; }
  /** Dimensions of the samples; all 0 if this is not a grid. */
  const int* GetDimensions() const { return this->Dimensions; }
  vtkIdType Size() const
  {
    return vtkIdType(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
  Vector3 Position(vtkIdType id) const;
  /** Along an axis, 0 to 2. */
  int Index(vtkIdType id, int axis) const
  {
    int index[3];
    this->IndexOf(id, index);
    return index[axis];
  }
  /**
   * Whether the point is in the last column of a grid that comes back to where it began along one
   * of its axes (SplatSeam.h).
   */
  bool IsRepeated(vtkIdType id) const;
  /**
   * Where the grid is one sample thick, it is as thick as its other edges are long, in the
   * geometric mean; a single sample has the edge 1. Needles are wider than their cells. Cells of
   * curved grids have the covariance of the cell (CellMoments.h).
   */
  SplatMatrix Jacobian(vtkIdType id) const;
  /** That of a column of the grid, which is longer or shorter than this one. */
  Vector3 Direction(vtkIdType id, int axis) const;

  /** Cells that do not count, one flag each; none if empty. */
  void SetHiddenCells(std::vector<unsigned char> hidden) { this->Hidden = std::move(hidden); }
  /**
   * The part of a point's cell that lies within the grid: half for each axis at one of whose ends
   * the point is. 1 for cells.
   */
  double ShareInGrid(vtkIdType id) const;
  /** The part of that where cells are not hidden. */
  double ShareInShown(vtkIdType id) const;
  /**
   * By how much the cell of a sample is less than its shape: where cells meet at an axis they are
   * needles, and shapes are wider (SplatNeedles.h).
   */
  double ShareInShape(vtkIdType id) const;

private:
  bool FindColumn(const int index[3], int axis, Vector3& column) const;
  bool FindCell(const int index[3], Vector3 (&corners)[8]) const;
  void FitToCell(const Vector3 (&corners)[8], SplatMatrix& columns, double& share) const;
  SplatMatrix WideColumns(const int index[3], double& share) const;
  struct LengthsOfColumn;
  LengthsOfColumn LengthsBeside(const int index[3], int axis, int along, double own) const;
  double WidthBeside(
    const int index[3], std::size_t axis, SplatMatrix& columns, double& share) const;
  vtkIdType CellAround(const int index[3], int octant, SplatMatrix& steps) const;
  vtkIdType CornerOf(const int index[3], int corner) const;
  Vector3 At(const int index[3]) const;
  Vector3 EdgeOfCell(const int index[3], int axis) const;
  bool ComesBack(int axis) const;
  void IndexOf(vtkIdType id, int index[3]) const;

  vtkDataSet* Data;
  bool OnCells;
  bool Uniform = false;
  bool Curved = false;
  bool Closed[3] = { false, false, false }; // along an axis
  int Dimensions[3] = { 0, 0, 0 };          // of the samples
  int PointDimensions[3] = { 0, 0, 0 };
  std::vector<unsigned char> Hidden; // cells
};

} // namespace nephoscope

#endif
