// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity field of any dataset, cell by cell.
#ifndef nephoscope_CellVelocity_h
#define nephoscope_CellVelocity_h

#include "CellTree.h"
#include "HiddenCells.h"
#include "VelocityFields.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <mutex>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{
// Cells of all kinds: tetrahedra, hexahedra and voxels by their own formulas, others by VTK's. The
// cell of the hint is tried first, then those whose box holds the position; then, because VTK's own
// test leaves gaps between neighbours, those once more that are within rounding of it. The boxes
// are made when they are needed first.
class CellVelocity : public DataSetField
{
public:
  CellVelocity(vtkDataSet* data, vtkDataArray* velocity);
  ~CellVelocity() override;

  void Sample(const SampleBatch& batch) const override;
  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override;
  bool IsInGhostCell(const CellHint& found) const override;

private:
  struct Search;

  bool SampleOne(Search& search, const Vector3& position, CellHint& hint, Vector3& velocity) const;
  bool TryCell(Search& search, vtkIdType cell, bool nearToo, Vector3& velocity) const;
  bool WeightsByFormula(Search& search, int type) const;
  bool WeightsByCell(Search& search, vtkIdType cell, bool nearToo) const;
  bool Interpolate(const Search& search, Vector3& velocity) const;
  const CellTree& Tree() const;

  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataArray> Velocity;
  HiddenCells Hidden;
  std::size_t LargestCell;
  double Rounding; // a length below which positions are one
  mutable std::once_flag TreeOnce;
  mutable CellTree LazyTree;
};
}

#endif
