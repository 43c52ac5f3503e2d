// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeletedInputs.h"

#include "ClassesOfSuite.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSMInputProperty.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <set>
#include <string>

namespace nephoscope
{
namespace
{
std::set<vtkSMProxy*> SourcesOf(vtkSMProxy* timeKeeper)
{
  std::set<vtkSMProxy*> sources;
  const vtkSMPropertyHelper helper(timeKeeper, "TimeSources");
  for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i)
  {
    sources.insert(helper.GetAsProxy(i));
  }
  return sources;
}

// From displays all inputs but that of their data, from filters the sun, which the suite has
// connected.
bool IsTakenAway(vtkSMProxy* from, const std::string& input)
{
  return from->IsA("vtkSMSourceProxy") && !from->IsA("vtkSMRepresentationProxy")
    ? input == "Sun" && IsOfSuite(from->GetVTKClassName())
    : input != "Input";
}

void TakeAway(vtkSMProxy* proxy, const std::set<vtkSMProxy*>& deleted)
{
  const auto properties = vtk::TakeSmartPointer(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    auto* input = vtkSMInputProperty::SafeDownCast(properties->GetProperty());
    if (input && IsTakenAway(proxy, properties->GetKey()) && input->GetNumberOfProxies() > 0 &&
      deleted.count(input->GetProxy(0)) > 0)
    {
      input->RemoveAllProxies();
      proxy->UpdateVTKObjects();
    }
  }
}

// What ParaView deletes is no longer among the sources of the time, before displays go.
struct SourceWatch
{
  vtkWeakPointer<vtkSMProxy> TimeKeeper;
  std::set<vtkSMProxy*> Sources; // to compare only: some may be gone

  void Update()
  {
    const std::set<vtkSMProxy*> now = SourcesOf(this->TimeKeeper);
    std::set<vtkSMProxy*> deleted;
    for (vtkSMProxy* source : this->Sources)
    {
      if (now.count(source) == 0)
      {
        deleted.insert(source);
      }
    }
    this->Sources = now;
    if (deleted.empty())
    {
      return;
    }
    vtkNew<vtkSMProxyIterator> proxies;
    proxies->SetSession(this->TimeKeeper->GetSession());
    proxies->SetModeToOneGroup();
    for (const char* group : { "representations", "sources" })
    {
      for (proxies->Begin(group); !proxies->IsAtEnd(); proxies->Next())
      {
        TakeAway(proxies->GetProxy(), deleted);
      }
    }
  }
};

SourceWatch& TheSourceWatch()
{
  static SourceWatch watch;
  return watch;
}

void OnTimeKeeper(vtkObject*, unsigned long, void*, void* data)
{
  if (data && std::string(static_cast<const char*>(data)) == "TimeSources")
  {
    TheSourceWatch().Update();
  }
}
}

void OutliveOptionalInputs(vtkSMProxy* proxy)
{
  vtkNew<vtkSMParaViewPipelineController> controller;
  vtkSMProxy* timeKeeper = controller->FindTimeKeeper(proxy->GetSession());
  SourceWatch& watch = TheSourceWatch();
  if (!timeKeeper || watch.TimeKeeper == timeKeeper)
  {
    return;
  }
  watch.TimeKeeper = timeKeeper;
  watch.Sources = SourcesOf(timeKeeper);
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnTimeKeeper);
  timeKeeper->AddObserver(vtkCommand::PropertyModifiedEvent, command);
}

} // namespace nephoscope
