// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumetricCells.h"

#include "DataBlocks.h"
#include "HexahedronForm.h"
#include "TetrahedronSource.h"

#include "vtkCellData.h"
#include "vtkExtractCells.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyhedronToTetrahedra.h"
#include "vtkRectilinearGrid.h"

namespace nephoscope
{
namespace
{
bool mayHoldVolumes(vtkDataSet* data)
{
  return data && data->GetNumberOfCells() > 0 && !vtkPolyData::SafeDownCast(data);
}

void removeGhosts(vtkDataSet* data)
{
  data->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  data->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}

// The division of the cells of a grid, in the order of their numbers.
void storeDivisions(const ChessboardGrid& grid, vtkIdList* cells, vtkUnstructuredGrid* extracted)
{
  vtkNew<vtkUnsignedCharArray> divisions;
  divisions->SetName(divisionName);
  divisions->SetNumberOfValues(cells->GetNumberOfIds());
  for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
  {
    const std::array<int, 3> index = grid.CellIndex(cells->GetId(i));
    const int odd = (index[0] + index[1] + index[2] + grid.OddOffset) & 1;
    divisions->SetValue(i, static_cast<unsigned char>(1 + odd));
  }
  extracted->GetCellData()->AddArray(divisions);
}

vtkSmartPointer<vtkUnstructuredGrid> extractedCells(vtkDataSet* data, vtkIdList* cells)
{
  constexpr const char* cellNumbers = "vtkOriginalCellIds";
  const bool hasNumbers = data->GetCellData()->HasArray(cellNumbers);
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(data);
  extract->SetCellList(cells);
  extract->Update();
  vtkSmartPointer<vtkUnstructuredGrid> extracted = extract->GetOutput();
  if (!hasNumbers)
  {
    extracted->GetCellData()->RemoveArray(cellNumbers);
  }
  extracted->GetFieldData()->ShallowCopy(data->GetFieldData());
  return extracted;
}
} // namespace

bool isAxisAligned(vtkDataSet* data)
{
  return vtkRectilinearGrid::SafeDownCast(data) || vtkImageData::SafeDownCast(data);
}

vtkSmartPointer<vtkDataSet> volumetricPart(vtkDataObject* input)
{
  return appendedBlocks(input, mayHoldVolumes);
}

vtkSmartPointer<vtkDataSet> withConvexCells(vtkDataSet* data)
{
  if (!vtkUnstructuredGrid::SafeDownCast(data))
  {
    return data;
  }
  vtkNew<vtkPolyhedronToTetrahedra> divider; // passes what has no polyhedra
  divider->SetInputDataObject(data);
  divider->Update();
  return divider->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> visibleCells(vtkDataSet* data)
{
  TetrahedronSource source(data);
  vtkNew<vtkIdList> cells;
  cells->Allocate(data->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!source.IsHidden(cell))
    {
      cells->InsertNextId(cell);
    }
  }
  auto visible = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (vtkUnstructuredGrid::SafeDownCast(data) &&
    cells->GetNumberOfIds() == data->GetNumberOfCells())
  {
    visible->ShallowCopy(data);
  }
  else
  {
    visible = extractedCells(data, cells);
  }
  const ChessboardGrid grid = findChessboardGrid(data);
  if (!grid.IsEmpty())
  {
    storeDivisions(grid, cells, visible);
  }
  removeGhosts(visible);
  return visible;
}

WholeCells formOfWholeCells(vtkUnstructuredGrid* cells)
{
  TetrahedronSource source(cells);
  bool warped = false;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const int type = cells->GetCellType(cell);
    if (hexahedronForm(type).Tetrahedra == 0 && type != VTK_EMPTY_CELL)
    {
      return WholeCells::Tetrahedra;
    }
    if (!warped && !source.IsHidden(cell))
    {
      source.EmitTetrahedra(cell, [](const std::array<vtkIdType, 4>&) {});
      warped = source.IsWarped();
    }
  }
  return warped ? WholeCells::Trilinear : WholeCells::Either;
}

vtkSmartPointer<vtkDataSet> withoutGhosts(vtkDataSet* cells)
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(cells->NewInstance());
  copy->ShallowCopy(cells);
  removeGhosts(copy);
  return copy;
}

} // namespace nephoscope
