// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlankedCells.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
// The flags of cells or points; null if none is set.
const unsigned char* FlagsOf(vtkDataSetAttributes* attributes, vtkIdType count, unsigned char flag)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!array || array->GetNumberOfTuples() < count)
  {
    return nullptr;
  }
  const unsigned char* flags = array->GetPointer(0);
  const bool any =
    std::any_of(flags, flags + count, [flag](unsigned char value) { return (value & flag) != 0; });
  return any ? flags : nullptr;
}

double SizeOf(vtkDataSet* data, vtkIdType cell)
{
  double bounds[6], lengths[3];
  data->GetCellBounds(cell, bounds);
  vtkBoundingBox(bounds).GetLengths(lengths);
  return std::cbrt(lengths[0] * lengths[1] * lengths[2]);
}

double Smaller(double a, double b)
{
  return a > 0.0 && (b == 0.0 || a < b) ? a : b;
}

double SmallestBlankedCell(vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfCells();
  const unsigned char* cells =
    FlagsOf(data->GetCellData(), count, vtkDataSetAttributes::HIDDENCELL);
  const unsigned char* points =
    FlagsOf(data->GetPointData(), data->GetNumberOfPoints(), vtkDataSetAttributes::HIDDENPOINT);
  double smallest = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; (cells || points) && cell < count; ++cell)
  {
    bool blanked = cells && (cells[cell] & vtkDataSetAttributes::HIDDENCELL) != 0;
    if (points && !blanked)
    {
      data->GetCellPoints(cell, corners);
      blanked = std::any_of(corners->begin(), corners->end(),
        [points](vtkIdType p) { return (points[p] & vtkDataSetAttributes::HIDDENPOINT) != 0; });
    }
    smallest = blanked ? Smaller(SizeOf(data, cell), smallest) : smallest;
  }
  return smallest;
}
}

double SmallestBlankedCell(const std::vector<vtkDataSet*>& sets)
{
  double smallest = 0.0;
  for (vtkDataSet* data : sets)
  {
    smallest = Smaller(SmallestBlankedCell(data), smallest);
  }
  return smallest;
}
}
