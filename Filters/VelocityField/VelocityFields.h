// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of VTK's data objects.
#ifndef nephoscope_VelocityFields_h
#define nephoscope_VelocityFields_h

#include "VelocityField.h"
#include "vtkNephoscopeFiltersVelocityFieldModule.h" // for export macro

#include <memory>
#include <string>

class vtkDataObject;
class vtkDataSet;
class vtkPointData;

namespace nephoscope
{
// A velocity field of a dataset, which can interpolate the dataset's other arrays too.
class DataSetField : public VelocityField
{
public:
  // Every point array at the positions (cell arrays too if the velocity is on cells), with NaN, or
  // 0 where there is no NaN, outside. `hints` as left by Sample.
  virtual void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const = 0;

  // Whether the cell that Sample has found is a ghost cell, a copy of another rank's
  // (DUPLICATECELL).
  virtual bool IsInGhostCell(const CellHint& found) const = 0;
};

// Which array is the velocity: three components, on points or on cells.
struct VelocityArray
{
  std::string Name;
  bool OnCells = false;
};

// The field of a dataset or of the leaves of a composite one. Null, and a sentence in `problem`
// that names what is wrong and its remedy, if there is none. The data must outlive the field.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::unique_ptr<DataSetField> MakeVelocityField(
  vtkDataObject* data, const VelocityArray& array, std::string& problem);

// The same for a dataset, and beyond it the velocity at its nearest place (UnboundedField.h).
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::unique_ptr<VelocityField> MakeUnboundedField(
  vtkDataSet* data, const VelocityArray& array, std::string& problem);
}

#endif
