// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunConnection.h"

#include "vtkNew.h"
#include "vtkSMInputProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"

#include <functional>
#include <string>

namespace nephoscope
{
namespace
{
bool IsA(vtkSMProxy* proxy, const char* group, const char* name)
{
  return proxy->GetXMLGroup() && proxy->GetXMLName() &&
    group == std::string(proxy->GetXMLGroup()) && name == std::string(proxy->GetXMLName());
}

bool IsSun(vtkSMProxy* proxy)
{
  return IsA(proxy, "sources", "Sun");
}

// Whether a proxy computes the light of a sun.
bool IsSunlit(vtkSMProxy* proxy)
{
  return IsA(proxy, "filters", "Sunlight") || IsA(proxy, "sources", "CloudsOverTheGlobe");
}

void ForEachInPipeline(vtkSMProxy* any, const std::function<void(vtkSMProxy*)>& act)
{
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSession(any->GetSession());
  proxies->SetModeToOneGroup();
  for (proxies->Begin("sources"); !proxies->IsAtEnd(); proxies->Next())
  {
    act(proxies->GetProxy());
  }
}

void Connect(vtkSMProxy* lit, vtkSMProxy* sun)
{
  auto* input = vtkSMInputProperty::SafeDownCast(lit->GetProperty("Sun"));
  if (input && input->GetNumberOfProxies() == 0)
  {
    input->SetInputConnection(0, sun, 0);
    lit->UpdateVTKObjects();
  }
}
}

void ConnectToSun(vtkSMProxy* proxy)
{
  if (IsSun(proxy))
  {
    ForEachInPipeline(proxy, [proxy](vtkSMProxy* other) {
      if (IsSunlit(other))
      {
        Connect(other, proxy);
      }
    });
  }
  else if (IsSunlit(proxy))
  {
    vtkSMProxy* latest = nullptr;
    ForEachInPipeline(proxy, [&latest](vtkSMProxy* other) {
      const bool later = IsSun(other) && (!latest || other->GetGlobalID() > latest->GetGlobalID());
      latest = later ? other : latest;
    });
    if (latest)
    {
      Connect(proxy, latest);
    }
  }
}

} // namespace nephoscope
