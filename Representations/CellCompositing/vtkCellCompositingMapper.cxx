// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingMapper.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGridBase.h"

struct vtkCellCompositingMapper::vtkInternals
{
};

vtkStandardNewMacro(vtkCellCompositingMapper);
vtkCellCompositingMapper::vtkCellCompositingMapper()
  : Internals(new vtkInternals)
{
}
vtkCellCompositingMapper::~vtkCellCompositingMapper() = default;

void vtkCellCompositingMapper::SetInputData(vtkDataSet* data)
{
  this->SetInputDataInternal(0, data);
}
void vtkCellCompositingMapper::SetInputData(vtkUnstructuredGridBase* data)
{
  this->SetInputDataInternal(0, data);
}
int vtkCellCompositingMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}
vtkIdType vtkCellCompositingMapper::GetNumberOfTetrahedra() { return 0; }
vtkIdType vtkCellCompositingMapper::GetNumberOfDrawnTetrahedra() { return 0; }
vtkIdType vtkCellCompositingMapper::GetNumberOfVisibilityCycles() { return 0; }
bool vtkCellCompositingMapper::CopyFloatImage(vtkImageData*) { return false; }
void vtkCellCompositingMapper::Render(vtkRenderer*, vtkVolume*) {}
void vtkCellCompositingMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
}
void vtkCellCompositingMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
