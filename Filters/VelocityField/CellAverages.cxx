// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellAverages.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace nephoscope
{
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
