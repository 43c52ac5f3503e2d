// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFirstLook.h"

#include "ClassesOfSuite.h"
#include "FirstCamera.h"
#include "FlowVolumePolygon.h"
#include "SunConnection.h"
#include "ValuesInDomains.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkRankMessages.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMFirstLook);

namespace
{
constexpr double bright = 0.7; // luminance
constexpr double darkSmoke[3] = { 0.35, 0.35, 0.35 };
const std::string ourPresets = "Nephoscope ";
constexpr const char* presetsOfClouds[] = { "Nephoscope Clouds", "Nephoscope Cloud Water" };

// The name of the preset that an array begins with, or an empty one.
std::string PresetOf(const std::string& array, const std::string& list = "standard_presets")
{
  vtkSMSettings* settings = vtkSMSettings::GetInstance();
  const std::string key = "." + list + "." + array;
  return settings->HasSetting(key.c_str()) ? settings->GetSettingAsString(key.c_str(), 0, "")
                                           : std::string();
}

// The preset of a name that is usual elsewhere too; only for data of the weather, those of Globe Grid.
std::string WeatherPresetOf(const std::string& array, vtkPVDataInformation* data)
{
  const bool weather = PresetOf(array).empty() &&
    data->GetArrayInformation("GlobeGridProjection", vtkDataObject::FIELD);
  return weather ? PresetOf(array, "nephoscope_weather_presets") : std::string();
}

// The point array that clouds are coloured by; an empty name where there is none.
std::string ArrayOfClouds(vtkPVDataInformation* data)
{
  vtkPVDataSetAttributesInformation* arrays = data->GetAttributeInformation(vtkDataObject::POINT);
  for (const char* preset : presetsOfClouds)
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      const char* name = arrays->GetArrayInformation(i)->GetName();
      if (name && (PresetOf(name) == preset || WeatherPresetOf(name, data) == preset))
      {
        return name;
      }
    }
  }
  return std::string();
}

// Without their values.
std::vector<double> ColorsOf(vtkSMProxy* function)
{
  std::vector<double> colors = vtkSMPropertyHelper(function, "RGBPoints").GetDoubleArray();
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    colors[i] = 0.0;
  }
  return colors;
}

// That ParaView gives to an array without a preset.
std::vector<double> ColorsOfAnyArray(vtkSMSessionProxyManager* manager)
{
  vtkNew<vtkSMTransferFunctionManager> functions;
  vtkSMProxy* any = functions->GetColorTransferFunction("NephoscopeAnyArray", manager);
  const std::vector<double> colors = any ? ColorsOf(any) : std::vector<double>();
  manager->UnRegisterProxy(any);
  return colors;
}

void ApplyPreset(vtkSMProxy* display, const char* property, const std::string& preset)
{
  vtkSMProxy* function = vtkSMPropertyHelper(display, property, true).GetAsProxy();
  if (function && vtkSMTransferFunctionPresets::GetInstance()->HasPreset(preset.c_str()))
  {
    vtkSMTransferFunctionProxy::ApplyPreset(function, preset.c_str(), false);
    function->UpdateVTKObjects();
  }
}

// Colours and opacities of a name that is usual elsewhere too, unless somebody has chosen others.
void UseWeatherPreset(vtkSMProxy* display, const std::string& array, vtkPVDataInformation* data)
{
  const std::string preset = WeatherPresetOf(array, data);
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable", true).GetAsProxy();
  const bool saved =
    vtkSMSettings::GetInstance()->HasSetting((".array_lookup_tables." + array).c_str());
  if (!preset.empty() && colors && !saved &&
    ColorsOf(colors) == ColorsOfAnyArray(display->GetSessionProxyManager()))
  {
    ApplyPreset(display, "LookupTable", preset);
    ApplyPreset(display, "ScalarOpacityFunction", preset);
  }
}

struct ColoredArray
{
  std::string Name;
  int Association = vtkDataObject::POINT;
};

