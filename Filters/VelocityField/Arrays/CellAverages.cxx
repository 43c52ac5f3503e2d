// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellAverages.h"

#include "HiddenCells.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <vector>

namespace nephoscope
{
namespace
{
// Averages once more, without hidden cells, at the points that touch one.
void LeaveOutHiddenCells(vtkDataSet* data, vtkPointData* averages)
{
  const HiddenCells hidden(data);
  vtkNew<vtkIdList> around;
  vtkNew<vtkIdList> visible;
  std::vector<double> weights;
  for (vtkIdType point = 0; hidden.Any() && point < data->GetNumberOfPoints(); ++point)
  {
    data->GetPointCells(point, around);
    visible->Reset();
    for (const vtkIdType cell : *around)
    {
      if (!hidden[cell])
      {
        visible->InsertNextId(cell);
      }
    }
    const vtkIdType count = visible->GetNumberOfIds();
    if (count == 0 || count == around->GetNumberOfIds())
    {
      continue;
    }
    weights.assign(static_cast<std::size_t>(count), 1.0 / static_cast<double>(count));
    for (int a = 0; a < averages->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = averages->GetAbstractArray(a);
      vtkAbstractArray* ofCells =
        array->GetName() ? data->GetCellData()->GetAbstractArray(array->GetName()) : nullptr;
      if (ofCells)
      {
        array->InterpolateTuple(point, visible, ofCells, weights.data());
      }
    }
  }
}
}

vtkSmartPointer<vtkDataSet> WithCellArraysOnPoints(vtkDataSet* data)
{
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  auto input = vtk::TakeSmartPointer(data->NewInstance());
  input->CopyStructure(data);
  input->GetCellData()->ShallowCopy(data->GetCellData());
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputData(input);
  average->PassCellDataOff();
  average->Update();
  auto result = vtk::TakeSmartPointer(data->NewInstance());
  result->CopyStructure(data);
  vtkPointData* points = result->GetPointData();
  points->ShallowCopy(vtkDataSet::SafeDownCast(average->GetOutputDataObject(0))->GetPointData());
  points->RemoveArray(ghosts); // an average of flags
  LeaveOutHiddenCells(data, points);
  vtkPointData* given = data->GetPointData();
  for (int a = 0; a < given->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = given->GetAbstractArray(a);
    if (!array->GetName() || !points->HasArray(array->GetName()))
    {
      points->AddArray(array);
    }
  }
  if (vtkAbstractArray* flags = data->GetCellData()->GetAbstractArray(ghosts))
  {
    result->GetCellData()->AddArray(flags);
  }
  return result;
}
}
