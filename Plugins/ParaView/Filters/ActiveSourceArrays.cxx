// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ActiveSourceArrays.h"

#include "vtkPVDataInformation.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSmartPointer.h"

namespace nephoscope
{
namespace
{
vtkPVDataInformation* DataOfActiveSource(vtkSMSessionProxyManager* manager)
{
  vtkSMProxySelectionModel* active = manager->GetSelectionModel("ActiveSources");
  vtkSMProxy* current = active ? active->GetCurrentProxy() : nullptr;
  if (auto* port = vtkSMOutputPort::SafeDownCast(current))
  {
    return port->GetDataInformation();
  }
  auto* source = vtkSMSourceProxy::SafeDownCast(current);
  return source ? source->GetDataInformation() : nullptr;
}

vtkPVDataInformation* DataOfInput(vtkSMProxy* filter)
{
  const vtkSMPropertyHelper input(filter, "Input", true);
  auto* source =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  return source ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
}
}

void ForgetArraysOfActiveSource(vtkSMProxy* filter)
{
  vtkPVDataInformation* active = DataOfActiveSource(filter->GetSessionProxyManager());
  vtkPVDataInformation* input = DataOfInput(filter);
  if (!active || !input || active == input)
  {
    return;
  }
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(filter->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    auto* chosen = vtkSMStringVectorProperty::SafeDownCast(properties->GetProperty());
    if (!chosen || chosen->GetNumberOfElements() != 5 ||
      !chosen->FindDomain<vtkSMArrayListDomain>())
    {
      continue;
    }
    const vtkSMPropertyHelper array(chosen);
    const char* name = array.GetInputArrayNameToProcess();
    const int association = array.GetInputArrayAssociation();
    if (name && *name && active->GetArrayInformation(name, association) &&
      !input->GetArrayInformation(name, association))
    {
      chosen->ResetToDomainDefaults();
    }
  }
  filter->UpdateVTKObjects();
}
}
