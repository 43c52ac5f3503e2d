// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingRayCastMapper.h"

#include "CellsInPlace.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCellCompositingRayCastMapper);

vtkCellCompositingRayCastMapper::vtkCellCompositingRayCastMapper()
  : Cells(new nephoscope::CellsInPlace(this))
{
}

vtkCellCompositingRayCastMapper::~vtkCellCompositingRayCastMapper() = default;

vtkCellCompositingMapper* vtkCellCompositingRayCastMapper::GetCellCompositingMapper()
{
  return this->Cells->GetMapper(this);
}

void vtkCellCompositingRayCastMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  nephoscope::VolumeOrder::Draw(this, renderer, volume);
}

void vtkCellCompositingRayCastMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cells->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkCellCompositingRayCastMapper::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  this->Cells->ReportReferences(collector);
}

void vtkCellCompositingRayCastMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Cells->GetMapper()->PrintSelf(os, indent.GetNextIndent());
}
