// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The point array a filter works on. A host that creates a filter before its input has been
// computed has no array names yet and passes an empty name. An empty name therefore means that
// nothing has been chosen, and the input's default is used.
#ifndef nephoscope_ChosenPointArray_h
#define nephoscope_ChosenPointArray_h

#include "DataSets.h"
#include "FieldNames.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nephoscope
{
inline bool IsNoArrayChosen(vtkAlgorithm* filter)
{
  const char* name = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  return name && !*name;
}

inline bool IsField(vtkDataArray* array)
{
  return array && array->GetName() && array->GetNumberOfComponents() == 1 &&
    KindOfField(array->GetName()) != FieldKind::Helper;
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

// Whether a block has the array that the filter works on. One that has it at its cells counts,
// because that deserves a message of its own.
inline bool HasChosenPointArray(vtkAlgorithm* filter, vtkDataSet* block)
{
  if (IsNoArrayChosen(filter))
  {
    return DefaultPointArray(block->GetPointData()) != nullptr;
  }
  vtkInformation* wanted = filter->GetInputArrayInformation(0);
  const char* name = wanted->Get(vtkDataObject::FIELD_NAME());
  return name ? block->GetPointData()->HasArray(name) || block->GetCellData()->HasArray(name)
              : block->GetPointData()->GetAbstractAttribute(
                  wanted->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE())) != nullptr;
}

// The range of the default point arrays of a dataset or of all in a group, without fill values
// (1e30 or more); the first one above the last if there is none.
inline std::array<double, 2> RangeOfDefaultArrays(vtkDataObject* data)
{
  std::array<double, 2> range = { std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() };
  const auto add = [&](vtkDataObject* leaf) {
    auto* part = vtkDataSet::SafeDownCast(leaf);
    vtkDataArray* array = part ? DefaultPointArray(part->GetPointData()) : nullptr;
    for (vtkIdType id = 0; array && id < array->GetNumberOfTuples(); ++id)
    {
      const double value = array->GetComponent(id, 0);
      if (std::abs(value) < 1e30)
      {
        range = { std::min(range[0], value), std::max(range[1], value) };
      }
    }
  };
  ForEachLeaf(data, add);
  return range;
}

// A contour value where neither array nor value has been chosen: the middle of the range.
inline double DefaultContourValue(const std::array<double, 2>& range)
{
  return range[0] <= range[1] ? 0.5 * (range[0] + range[1]) : 0.0;
}
}

#endif
