// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity field of any dataset, by VTK's cell locator and cell interpolation.
#ifndef nephoscope_CellVelocity_h
#define nephoscope_CellVelocity_h

#include "VelocityFields.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkDataSet;
class vtkGenericCell;
class vtkStaticCellLocator;

namespace nephoscope
{
class CellVelocity : public DataSetField
{
public:
  CellVelocity(vtkDataSet* data, vtkDataArray* velocity);
  ~CellVelocity() override;

  void Sample(const SampleBatch& batch) const override;
  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override;

private:
  bool Find(const Vector3& position, CellHint& hint, vtkGenericCell* cell, double* weights) const;

  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataArray> Velocity;
  vtkNew<vtkStaticCellLocator> Locator;
};
}

#endif
