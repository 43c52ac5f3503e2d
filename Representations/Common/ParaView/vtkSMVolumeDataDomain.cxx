// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMVolumeDataDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkSMVolumeDataDomain);

int vtkSMVolumeDataDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  this->RepresentationName = element->GetAttributeOrEmpty("representation");
  this->Sheets = element->GetAttribute("sheets") != nullptr;
  return this->Superclass::ReadXMLAttributes(property, element);
}

namespace
{
// In a plane across an axis, as 2-D adaptive meshes are.
bool IsFlat(vtkPVDataInformation* data)
{
  const double* bounds = data->GetBounds();
  return bounds[0] == bounds[1] || bounds[2] == bounds[3] || bounds[4] == bounds[5];
}
}

bool vtkSMVolumeDataDomain::MayHoldVolumes(vtkPVDataInformation* data)
{
  if (!data || data->IsNull())
  {
    return true;
  }
  if (data->IsCompositeDataSet())
  {
    const std::vector<int>& types = data->GetUniqueBlockTypes();
    const bool mayHold = types.empty() ||
      std::any_of(types.begin(), types.end(), [](int type) { return type != VTK_POLY_DATA; });
    return mayHold && !IsFlat(data);
  }
  if (data->IsDataStructured())
  {
    const int* extent = data->GetExtent();
    return extent[0] < extent[1] && extent[2] < extent[3] && extent[4] < extent[5];
  }
  if (data->DataSetTypeIsA(VTK_HYPER_TREE_GRID))
  {
    return !IsFlat(data);
  }
  return !data->DataSetTypeIsA(VTK_POLY_DATA);
}

bool vtkSMVolumeDataDomain::IsSurface(vtkPVDataInformation* data)
{
  return !data || data->IsNull() || data->IsCompositeDataSet() || !data->IsDataStructured() ||
    !MayHoldVolumes(data);
}

void vtkSMVolumeDataDomain::Update(vtkSMProperty*)
{
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  vtkSMProxy* own = input ? input->GetParent() : nullptr;
  vtkSMProxy* host = own ? own->GetTrueParentProxy() : nullptr;
  vtkSMProperty* chosen = host ? host->GetProperty("Representation") : nullptr;
  auto offered = chosen ? chosen->FindDomain<vtkSMStringListDomain>() : nullptr;
  if (!offered)
  {
    return; // not part of one of ParaView's representations
  }
  vtkSMUncheckedPropertyHelper helper(input);
  auto source = helper.GetNumberOfElements() > 0
    ? vtkSMSourceProxy::SafeDownCast(helper.GetAsProxy(0))
    : nullptr;
  vtkPVDataInformation* data =
    source ? source->GetDataInformation(helper.GetOutputPort(0)) : nullptr;
  const bool offer = (this->Sheets ? IsSurface(data) : MayHoldVolumes(data)) ||
    this->RepresentationName == vtkSMPropertyHelper(chosen).GetAsString();
  std::vector<std::string> names;
  for (unsigned int i = 0; i < offered->GetNumberOfStrings(); ++i)
  {
    names.emplace_back(offered->GetString(i));
  }
  const auto found = std::find(names.begin(), names.end(), this->RepresentationName);
  if (offer == (found != names.end()))
  {
    return;
  }
  if (offer)
  {
    names.push_back(this->RepresentationName);
  }
  else
  {
    names.erase(found);
  }
  // The list's own setter, which is protected: reached as the member that this class inherits.
  (offered->*(&vtkSMVolumeDataDomain::SetStrings))(names);
}
