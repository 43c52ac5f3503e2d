// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The point array a filter works on. A host that makes a filter before its input has been computed knows no arrays yet and hands an
// empty name down: then nothing has been chosen, and the input's own default is taken.
#ifndef nephoscope_ChosenPointArray_h
#define nephoscope_ChosenPointArray_h

#include "FieldNames.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

namespace nephoscope
{
inline bool IsNoArrayChosen(vtkAlgorithm* filter)
{
  const char* name = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  return name && !*name;
}

inline bool IsField(vtkDataArray* array)
{
  return array && array->GetName() && array->GetNumberOfComponents() == 1 && KindOfField(array->GetName()) != FieldKind::Helper;
}

// The active scalars, else the first array of one component that is a field; null if there is none.
inline vtkDataArray* DefaultPointArray(vtkPointData* data)
{
  if (IsField(data->GetScalars()))
  {
    return data->GetScalars();
  }
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    if (IsField(data->GetArray(a)))
    {
      return data->GetArray(a);
    }
  }
  return nullptr;
}

// A contour value where neither array nor value has been chosen.
inline double MiddleOfRange(vtkDataArray* array)
{
  double range[2];
  array->GetFiniteRange(range, 0);
  return 0.5 * (range[0] + range[1]);
}
}

#endif
