// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumetricCells.h"

#include "DataBlocks.h"
#include "TetrahedraAmongCells.h"
#include "TetrahedronSource.h"

#include "vtkCellData.h"
#include "vtkExtractCells.h"
#include "vtkGeometryFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyhedronToTetrahedra.h"
#include "vtkRectilinearGrid.h"

#include <numeric>

namespace nephoscope
{
namespace
{
bool MayHoldVolumes(vtkDataSet* data)
{
  return data && data->GetNumberOfCells() > 0 && !vtkPolyData::SafeDownCast(data);
}

bool IsPointOrLine(int type)
{
  return type == VTK_VERTEX || type == VTK_LINE;
}

// Whether a cell has the points that it has in a grid whose rows have so many points.
bool IsCellOfGrid(vtkIdType cell, int type, const vtkIdType* ids, vtkIdType row)
{
  if (IsPointOrLine(type))
  {
    return ids[0] == cell && (type == VTK_VERTEX || ids[1] == cell + 1);
  }
  const vtkIdType first = cell + cell / (row - 1), above = first + row;
  const int right = type == VTK_PIXEL ? 3 : 2;
  return ids[0] == first && ids[1] == first + 1 && ids[right] == above + 1 &&
    ids[5 - right] == above;
}

/**
 * Whether the cells are all those of a grid that is one point thick: what a rank gets of a grid
 * that has fewer layers of cells than there are ranks.
 */
bool IsLayerOfPoints(vtkDataSet* data)
{
  const int type = data->GetCellType(0);
  const bool isFlat = type == VTK_PIXEL || type == VTK_QUAD;
  if (!isFlat && !IsPointOrLine(type))
  {
    return false;
  }
  vtkNew<vtkIdList> points;
  data->GetCellPoints(0, points);
  const vtkIdType row = isFlat ? points->GetId(type == VTK_PIXEL ? 2 : 3) : 0;
  const vtkIdType rows = row > 1 ? data->GetNumberOfPoints() / row : 0;
  bool isLayer = !isFlat || (rows > 1 && data->GetNumberOfCells() == (row - 1) * (rows - 1));
  for (vtkIdType cell = 0; isLayer && cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, points);
    isLayer =
      data->GetCellType(cell) == type && IsCellOfGrid(cell, type, points->GetPointer(0), row);
  }
  return isLayer;
}

void RemoveGhosts(vtkDataSet* data)
{
  data->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  data->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}

// The division of the cells of a grid, in the order of their numbers.
void StoreDivisions(const ChessboardGrid& grid, vtkIdList* cells, vtkUnstructuredGrid* extracted)
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

vtkSmartPointer<vtkUnstructuredGrid> ExtractedCells(vtkDataSet* data, vtkIdList* cells)
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

bool IsAxisAligned(vtkDataSet* data)
{
  return vtkRectilinearGrid::SafeDownCast(data) || vtkImageData::SafeDownCast(data);
}

vtkSmartPointer<vtkDataSet> VolumetricPart(vtkDataObject* input, bool isPart)
{
  return AppendedBlocks(input, [isPart](vtkDataSet* data) {
    return MayHoldVolumes(data) && !(isPart && IsLayerOfPoints(data));
  });
}

vtkSmartPointer<vtkDataSet> WithConvexCells(vtkDataSet* data)
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

vtkSmartPointer<vtkUnstructuredGrid> VisibleCells(vtkDataSet* data)
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
    visible = ExtractedCells(data, cells);
  }
  const ChessboardGrid grid = FindChessboardGrid(data);
  if (!grid.IsEmpty())
  {
    StoreDivisions(grid, cells, visible);
  }
  RemoveGhosts(visible);
  return visible;
}

WholeCells FormOfWholeCells(vtkUnstructuredGrid* cells)
{
  TetrahedronSource source(cells);
  bool warped = false;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const int type = cells->GetCellType(cell);
    if (IsOtherSolid(type))
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

std::vector<vtkIdType> PointsOfSurface(vtkUnstructuredGrid* cells)
{
  if (cells->GetNumberOfCells() == 0)
  {
    return {};
  }
  constexpr const char* pointNumbers = "NephoscopePointNumbers";
  vtkNew<vtkUnstructuredGrid> bare;
  bare->CopyStructure(cells);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(pointNumbers);
  numbers->SetNumberOfValues(cells->GetNumberOfPoints());
  std::iota(numbers->Begin(), numbers->End(), 0);
  bare->GetPointData()->AddArray(numbers);
  vtkNew<vtkGeometryFilter> surface;
  surface->SetInputData(bare);
  surface->Update();
  auto* onSurface =
    vtkIdTypeArray::SafeDownCast(surface->GetOutput()->GetPointData()->GetArray(pointNumbers));
  return onSurface ? std::vector<vtkIdType>(onSurface->Begin(), onSurface->End())
                   : std::vector<vtkIdType>();
}

vtkSmartPointer<vtkDataSet> WithoutGhosts(vtkDataSet* cells)
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(cells->NewInstance());
  copy->ShallowCopy(cells);
  RemoveGhosts(copy);
  return copy;
}

} // namespace nephoscope
