// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A cell compositing mapper that draws in place of another volume mapper, with its input and
// settings.
#ifndef nephoscope_CellsInPlace_h
#define nephoscope_CellsInPlace_h

#include "CellsInOrder.h"
#include "MapperSettings.h"

#include "vtkCellCompositingMapper.h"
#include "vtkGarbageCollector.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGridVolumeMapper.h"

namespace nephoscope
{

class CellsInPlace
{
public:
  explicit CellsInPlace(vtkUnstructuredGridVolumeMapper* owner)
    : Owner(owner)
  {
    VolumeOrder::Enrol(
      owner, CellsInOrder::PartOf([this]() { return this->GetMapper(this->Owner); }));
  }
  ~CellsInPlace() { VolumeOrder::Leave(this->Owner); }
  CellsInPlace(const CellsInPlace&) = delete;
  CellsInPlace& operator=(const CellsInPlace&) = delete;

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    VolumeOrder::ReleaseGraphicsResources(this->Owner, window);
    this->Mapper->ReleaseGraphicsResources(window);
  }

  /** Both mappers refer to the pipeline; without this it would never be collected. */
  void ReportReferences(vtkGarbageCollector* collector)
  {
    vtkGarbageCollectorReport(collector, this->Mapper, "CellCompositingMapper");
  }

  vtkCellCompositingMapper* GetMapper() { return this->Mapper; }
  /** With the owner's input and settings as they are now. */
  vtkCellCompositingMapper* GetMapper(vtkUnstructuredGridVolumeMapper* owner)
  {
    CopyInputAndScalars(owner, this->Mapper);
    this->Mapper->SetClippingPlanes(owner->GetClippingPlanes());
    return this->Mapper;
  }

private:
  vtkUnstructuredGridVolumeMapper* Owner;
  vtkSmartPointer<vtkCellCompositingMapper> Mapper =
    vtkSmartPointer<vtkCellCompositingMapper>::New();
};

}

#endif
