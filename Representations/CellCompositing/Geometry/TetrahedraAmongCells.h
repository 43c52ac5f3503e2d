// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Whether a mesh is drawn as tetrahedra by default, since most of its cells are, or are pieces of
 * some. */
#ifndef nephoscope_TetrahedraAmongCells_h
#define nephoscope_TetrahedraAmongCells_h

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArrayRange.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>

namespace nephoscope
{

/**
 * The number of tetrahedra minus that of other cells: positive if most are tetrahedra. Parts of a
 * mesh add up. The pieces of vtkContourCellSplitter count as tetrahedra: their field is linear, and
 * their faces meet those of cells that were not split along the diagonals of these.
 */
inline std::int64_t TetrahedraBeyondOthers(vtkDataSet* data)
{
  auto* unstructured = vtkUnstructuredGrid::SafeDownCast(data);
  vtkUnsignedCharArray* types = unstructured ? unstructured->GetCellTypesArray() : nullptr;
  if (!types)
  {
    return 0;
  }
  if (data->GetCellData()->HasArray("ContourIndex"))
  {
    return data->GetNumberOfCells();
  }
  const auto all = vtk::DataArrayValueRange<1>(types);
  return 2 * static_cast<std::int64_t>(std::count(all.begin(), all.end(), VTK_TETRA)) - all.size();
}

} // namespace nephoscope

#endif
