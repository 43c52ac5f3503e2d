// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The seam and the ends of a structured grid whose pieces are on several ranks; on one the mapper
 * finds them by itself.
 */
#ifndef nephoscope_SplatGridSeam_h
#define nephoscope_SplatGridSeam_h

#include "SplatMatrix.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

class SplatGridSeam
{
public:
  /**
   * Along one axis, 0 to 2. `extents` of the points of all ranks, as FindExtentsOfRanks makes them.
   * Collective.
   */
  SplatGridSeam(vtkDataSet* piece, const std::vector<int>& extents, int axis);

  /** Whether a point is in the last column of a closed grid, which is the first once more. */
  bool IsRepeated(vtkIdType id) const
  {
    return this->Closed && this->Column(id) == this->Whole[2 * this->Axis + 1];
  }
  /**
   * Half at the ends of a grid that is not closed, where the cell of a point lies half outside;
   * else 1.
   */
  double ShareInGrid(vtkIdType id) const;
  /** In the first column of a closed grid the edge along that axis goes across the seam. */
  void MendEdge(vtkIdType id, SplatMatrix& jacobian) const;

private:
  int IndexOf(vtkIdType id, int axis) const;
  int Column(vtkIdType id) const;
  std::size_t Row(vtkIdType id) const;
  Vector3 PlaceOf(std::size_t column, std::size_t row) const;
  void FillIn(vtkDataSet* piece);

  int Axis;
  int Across[2]; // the other axes
  bool Closed = false;
  int Whole[6] = { VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN };
  int Mine[6] = { 0, -1, 0, -1, 0, -1 };
  std::vector<double> Columns; // places: the first two columns and the last two
};

} // namespace nephoscope

#endif
