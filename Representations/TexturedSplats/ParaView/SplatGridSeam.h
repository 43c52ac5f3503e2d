// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The seam of a structured grid whose pieces are on several ranks; on one the mapper finds it by itself. */
#ifndef SplatGridSeam_h
#define SplatGridSeam_h

#include "SplatMatrix.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

class SplatGridSeam
{
public:
  /** `extents` of the points of all ranks, as findExtentsOfRanks makes them. Collective. */
  SplatGridSeam(vtkDataSet* piece, const std::vector<int>& extents);

  /** Whether a point is in the last column of a closed grid, which is the first once more. */
  bool IsRepeated(vtkIdType id) const { return this->Closed && this->Column(id) == this->Whole[1]; }
  /** In the first column of a closed grid the edge along the first axis goes across the seam. */
  void MendEdge(vtkIdType id, SplatMatrix& jacobian) const;

private:
  int Column(vtkIdType id) const;
  std::size_t Row(vtkIdType id) const;
  Vector3 PlaceOf(std::size_t column, std::size_t row) const;
  void FillIn(vtkDataSet* piece);

  bool Closed = false;
  int Whole[6] = { VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN };
  int Mine[6] = { 0, -1, 0, -1, 0, -1 };
  std::vector<double> Columns; // places: the first two columns and the last two
};

} // namespace nephoscope

#endif
