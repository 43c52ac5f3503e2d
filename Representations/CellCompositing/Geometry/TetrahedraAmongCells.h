// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a mesh is drawn as tetrahedra: because some of its cells have no trilinear field, or by
 * default because most of its cells are tetrahedra or pieces of some.
 */
#ifndef nephoscope_TetrahedraAmongCells_h
#define nephoscope_TetrahedraAmongCells_h

#include "HexahedronForm.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArrayRange.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstdint>
#include <numeric>
#include <set>

namespace nephoscope
{

/** A 3-D cell of another kind than hexahedra, voxels, wedges, pyramids and tetrahedra. */
inline bool IsOtherSolid(int cellType)
{
  if (HexahedronFormOf(cellType).Tetrahedra > 0)
  {
    return false;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(cellType));
  return !cell || cell->GetCellDimension() == 3;
}

/** The types of the cells of an unstructured mesh; none for other datasets. */
inline std::set<int> CellTypesOf(vtkDataSet* data)
{
  auto* unstructured = vtkUnstructuredGrid::SafeDownCast(data);
  vtkUnsignedCharArray* types = unstructured ? unstructured->GetCellTypesArray() : nullptr;
  std::set<int> result;
  for (vtkIdType i = 0; types && i < types->GetNumberOfTuples(); ++i)
  {
    result.insert(types->GetValue(i));
  }
  return result;
}

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
  return std::accumulate(all.begin(), all.end(), std::int64_t(0), [](std::int64_t sum, int type) {
    const bool isSolid = HexahedronFormOf(type).Tetrahedra > 0;
    return sum + (type == VTK_TETRA ? 1 : isSolid ? -1 : 0);
  });
}

} // namespace nephoscope

#endif