// The active scalars, of points first; else the first array of one component.
ColoredArray ActiveScalars(vtkPVDataInformation* data)
{
  for (const bool active : { true, false })
  {
    for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      vtkPVDataSetAttributesInformation* arrays = data->GetAttributeInformation(association);
      vtkPVArrayInformation* scalars =
        active ? arrays->GetAttributeInformation(vtkDataSetAttributes::SCALARS) : nullptr;
      for (int i = 0; !active && !scalars && i < arrays->GetNumberOfArrays(); ++i)
      {
        vtkPVArrayInformation* array = arrays->GetArrayInformation(i);
        const std::string name = array->GetName() ? array->GetName() : "";
        const bool fits =
          array->GetNumberOfComponents() == 1 && name != vtkDataSetAttributes::GhostArrayName();
        scalars = fits ? array : nullptr;
      }
      if (scalars && scalars->GetName())
      {
        return { scalars->GetName(), association };
      }
    }
  }
  return {};
}

// White smoke cannot be seen on the palette's background if that is bright.
void DarkenOnBrightBackground(vtkSMProxy* display)
{
  vtkSMProxy* palette = display->GetSessionProxyManager()->GetProxy("settings", "ColorPalette");
  const std::vector<double> background = palette
    ? vtkSMPropertyHelper(palette, "BackgroundColor", true).GetDoubleArray()
    : std::vector<double>();
  if (background.size() == 3 &&
    0.3 * background[0] + 0.59 * background[1] + 0.11 * background[2] > bright)
  {
    for (const char* property : { "AmbientColor", "DiffuseColor" })
    {
      vtkSMPropertyHelper(display, property, true).Set(darkSmoke, 3);
    }
  }
}

// A surface at one value of an array has one colour in the colours of that array, and not the best one.
bool IsColoredByContouredArray(vtkSMProxy* display, vtkSMProxy* source, vtkPVDataInformation* data)
{
  const vtkSMPropertyHelper colored(display, "ColorArrayName", true),
    contoured(source, "SelectInputScalars", true);
  std::string name = contoured.GetNumberOfElements() == 5 && contoured.GetAsString(4)
    ? contoured.GetAsString(4)
    : "";
  name = name.empty() ? ActiveScalars(data).Name
                      : name; // as a filter does that was made before there were data
  return colored.GetNumberOfElements() == 5 && name == colored.GetAsString(4);
}

void Color(
  vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port, const std::string& how)
{
  vtkPVDataInformation* data = source->GetDataInformation(port);
  if (how == "solid" || (how == "surface" && IsColoredByContouredArray(display, source, data)))
  {
    display->SetScalarColoring(nullptr, vtkDataObject::POINT);
    if (how == "solid")
    {
      DarkenOnBrightBackground(display);
    }
    return;
  }
  ColoredArray array{ how, vtkDataObject::CELL };
  if (!data->GetArrayInformation(how.c_str(), array.Association))
  {
    array.Association = vtkDataObject::POINT;
  }
  const bool given = data->GetArrayInformation(how.c_str(), array.Association) != nullptr;
  if (!given && display->GetUsingScalarColoring()) // as its input is, for one
  {
    const vtkSMPropertyHelper colored(display, "ColorArrayName", true);
    UseWeatherPreset(display,
      colored.GetNumberOfElements() == 5 && colored.GetAsString(4) ? colored.GetAsString(4) : "",
      data);
    return;
  }
  if (!given)
  {
    array = { how == "clouds" ? ArrayOfClouds(data) : std::string() };
    array = array.Name.empty() ? ActiveScalars(data) : array;
  }
  if (!array.Name.empty())
  {
    display->SetScalarColoring(array.Name.c_str(), array.Association);
    UseWeatherPreset(display, array.Name, data);
    display->RescaleTransferFunctionToDataRange(true, false);
  }
}

// The light of smoke that is to be white, 0 of other data. Thin smoke sends less light than clouds: in their colours it would be grey.
double LightOfSmoke(vtkPVDataInformation* data, const std::string& array)
{
  const bool isSmoke = data->GetArrayInformation("SmokeExtinction", vtkDataObject::CELL) ||
    data->GetArrayInformation("SmokeExtinction", vtkDataObject::POINT);
  vtkPVArrayInformation* light = data->GetArrayInformation(array.c_str(), vtkDataObject::POINT);
  constexpr double share = 0.7; // of the greatest, which few places have
  return isSmoke && light ? share * light->GetComponentFiniteRange(0)[1] : 0.0;
}

bool IsUsedByOthers(vtkSMProxy* colors, vtkSMProxy* display)
{
  for (unsigned int i = 0; i < colors->GetNumberOfConsumers(); ++i)
  {
    vtkSMProxy* consumer = colors->GetConsumerProxy(i); // null: deleted
    vtkSMProxy* user = consumer ? consumer->GetTrueParentProxy() : nullptr;
    if (user && user != display && user->IsA("vtkSMPVRepresentationProxy") &&
      vtkSMPropertyHelper(user, "Visibility", true).GetAsInt())
    {
      return true;
    }
  }
  return false;
}

