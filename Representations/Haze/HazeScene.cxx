// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeScene.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

namespace nephoscope
{
namespace
{
void listen(HazeScene& scene, vtkDataObject* data)
{
  const auto take = [data](const char* name, double& value) {
    vtkDataArray* array = data->GetFieldData() ? data->GetFieldData()->GetArray(name) : nullptr;
    if (array && array->GetNumberOfTuples() > 0 && array->GetNumberOfComponents() > 0)
    {
      value = std::max(value, array->GetComponent(0, 0));
    }
  };
  take("GlobeGridProjection", scene.GlobeGridProjection);
  take("PlanetRadius", scene.PlanetRadius);
  take("VerticalExaggeration", scene.VerticalExaggeration);
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return;
  }
  auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    listen(scene, blocks->GetCurrentDataObject());
  }
}

vtkAlgorithm* mapperOf(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* volume = vtkVolume::SafeDownCast(prop);
  return actor ? static_cast<vtkAlgorithm*>(actor->GetMapper())
    : volume   ? static_cast<vtkAlgorithm*>(volume->GetMapper())
               : nullptr;
}
}

HazeScene::HazeScene(vtkRenderer* renderer)
{
  renderer->GetActiveCamera()->GetPosition(this->Eye);
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = bounds[2 * c];
      this->High[c] = bounds[2 * c + 1];
    }
  }
  vtkCollectionSimpleIterator iterator;
  renderer->GetViewProps()->InitTraversal(iterator);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(iterator))
  {
    vtkAlgorithm* mapper = prop->GetVisibility() ? mapperOf(prop) : nullptr;
    vtkDataObject* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
      ? mapper->GetInputDataObject(0, 0)
      : nullptr;
    if (data)
    {
      listen(*this, data);
    }
  }
}

} // namespace nephoscope
