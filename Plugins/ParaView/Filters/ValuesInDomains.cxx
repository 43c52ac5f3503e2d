// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ValuesInDomains.h"

#include "ClassesOfSuite.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMDomain.h"
#include "vtkSMDomainIterator.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>
#include <string>

namespace nephoscope
{
namespace
{
// Those of subclasses follow the data: they are proposals.
template <class Domain>
Domain* RangeOf(vtkSMProperty* property)
{
  vtkSmartPointer<vtkSMDomainIterator> domains;
  domains.TakeReference(property->NewDomainIterator());
  for (domains->Begin(); !domains->IsAtEnd(); domains->Next())
  {
    auto* domain = Domain::SafeDownCast(domains->GetDomain());
    if (domain &&
      (std::strcmp(domain->GetClassName(), "vtkSMDoubleRangeDomain") == 0 ||
        std::strcmp(domain->GetClassName(), "vtkSMIntRangeDomain") == 0))
    {
      return domain;
    }
  }
  return nullptr;
}

template <class Domain>
std::string Told(Domain* domain, unsigned int i)
{
  std::ostringstream told;
  int hasLeast = 0, hasMost = 0;
  const auto least = domain->GetMinimum(i, hasLeast), most = domain->GetMaximum(i, hasMost);
  if (hasLeast && hasMost)
  {
    told << least << " to " << most;
  }
  else
  {
    hasLeast    ? told << "at least " << least
      : hasMost ? told << "at most " << most
                : told << "a finite number";
  }
  return told.str();
}

bool IsFinite(vtkSMDoubleVectorProperty* property)
{
  const double* first = property->GetElements();
  return std::all_of(first, first + property->GetNumberOfElements(),
    [](double value) { return std::isfinite(value); });
}

bool IsFinite(vtkSMIntVectorProperty*)
{
  return true;
}

// With the option --sym every rank is a client: the first one tells.
void Tell(vtkSMProxy* proxy, vtkSMProperty* property, const std::string& problem)
{
  if (vtkProcessModule::GetProcessModule()->GetPartitionId() == 0)
  {
    vtkWarningWithObjectMacro(proxy, << property->GetXMLLabel() << " " << problem);
  }
}

template <class Property, class Domain>
bool KeepIn(vtkSMProxy* proxy, Property* property, Domain* domain)
{
  bool changed = false;
  if (domain && !IsFinite(property))
  {
    Tell(proxy, property,
      "is not a finite number; it must be " + Told(domain, 0) +
        ". It has been set to its default.");
    property->ResetToXMLDefaults();
    changed = true;
  }
  for (unsigned int i = 0; domain && i < property->GetNumberOfElements(); ++i)
  {
    const unsigned int at = property->GetRepeatCommand() ? 0 : i;
    int hasLeast = 0, hasMost = 0;
    const auto least = domain->GetMinimum(at, hasLeast), most = domain->GetMaximum(at, hasMost);
    const auto given = property->GetElement(i);
    auto kept = hasLeast ? std::max(given, least) : given;
    kept = hasMost ? std::min(kept, most) : kept;
    if (!(kept == given))
    {
      std::ostringstream problem;
      problem << "is " << given << "; it must be " << Told(domain, at) << ". It has been set to "
              << kept << ".";
      Tell(proxy, property, problem.str());
      property->SetElement(i, kept);
      changed = true;
    }
  }
  return changed;
}

bool Keep(vtkSMProxy* proxy, vtkSMProperty* property)
{
  if (!property || property->GetInformationOnly())
  {
    return false;
  }
  if (auto* numbers = vtkSMDoubleVectorProperty::SafeDownCast(property))
  {
    return KeepIn(proxy, numbers, RangeOf<vtkSMDoubleRangeDomain>(property));
  }
  auto* counts = vtkSMIntVectorProperty::SafeDownCast(property);
  return counts && KeepIn(proxy, counts, RangeOf<vtkSMIntRangeDomain>(property));
}

void OnProperty(vtkObject* caller, unsigned long, void*, void* name)
{
  auto* proxy = vtkSMProxy::SafeDownCast(caller);
  if (proxy && name)
  {
    Keep(proxy, proxy->GetProperty(static_cast<const char*>(name)));
  }
}

void KeepAll(vtkSMProxy* proxy)
{
  bool changed = false;
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    changed = Keep(proxy, properties->GetProperty()) || changed;
  }
  if (changed)
  {
    proxy->UpdateVTKObjects();
  }
}
}

void KeepValuesInDomains(vtkSMProxy* proxy)
{
  std::set<vtkSMProxy*> owners = {
    proxy
  }; // of properties that a display shows: displays inside it
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    owners.insert(properties->GetProperty()->GetParent());
  }
  for (vtkSMProxy* owner : owners)
  {
    if (owner && IsOfSuite(owner->GetVTKClassName()))
    {
      KeepAll(owner); // what was given when it was made
      vtkNew<vtkCallbackCommand> command;
      command->SetCallback(OnProperty);
      owner->AddObserver(vtkCommand::PropertyModifiedEvent, command);
    }
  }
}

} // namespace nephoscope
