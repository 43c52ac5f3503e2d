// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VelocityFields.h"

#include "CellVelocity.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

namespace nephoscope
{
std::unique_ptr<DataSetField> MakeVelocityField(
  vtkDataObject* data, const VelocityArray& array, std::string& problem)
{
  vtkDataSet* set = vtkDataSet::SafeDownCast(data);
  vtkDataArray* velocity = set ? set->GetPointData()->GetArray(array.Name.c_str()) : nullptr;
  if (!velocity || velocity->GetNumberOfComponents() != 3)
  {
    problem = "There is no point array '" + array.Name + "' of three components.";
    return nullptr;
  }
  return std::make_unique<CellVelocity>(set, velocity);
}
}
