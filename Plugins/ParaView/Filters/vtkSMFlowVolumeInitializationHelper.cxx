// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFlowVolumeInitializationHelper.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <vector>

vtkStandardNewMacro(vtkSMFlowVolumeInitializationHelper);

namespace
{
void CopyUnlessSet(
  vtkSMProxy* proxy, const char* from, const char* to, vtkMTimeType initializationTime)
{
  vtkSMProperty* target = proxy->GetProperty(to);
  if (target->GetMTime() <= initializationTime)
  {
    const auto values = vtkSMPropertyHelper(proxy, from).GetDoubleArray();
    vtkSMPropertyHelper(target).Set(values.data(), static_cast<unsigned int>(values.size()));
  }
}
}

void vtkSMFlowVolumeInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTime)
{
  // The default of the vectors is set after this; the place must be found in them all the same.
  if (vtkSMProperty* vectors = proxy->GetProperty("SelectInputVectors"))
  {
    if (vectors->GetMTime() <= initializationTime)
    {
      vectors->ResetToDomainDefaults();
    }
  }
  proxy->UpdateVTKObjects();
  proxy->InvokeCommand("FindPlace");
  proxy->UpdatePropertyInformation();
  if (vtkSMPropertyHelper(proxy, "PlaceRadius").GetAsDouble() <= 0.0)
  {
    return; // no data yet, or nothing flows
  }
  CopyUnlessSet(proxy, "PlaceRadius", "Radius", initializationTime);
  CopyUnlessSet(proxy, "PlaceCenter", "Center", initializationTime);
  CopyUnlessSet(proxy, "PlaceNormal", "Normal", initializationTime);
}
