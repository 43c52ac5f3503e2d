// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingProjectedTetrahedraMapper.h"

#include "CellsInPlace.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"

vtkStandardNewMacro(vtkCellCompositingProjectedTetrahedraMapper);

vtkCellCompositingProjectedTetrahedraMapper::vtkCellCompositingProjectedTetrahedraMapper()
  : Cells(new nephoscope::CellsInPlace(this))
{
}

vtkCellCompositingProjectedTetrahedraMapper::~vtkCellCompositingProjectedTetrahedraMapper() =
  default;

vtkCellCompositingMapper* vtkCellCompositingProjectedTetrahedraMapper::GetCellCompositingMapper()
{
  return this->Cells->GetMapper(this);
}

bool vtkCellCompositingProjectedTetrahedraMapper::IsSupported(vtkRenderWindow* window)
{
  return vtkOpenGLRenderWindow::SafeDownCast(window) != nullptr;
}

void vtkCellCompositingProjectedTetrahedraMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  nephoscope::VolumeOrder::Draw(this, renderer, volume);
}

void vtkCellCompositingProjectedTetrahedraMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cells->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkCellCompositingProjectedTetrahedraMapper::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  this->Cells->ReportReferences(collector);
}

void vtkCellCompositingProjectedTetrahedraMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Cells->GetMapper()->PrintSelf(os, indent.GetNextIndent());
}
