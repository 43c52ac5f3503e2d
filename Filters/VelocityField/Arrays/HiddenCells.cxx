// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HiddenCells.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// Null if no flag of the mask is set.
const unsigned char* Ghosts(vtkDataSetAttributes* attributes, vtkIdType count, unsigned char mask)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!array || array->GetNumberOfTuples() < count)
  {
    return nullptr;
  }
  const unsigned char* flags = array->GetPointer(0);
  const bool any =
    std::any_of(flags, flags + count, [mask](unsigned char flag) { return (flag & mask) != 0; });
  return any ? flags : nullptr;
}
}

HiddenCells::HiddenCells(vtkDataSet* data, unsigned char flags)
{
  const vtkIdType cells = data->GetNumberOfCells();
  const vtkIdType points = data->GetNumberOfPoints();
  const unsigned char* ofCells = Ghosts(data->GetCellData(), cells, flags);
  const unsigned char* ofPoints =
    Ghosts(data->GetPointData(), points, vtkDataSetAttributes::HIDDENPOINT);
  if (ofCells || ofPoints)
  {
    this->Flags.assign(static_cast<std::size_t>(cells), 0);
  }
  for (vtkIdType cell = 0; ofCells && cell < cells; ++cell)
  {
    this->Flags[static_cast<std::size_t>(cell)] = (ofCells[cell] & flags) != 0;
  }
  if (!ofPoints)
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  if (vtkUnstructuredGrid::SafeDownCast(
        data)) // the cells of its points would have to be looked for first
  {
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      data->GetCellPoints(cell, ids);
      const bool hidden = std::any_of(ids->begin(), ids->end(), [ofPoints](vtkIdType point) {
        return (ofPoints[point] & vtkDataSetAttributes::HIDDENPOINT) != 0;
      });
      this->Flags[static_cast<std::size_t>(cell)] |= hidden;
    }
    return;
  }
  for (vtkIdType point = 0; point < points; ++point)
  {
    if (ofPoints[point] & vtkDataSetAttributes::HIDDENPOINT)
    {
      data->GetPointCells(point, ids);
      for (const vtkIdType cell : *ids)
      {
        this->Flags[static_cast<std::size_t>(cell)] = 1;
      }
    }
  }
}
}
