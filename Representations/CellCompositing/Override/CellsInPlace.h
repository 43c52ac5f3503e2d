// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A cell compositing mapper that draws in place of another volume mapper, with its input and settings.
#ifndef CellsInPlace_h
#define CellsInPlace_h

#include "MapperSettings.h"

#include "vtkCellCompositingMapper.h"
#include "vtkNew.h"
#include "vtkUnstructuredGridVolumeMapper.h"

namespace nephoscope
{

class CellsInPlace
{
public:
  void Render(vtkUnstructuredGridVolumeMapper* owner, vtkRenderer* renderer, vtkVolume* volume)
  {
    copyInputAndScalars(owner, this->Mapper);
    this->Mapper->SetClippingPlanes(owner->GetClippingPlanes());
    this->Mapper->Render(renderer, volume);
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Mapper->ReleaseGraphicsResources(window);
  }

  vtkCellCompositingMapper* GetMapper() { return this->Mapper; }

private:
  vtkNew<vtkCellCompositingMapper> Mapper;
};

}

#endif
