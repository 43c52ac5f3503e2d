// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ids that give the colour. VTK drops arrays of ids, and those in the role of ids, where it cuts
 * cells; ordinary numbers are interpolated.
 */
#ifndef nephoscope_IdsAsNumbers_h
#define nephoscope_IdsAsNumbers_h

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"

namespace nephoscope
{

inline void DropRolesOfIds(vtkDataSetAttributes* attributes)
{
  attributes->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  attributes->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
}

inline void MakeIdsNumbers(vtkDataSetAttributes* attributes)
{
  DropRolesOfIds(attributes);
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* ids = attributes->GetArray(i);
    if (ids && ids->GetName() && ids->GetDataType() == VTK_ID_TYPE)
    {
      vtkNew<vtkDoubleArray> numbers;
      numbers->DeepCopy(ids);
      numbers->SetName(ids->GetName());
      attributes->AddArray(numbers); // in its place
    }
  }
}

} // namespace nephoscope

#endif
