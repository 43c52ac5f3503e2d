// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumetricCells.h"

#include "DataBlocks.h"
#include "TetrahedronSource.h"

#include "vtkCellData.h"
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

void copyPoints(vtkDataSet* data, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  double x[3];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, x);
    points->SetPoint(i, x);
  }
  grid->SetPoints(points);
}
void copyCellData(vtkDataSet* data, vtkIdList* parents, vtkUnstructuredGrid* grid)
{
  vtkCellData* out = grid->GetCellData();
  out->CopyGlobalIdsOff(); // several tetrahedra have one parent
  out->CopyAllocate(data->GetCellData(), parents->GetNumberOfIds());
  for (vtkIdType i = 0; i < parents->GetNumberOfIds(); ++i)
  {
    out->CopyData(data->GetCellData(), parents->GetId(i), i);
  }
  out->RemoveArray(vtkDataSetAttributes::GhostArrayName());
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

vtkSmartPointer<vtkUnstructuredGrid> tetrahedralize(vtkDataSet* data)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copyPoints(data, grid);
  grid->GetPointData()->ShallowCopy(data->GetPointData());
  grid->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  grid->GetFieldData()->ShallowCopy(data->GetFieldData());

  const vtkIdType numberOfCells = data->GetNumberOfCells();
  TetrahedronSource source(data);
  vtkNew<vtkIdList> parents;
  parents->Allocate(6 * numberOfCells);
  grid->Allocate(6 * numberOfCells);
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    if (source.IsHidden(cell))
    {
      continue;
    }
    const bool polygon = source.EmitTriangles([&](const std::array<vtkIdType, 3>& t) {
      grid->InsertNextCell(VTK_TRIANGLE, 3, t.data());
      parents->InsertNextId(cell);
    });
    if (!polygon)
    {
      source.EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& t) {
        grid->InsertNextCell(VTK_TETRA, 4, t.data());
        parents->InsertNextId(cell);
      });
    }
  }
  copyCellData(data, parents, grid);
  return grid;
}

} // namespace nephoscope
