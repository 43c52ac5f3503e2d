// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorsOfLight.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>

namespace nephoscope
{
namespace
{
using Range = std::array<double, 2>;

Range RangeOf(vtkSMProxy* colors)
{
  Range range{ { 0.0, 0.0 } };
  vtkSMTransferFunctionProxy::GetRange(colors, range.data());
  return range;
}

void Whiten(vtkSMProxy* colors, double white)
{
  vtkSMTransferFunctionProxy::RescaleTransferFunction(colors, RangeOf(colors)[0], white);
  colors->UpdateVTKObjects();
}

// Not with the light itself: in a film of a day, nights are dark.
class EyeOfLight
{
public:
  EyeOfLight(vtkSMSourceProxy* source, int port, vtkSMProxy* colors, const std::string& array)
    : Source(source)
    , Port(port)
    , Colors(colors)
    , Array(array)
    , Given(RangeOf(colors))
  {
    source->AddObserver(vtkCommand::PropertyModifiedEvent, this, &EyeOfLight::OnProperty);
    source->AddObserver(vtkCommand::UpdateDataEvent, this, &EyeOfLight::OnData);
    source->AddObserver(vtkCommand::DeleteEvent, this, &EyeOfLight::OnDelete);
  }

private:
  void OnProperty(vtkObject*, unsigned long, void* name)
  {
    this->HasChanged =
      this->HasChanged || (name && static_cast<const char*>(name) == std::string("FollowCamera"));
  }

  void OnData(vtkObject*, unsigned long, void*)
  {
    if (!this->HasChanged || !this->Colors)
    {
      return;
    }
    this->HasChanged = false;
    const double white =
      LightThatIsWhite(this->Source->GetDataInformation(this->Port), this->Array);
    if (white > 0.0 && RangeOf(this->Colors) == this->Given)
    {
      Whiten(this->Colors, white);
      this->Given = RangeOf(this->Colors);
    }
  }

  void OnDelete(vtkObject*, unsigned long, void*) { delete this; }

  vtkSMSourceProxy* Source; // which outlives this
  int Port;
  vtkWeakPointer<vtkSMProxy> Colors;
  std::string Array;
  Range Given;
  bool HasChanged = false;
};
}

double LightThatIsWhite(vtkPVDataInformation* data, const std::string& array)
{
  const bool isSmoke = data->GetArrayInformation("SmokeExtinction", vtkDataObject::CELL) ||
    data->GetArrayInformation("SmokeExtinction", vtkDataObject::POINT);
  vtkPVArrayInformation* light = data->GetArrayInformation(array.c_str(), vtkDataObject::POINT);
  vtkPVArrayInformation* white = data->GetArrayInformation("WhiteLight", vtkDataObject::FIELD);
  constexpr double share = 0.7; // of the greatest light, which few places have
  constexpr double usual = 0.6; // of clouds
  if (isSmoke && light)
  {
    return std::min(share * light->GetComponentFiniteRange(0)[1], usual);
  }
  return array == "Sunlight" && white ? white->GetComponentRange(0)[1] : 0.0;
}

void ApplyFixedPreset(vtkSMProxy* colors, const char* preset, double white)
{
  vtkSMTransferFunctionProxy::ApplyPreset(colors, preset, false);
  vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode", true)
    .Set(vtkSMTransferFunctionManager::NEVER);
  colors->UpdateVTKObjects();
  if (white > 0.0)
  {
    Whiten(colors, white);
  }
}

void FollowEyeOfLight(
  vtkSMSourceProxy* source, int port, vtkSMProxy* colors, const std::string& array)
{
  new EyeOfLight(source, port, colors, array); // deletes itself
}

} // namespace nephoscope
