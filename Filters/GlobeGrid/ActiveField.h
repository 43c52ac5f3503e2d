// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_ActiveField_h
#define nephoscope_ActiveField_h

#include "FieldNames.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

namespace nephoscope
{
// Makes the array that a viewer should see first the active scalars: cloud fraction, else cloud
// water, else the first field of one component. Scalars that the input had chosen stay, unless they
// are a helper.
inline void ChooseActiveScalars(vtkDataSetAttributes* data)
{
  vtkDataArray* chosen = data->GetScalars();
  if (chosen && chosen->GetName() && KindOfField(chosen->GetName()) != FieldKind::Helper)
  {
    return;
  }
  FieldKind best = FieldKind::Helper;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      KindOfField(array->GetName()) < best)
    {
      best = KindOfField(array->GetName());
      data->SetActiveScalars(array->GetName());
    }
  }
}
}

#endif
