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
bool isA(vtkSMProxy* proxy, const char* group, const char* name)
{
  return proxy->GetXMLGroup() && proxy->GetXMLName() &&
    group == std::string(proxy->GetXMLGroup()) && name == std::string(proxy->GetXMLName());
}

bool isSun(vtkSMProxy* proxy)
{
  return isA(proxy, "sources", "Sun");
}

// Whether a proxy computes the light of a sun.
bool isSunlit(vtkSMProxy* proxy)
{
  return isA(proxy, "filters", "Sunlight") || isA(proxy, "sources", "CloudsOverTheGlobe");
}

void forEachInPipeline(vtkSMProxy* any, const std::function<void(vtkSMProxy*)>& act)
{
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSession(any->GetSession());
  proxies->SetModeToOneGroup();
  for (proxies->Begin("sources"); !proxies->IsAtEnd(); proxies->Next())
  {
    act(proxies->GetProxy());
  }
}

void connect(vtkSMProxy* lit, vtkSMProxy* sun)
{
  auto* input = vtkSMInputProperty::SafeDownCast(lit->GetProperty("Sun"));
  if (input && input->GetNumberOfProxies() == 0)
  {
    input->SetInputConnection(0, sun, 0);
    lit->UpdateVTKObjects();
  }
}
}

void connectToSun(vtkSMProxy* proxy)
{
  if (isSun(proxy))
  {
    forEachInPipeline(proxy, [proxy](vtkSMProxy* other) {
      if (isSunlit(other))
      {
        connect(other, proxy);
      }
    });
  }
  else if (isSunlit(proxy))
  {
    vtkSMProxy* latest = nullptr;
    forEachInPipeline(proxy, [&latest](vtkSMProxy* other) {
      const bool later = isSun(other) && (!latest || other->GetGlobalID() > latest->GetGlobalID());
      latest = later ? other : latest;
    });
    if (latest)
    {
      connect(proxy, latest);
    }
  }
}

} // namespace nephoscope
