// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFlowVolumeInitializationHelper.h"

#include "ActiveSourceArrays.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <vector>

vtkStandardNewMacro(vtkSMFlowVolumeInitializationHelper);

namespace
{
struct Placed
{
  const char* Found;
  const char* Property;
};
constexpr Placed placedProperties[] = { { "PlaceRadius", "Radius" }, { "PlaceCenter", "Center" },
  { "PlaceNormal", "Normal" } };

void Copy(vtkSMProxy* proxy, const Placed& placed)
{
  const auto values = vtkSMPropertyHelper(proxy, placed.Found).GetDoubleArray();
  vtkSMPropertyHelper(proxy, placed.Property)
    .Set(values.data(), static_cast<unsigned int>(values.size()));
}

bool IsPlaced(vtkSMProxy* proxy)
{
  return vtkSMPropertyHelper(proxy, "PlaceRadius").GetAsDouble() > 0.0;
}

// Shows, after an update, where the server has placed the polygon anew.
void ShowPlace(vtkObject* caller, unsigned long, void*, void*)
{
  auto proxy = vtkSMProxy::SafeDownCast(caller);
  std::vector<std::vector<double>> before;
  for (const Placed& placed : placedProperties)
  {
    before.push_back(vtkSMPropertyHelper(proxy, placed.Found).GetDoubleArray());
    if (vtkSMPropertyHelper(proxy, placed.Property).GetDoubleArray() != before.back())
    {
      return; // somebody has put it elsewhere
    }
  }
  proxy->UpdatePropertyInformation();
  std::size_t i = 0;
  for (const Placed& placed : placedProperties)
  {
    if (IsPlaced(proxy) && vtkSMPropertyHelper(proxy, placed.Found).GetDoubleArray() != before[i++])
    {
      Copy(proxy, placed);
    }
  }
  proxy->UpdateVTKObjects();
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
  nephoscope::ForgetArraysOfActiveSource(proxy);
  proxy->UpdateVTKObjects();
  proxy->InvokeCommand("FindPlace");
  proxy->UpdatePropertyInformation();
  bool isSet = false;
  for (const Placed& placed : placedProperties)
  {
    if (proxy->GetProperty(placed.Property)->GetMTime() > initializationTime)
    {
      isSet = true;
    }
    else if (IsPlaced(proxy)) // else: no data yet, or nothing flows
    {
      Copy(proxy, placed);
    }
  }
  if (isSet)
  {
    vtkSMPropertyHelper(proxy, "FollowData").Set(0);
    return;
  }
  vtkNew<vtkCallbackCommand> showPlace;
  showPlace->SetCallback(ShowPlace);
  proxy->AddObserver(vtkCommand::UpdateDataEvent, showPlace);
}
