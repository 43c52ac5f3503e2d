// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayBlend.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"

namespace nephoscope
{
namespace
{
bool IsFloating(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

bool Fit(vtkDataArray* first, vtkDataArray* second)
{
  return first && first->GetNumberOfTuples() == second->GetNumberOfTuples() &&
    first->GetNumberOfComponents() == second->GetNumberOfComponents();
}

void Blend(vtkDataArray* first, double weight, vtkDataArray* second)
{
  const auto before = vtk::DataArrayValueRange(first);
  auto after = vtk::DataArrayValueRange(second);
  for (vtkIdType i = 0; i < after.size(); ++i)
  {
    const double a = before[i];
    const double b = after[i];
    after[i] = (1.0 - weight) * a + weight * b;
  }
}
}

void BlendArrays(vtkDataSetAttributes* first, double weight, vtkDataSetAttributes* second)
{
  for (int i = 0; i < second->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = second->GetArray(i);
    vtkDataArray* before = array && array->GetName() ? first->GetArray(array->GetName()) : nullptr;
    if (!array || !Fit(before, array))
    {
      continue;
    }
    if (IsFloating(array))
    {
      Blend(before, weight, array);
    }
    else if (weight < 0.5)
    {
      array->DeepCopy(before);
    }
  }
}
}
