// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMExampleColoring.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

#include <cstring>

vtkStandardNewMacro(vtkSMExampleColoring);

namespace
{
void ColorClouds(vtkObject*, unsigned long, void*, void* data)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  auto* display = registered ? vtkSMPVRepresentationProxy::SafeDownCast(registered->Proxy) : nullptr;
  if (!display || display->GetSessionProxyManager()->GetInLoadXMLState() || display->GetUsingScalarColoring())
  {
    return;
  }
  const vtkSMPropertyHelper input(display, "Input", true);
  vtkSMProxy* source = input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr;
  if (source && std::strcmp(source->GetXMLName(), "CloudsOverTheGlobe") == 0)
  {
    display->SetScalarColoring("cloud_fraction", vtkDataObject::POINT);
    display->RescaleTransferFunctionToDataRange(true, false);
    display->UpdateVTKObjects();
  }
}
}

void vtkSMExampleColoring::Load()
{
  static bool isLoaded = false;
  if (!isLoaded && vtkSMProxyManager::IsInitialized())
  {
    isLoaded = true;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(ColorClouds);
    vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
  }
}
