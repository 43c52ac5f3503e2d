// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity field of any dataset, by VTK's cell locator and cell interpolation.
#ifndef nephoscope_CellVelocity_h
#define nephoscope_CellVelocity_h

#include "HiddenCells.h"
#include "VelocityFields.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <mutex>

class vtkDataArray;
class vtkDataSet;
class vtkStaticCellLocator;

namespace nephoscope
{
// Cells of all kinds. The cell of the hint is tried first, then the locator, then every cell that is within rounding of
// the position: VTK's own test leaves gaps between neighbours. The locator is built when it is needed first.
class CellVelocity : public DataSetField
{
public:
  CellVelocity(vtkDataSet* data, vtkDataArray* velocity);
  ~CellVelocity() override;

  void Sample(const SampleBatch& batch) const override;
  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override;

private:
  struct Search;

  bool SampleOne(
    Search& search, const Vector3& position, CellHint& hint, Vector3& velocity) const;
  bool Locate(Search& search, Vector3& velocity) const;
  bool TryCell(Search& search, vtkIdType cell, double tolerance, Vector3& velocity) const;
  bool Interpolate(const Search& search, Vector3& velocity) const;
  void BuildLocator() const;

  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataArray> Velocity;
  HiddenCells Hidden;
  std::size_t LargestCell;
  double Rounding; // a length below which positions are one
  mutable std::once_flag LocatorOnce;
  vtkNew<vtkStaticCellLocator> Locator;
};
}

#endif