// The colours of a preset that is in the unit of its array: its range stays, except that smoke alone in its view reaches white.
void ColorByPreset(
  vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port, const char* preset)
{
  const ColoredArray array = ActiveScalars(source->GetDataInformation(port));
  display->SetScalarColoring(array.Name.c_str(), array.Association); // it is, but has no colors yet
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable", true).GetAsProxy();
  if (colors && vtkSMTransferFunctionPresets::GetInstance()->HasPreset(preset))
  {
    vtkSMTransferFunctionProxy::ApplyPreset(colors, preset, false);
    const double light = LightOfSmoke(source->GetDataInformation(port), array.Name);
    double range[2] = { 0.0, 0.0 };
    if (light > 0.0 && !IsUsedByOthers(colors, display) &&
      vtkSMTransferFunctionProxy::GetRange(colors, range) && light < range[1])
    {
      vtkSMTransferFunctionProxy::RescaleTransferFunction(colors, range[0], light);
    }
    vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode", true)
      .Set(vtkSMTransferFunctionManager::NEVER);
    colors->UpdateVTKObjects();
  }
}

// The hint of the source for one of its ports.
vtkPVXMLElement* FindHint(vtkSMProxy* source, int port, const std::string& name)
{
  vtkPVXMLElement* hints = source->GetHints();
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(i);
    int itsPort = port;
    hint->GetScalarAttribute("port", &itsPort);
    if (name == hint->GetName() && itsPort == port)
    {
      return hint;
    }
  }
  return nullptr;
}

bool IsEmpty(vtkSMSourceProxy* source, int port)
{
  vtkPVDataInformation* data = source->GetDataInformation(port);
  return data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0;
}

// One level of a grid, or polygons: a volume would draw nothing.
bool IsSheet(vtkPVDataInformation* data)
{
  const int* extent = data->GetExtent();
  return data->DataSetTypeIsA("vtkPolyData") ||
    (data->DataSetTypeIsA("vtkStructuredGrid") &&
      (extent[0] == extent[1] || extent[2] == extent[3] || extent[4] == extent[5]));
}

void PrepareDisplay(vtkSMPVRepresentationProxy* display);

// Waits for the first data of a source whose Apply has failed, and then gives its display the looks of a first one, if nobody else has.
class FirstData
{
public:
  FirstData(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port)
    : Display(display)
    , Source(source)
    , Port(port)
    , Type(vtkSMPropertyHelper(display, "Representation", true).GetAsString())
  {
    this->Observe(source, &FirstData::OnData);
  }

private:
  void Observe(vtkSMProxy* proxy, void (FirstData::*onUpdate)(vtkObject*, unsigned long, void*))
  {
    this->Observed = proxy;
    this->Tag = proxy->AddObserver(vtkCommand::UpdateDataEvent, this, onUpdate);
    this->End = proxy->AddObserver(vtkCommand::DeleteEvent, this, &FirstData::OnDelete);
  }

  void Ignore()
  {
    this->Observed->RemoveObserver(this->End);
    this->Observed->RemoveObserver(this->Tag);
  }

  // The view is in the midst of an update: what is changed now it would draw without one.
  void OnData(vtkObject*, unsigned long, void*)
  {
    if (this->Display && IsEmpty(this->Source, this->Port))
    {
      return;
    }
    this->Ignore();
    vtkSMViewProxy* view = this->Display ? vtkSMViewProxy::FindView(this->Display) : nullptr;
    if (view)
    {
      this->Observe(view, &FirstData::OnView);
      return;
    }
    this->Prepare();
    delete this;
  }

  void OnView(vtkObject* caller, unsigned long, void*)
  {
    this->Ignore();
    this->Prepare();
    vtkSMViewProxy::SafeDownCast(caller)->Update();
    delete this;
  }

  void OnDelete(vtkObject*, unsigned long, void*) { delete this; }

  void Prepare()
  {
    if (this->Display && this->Source &&
      this->Type == vtkSMPropertyHelper(this->Display, "Representation", true).GetAsString())
    {
      vtkPVXMLElement* hint = FindHint(this->Source, this->Port, "RepresentationType");
      this->Display->SetRepresentationType(
        hint ? hint->GetAttributeOrEmpty("type") : this->Type.c_str());
      PrepareDisplay(this->Display);
    }
  }

