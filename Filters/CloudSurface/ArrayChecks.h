// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The requirements of both filters of this folder on their input and its arrays, and their
// messages.
#ifndef nephoscope_ArrayChecks_h
#define nephoscope_ArrayChecks_h

#include "ArrayNames.h"
#include "RequiredInput.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <string>

namespace nephoscope
{
// As HasOtherInput.
inline bool HasNoGrid(vtkAlgorithm* filter, vtkMTimeType& told, vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return HasOtherInput(filter, told, request, inputs, outputs,
    { "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid" },
    "It must be a grid with rows: an image, a rectilinear or a structured grid.");
}

inline std::string PointArrayNames(vtkDataSet* data)
{
  return "Point arrays: " + QuotedNames(data->GetPointData()) + ".";
}

// Why there is no such array, and what to do.
inline std::string NoPointArray(vtkDataSet* data, const char* name)
{
  const bool onCells = name && data->GetCellData()->HasArray(name);
  const bool onPoints = name && data->GetPointData()->HasArray(name);
  const std::string called =
    name && *name ? "'" + std::string(name) + "'" : std::string("of the active scalars");
  return "There is no point array " + called + ". " +
    (onCells && !onPoints ? "It is on cells: apply Cell Data to Point Data first. "
        : data->GetPointData()->GetNumberOfArrays() == 0 &&
          data->GetCellData()->GetNumberOfArrays() > 0
        ? "The input has only cell arrays: apply Cell Data to Point Data first. "
        : "Choose another one. ") +
    PointArrayNames(data);
}

// What keeps a point array from being used as numbers; empty if nothing does.
inline std::string ArrayFault(vtkDataSet* data, vtkAbstractArray* array)
{
  if (!vtkDataArray::SafeDownCast(array) || vtkBitArray::SafeDownCast(array))
  {
    return "The array " + QuotedName(array) + " of type " + array->GetDataTypeAsString() +
      " is not of numbers. Choose another one.";
  }
  if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    return "The array " + QuotedName(array) + " has " + std::to_string(array->GetNumberOfTuples()) +
      " values for " + std::to_string(data->GetNumberOfPoints()) + " points.";
  }
  return std::string();
}

// Index of an array in the point data; -1 if it is not there.
inline int IndexOfPointArray(vtkDataSet* data, vtkAbstractArray* array)
{
  for (int a = 0; a < data->GetPointData()->GetNumberOfArrays(); ++a)
  {
    if (data->GetPointData()->GetAbstractArray(a) == array)
    {
      return a;
    }
  }
  return -1;
}

inline std::string ValuesMissing(vtkAbstractArray* array, vtkIdType count)
{
  return std::to_string(count) + " values of the array " + QuotedName(array) +
    " are not finite numbers, or fill values (1e30 or more).";
}
}

#endif
