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
    this->GetMapper(owner)->Render(renderer, volume);
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Mapper->ReleaseGraphicsResources(window);
  }

  vtkCellCompositingMapper* GetMapper() { return this->Mapper; }
  /** With the owner's input and settings as they are now. */
  vtkCellCompositingMapper* GetMapper(vtkUnstructuredGridVolumeMapper* owner)
  {
    copyInputAndScalars(owner, this->Mapper);
    this->Mapper->SetClippingPlanes(owner->GetClippingPlanes());
    return this->Mapper;
  }

private:
  vtkNew<vtkCellCompositingMapper> Mapper;
};

}

#endif