  vtkWeakPointer<vtkSMPVRepresentationProxy> Display;
  vtkWeakPointer<vtkSMSourceProxy> Source;
  vtkWeakPointer<vtkSMProxy> Observed;
  int Port;
  std::string Type;
  unsigned long Tag = 0;
  unsigned long End = 0;
};

void PrepareDisplay(vtkSMPVRepresentationProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  const int port = source ? static_cast<int>(input.GetOutputPort()) : 0;
  vtkPVXMLElement* hint = source ? FindHint(source, port, "NephoscopeFirstLook") : nullptr;
  if (hint && IsEmpty(source, port))
  {
    new FirstData(display, source, port); // deletes itself
  }
  else if (hint)
  {
    if (std::string(hint->GetAttributeOrEmpty("sheet")) == "Surface" &&
      IsSheet(source->GetDataInformation(port)))
    {
      display->SetRepresentationType("Surface");
    }
    Color(display, source, port, hint->GetAttributeOrDefault("color", "active"));
    if (const char* preset = hint->GetAttribute("preset"))
    {
      ColorByPreset(display, source, port, preset);
    }
    display->UpdateVTKObjects();
    nephoscope::resetCameraWhereShown(display);
  }
}

// As ParaView does for Volume: a medium of one colour says nothing about its data.
void OnDisplayProperty(vtkObject* caller, unsigned long, void*, void* data)
{
  auto* display = vtkSMPVRepresentationProxy::SafeDownCast(caller);
  const char* property =
    static_cast<const char*>(data); // null for those of displays inside this one
  if (!display || !property || std::string(property) != "Representation" ||
    display->GetUsingScalarColoring() || display->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  const std::string type = vtkSMPropertyHelper(display, "Representation", true).GetAsString();
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  if (source && (type == "Cell Compositing" || type == "Textured Splats"))
  {
    Color(display, source, static_cast<int>(input.GetOutputPort()), "active");
  }
}

void PrepareOpacities(vtkSMProxy* opacities, const std::string& registeredAs)
{
  const std::string array =
    registeredAs.substr(0, registeredAs.rfind('.')); // without ".PiecewiseFunction"
  const std::string preset = PresetOf(array);
  const bool saved =
    vtkSMSettings::GetInstance()->HasSetting((".array_lookup_tables." + array).c_str());
  auto* presets = vtkSMTransferFunctionPresets::GetInstance();
  if (!saved && preset.compare(0, ourPresets.size(), ourPresets) == 0 &&
    presets->HasPreset(preset.c_str()))
  {
    vtkSMTransferFunctionProxy::ApplyPreset(opacities, preset.c_str(), false);
  }
}

void OnRegistered(vtkObject*, unsigned long, void*, void* data)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  vtkSMProxy* proxy = registered ? registered->Proxy : nullptr;
  if (proxy && registered->GroupName && std::string(registered->GroupName) == "views")
  {
    nephoscope::drawPolygonsOfWidgets(proxy);
    vtkRankMessages::Follow(proxy);
    return;
  }
  if (proxy)
  {
    nephoscope::keepValuesInDomains(proxy);
    if (nephoscope::isOfSuite(proxy->GetVTKClassName()) && vtkSMSourceProxy::SafeDownCast(proxy))
    {
      vtkRankMessages::Follow(proxy);
    }
  }
  if (!proxy || !registered->GroupName || !registered->ProxyName ||
    proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  if (auto* display = vtkSMPVRepresentationProxy::SafeDownCast(proxy))
  {
    PrepareDisplay(display);
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(OnDisplayProperty);
    display->AddObserver(vtkCommand::PropertyModifiedEvent, command);
  }
  else if (std::string(registered->GroupName) == "sources")
  {
    nephoscope::connectToSun(proxy);
  }
  else if (std::string(registered->GroupName) == "piecewise_functions")
  {
    PrepareOpacities(proxy, registered->ProxyName);
  }
}
}

void vtkSMFirstLook::Load()
{
  static bool isLoaded = false;
  if (!isLoaded && vtkSMProxyManager::IsInitialized())
  {
    isLoaded = true;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(OnRegistered);
    vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
  }
}
