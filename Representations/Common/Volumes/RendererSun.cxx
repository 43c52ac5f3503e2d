// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RendererSun.h"

#include "DataSets.h"
#include "VolumeOrder.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
vtkInformationDoubleVectorKey* SunKey()
{
  static vtkInformationDoubleVectorKey* const key =
    vtkInformationDoubleVectorKey::MakeKey("SUN", "nephoscope", 3);
  return key;
}

double GreatestIn(vtkDataObject* data, const char* name, double greatest)
{
  vtkDataArray* array = data->GetFieldData() ? data->GetFieldData()->GetArray(name) : nullptr;
  if (array && array->GetNumberOfTuples() > 0 && array->GetNumberOfComponents() > 0)
  {
    greatest = std::max(greatest, array->GetComponent(0, 0));
  }
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      greatest = GreatestIn(blocks->GetCurrentDataObject(), name, greatest);
    }
  }
  return greatest;
}

vtkAlgorithm* MapperOf(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* volume = vtkVolume::SafeDownCast(prop);
  return actor ? static_cast<vtkAlgorithm*>(actor->GetMapper())
    : volume   ? static_cast<vtkAlgorithm*>(volume->GetMapper())
               : nullptr;
}
}

void SetSunOf(vtkRenderer* renderer, const double* towardsSun)
{
  vtkNew<vtkInformation> empty;
  if (!renderer->GetInformation())
  {
    renderer->SetInformation(empty);
  }
  if (towardsSun)
  {
    renderer->GetInformation()->Set(SunKey(), towardsSun, 3);
  }
  else
  {
    renderer->GetInformation()->Remove(SunKey());
  }
}

bool FindSunOf(vtkRenderer* renderer, double towardsSun[3])
{
  vtkInformation* information = renderer->GetInformation();
  const double* found = information ? information->Get(SunKey()) : nullptr;
  if (found)
  {
    std::copy_n(found, 3, towardsSun);
  }
  return found != nullptr;
}

double GreatestFieldValue(vtkRenderer* renderer, const char* name, double otherwise)
{
  vtkCollectionSimpleIterator iterator;
  renderer->GetViewProps()->InitTraversal(iterator);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(iterator))
  {
    vtkAlgorithm* mapper = prop->GetVisibility() ? MapperOf(prop) : nullptr;
    vtkDataObject* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
      ? mapper->GetInputDataObject(0, 0)
      : nullptr;
    otherwise = data ? GreatestIn(data, name, otherwise) : otherwise;
  }
  return otherwise;
}

bool HasVolumesWithout(vtkRenderer* renderer, const char* array)
{
  bool hasVolumes = false;
  vtkCollectionSimpleIterator iterator;
  renderer->GetViewProps()->InitTraversal(iterator);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(iterator))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    vtkAlgorithm* mapper = volume && VolumeOrder::IsDrawn(volume) && VolumeOrder::IsEnrolled(volume)
      ? volume->GetMapper()
      : nullptr;
    vtkDataObject* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
      ? mapper->GetInputDataObject(0, 0)
      : nullptr;
    if (data && data->GetNumberOfElements(vtkDataObject::CELL) > 0)
    {
      hasVolumes = true;
      bool has = false;
      ForEachLeaf(data, [&](vtkDataObject* leaf) {
        auto* set = vtkDataSet::SafeDownCast(leaf);
        has = has ||
          (set && (set->GetPointData()->HasArray(array) || set->GetCellData()->HasArray(array)));
      });
      if (has)
      {
        return false;
      }
    }
  }
  return hasVolumes;
}
}
