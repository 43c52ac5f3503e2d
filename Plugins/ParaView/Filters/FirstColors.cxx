// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstColors.h"

#include "ColorsOfLight.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtkSMTransferFunctionProxy.h"

#include <cmath>
#include <vector>

namespace nephoscope
{
namespace
{
constexpr double bright = 0.7; // luminance
constexpr double darkSmoke[3] = { 0.35, 0.35, 0.35 };
constexpr const char* presetOfLight = "Nephoscope Sunlight";
constexpr const char* presetsOfClouds[] = { "Nephoscope Clouds", "Nephoscope Cloud Water" };

// The name of the preset that an array begins with, or an empty one.
std::string PresetOf(const std::string& array, const std::string& list = "nephoscope_presets")
{
  vtkSMSettings* settings = vtkSMSettings::GetInstance();
  const std::string key = "." + list + "." + array;
  return settings->HasSetting(key.c_str()) ? settings->GetSettingAsString(key.c_str(), 0, "")
                                           : std::string();
}

// The preset of a name that is usual elsewhere too; only for data of the weather, those of Globe
// Grid.
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

// Those that ParaView gives to any array, or those of a preset.
std::vector<double> ColorsOfAnyArray(
  vtkSMSessionProxyManager* manager, const std::string& preset = std::string())
{
  vtkNew<vtkSMTransferFunctionManager> functions;
  vtkSMProxy* any = functions->GetColorTransferFunction("NephoscopeAnyArray", manager);
  if (any && !preset.empty())
  {
    vtkSMTransferFunctionProxy::ApplyPreset(any, preset.c_str(), false);
  }
  const std::vector<double> colors = any ? ColorsOf(any) : std::vector<double>();
  manager->UnRegisterProxy(any);
  return colors;
}

// From 0 to 1 along a line, as ParaView gives them to any array.
bool AreOpacitiesOfAnyArray(vtkSMProxy* opacities)
{
  const std::vector<double> points = vtkSMPropertyHelper(opacities, "Points").GetDoubleArray();
  return points.size() == 8 && points[1] == 0.0 && points[5] == 1.0;
}

void ApplyPreset(vtkSMProxy* function, const std::string& preset)
{
  vtkSMTransferFunctionProxy::ApplyPreset(function, preset.c_str(), true); // over its range
  function->UpdateVTKObjects();
}

// Whether somebody has saved colours as those that an array begins with.
bool IsSaved(const std::string& array)
{
  return vtkSMSettings::GetInstance()->HasSetting((".array_lookup_tables." + array).c_str());
}

// Colours and opacities of the preset of an array, unless somebody has chosen others.
void UsePreset(vtkSMProxy* display, const std::string& array, vtkPVDataInformation* data)
{
  const std::string own = PresetOf(array);
  const std::string preset = own.empty() ? WeatherPresetOf(array, data) : own;
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable", true).GetAsProxy();
  vtkSMProxy* opacities = vtkSMPropertyHelper(display, "ScalarOpacityFunction", true).GetAsProxy();
  if (preset.empty() || !colors || IsSaved(array) ||
    !vtkSMTransferFunctionPresets::GetInstance()->HasPreset(preset.c_str()))
  {
    return;
  }
  vtkSMSessionProxyManager* manager = display->GetSessionProxyManager();
  if (ColorsOf(colors) == ColorsOfAnyArray(manager))
  {
    ApplyPreset(colors, preset);
  }
  if (opacities && AreOpacitiesOfAnyArray(opacities) &&
    ColorsOf(colors) == ColorsOfAnyArray(manager, preset))
  {
    ApplyPreset(opacities, preset);
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

// What a display is coloured by; without a name where it has one colour.
ColoredArray ColoredBy(vtkSMProxy* display)
{
  const vtkSMPropertyHelper colored(display, "ColorArrayName", true);
  if (colored.GetNumberOfElements() != 5 || !colored.GetInputArrayNameToProcess())
  {
    return {};
  }
  return { colored.GetInputArrayNameToProcess(), colored.GetInputArrayAssociation() };
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

// The array that a contour filter contours; an empty name for other sources, and before it had
// data.
std::string ContouredArray(vtkSMProxy* source)
{
  const vtkSMPropertyHelper contoured(source, "SelectInputScalars", true);
  const char* name = contoured.GetNumberOfElements() == 5 ? contoured.GetAsString(4) : nullptr;
  return name ? name : "";
}

// A surface at one value of an array has one colour in the colours of that array, and not the best
// one.
bool IsColoredByContouredArray(vtkSMProxy* display, vtkSMProxy* source, vtkPVDataInformation* data)
{
  const std::string contoured = ContouredArray(source);
  return ColoredBy(display).Name == (contoured.empty() ? ActiveScalars(data).Name : contoured);
}

bool HasOneValue(vtkPVDataInformation* data, const ColoredArray& array)
{
  vtkPVArrayInformation* values = data->GetArrayInformation(array.Name.c_str(), array.Association);
  const double* range =
    values && values->GetNumberOfComponents() == 1 ? values->GetComponentFiniteRange(0) : nullptr;
  return range && range[1] - range[0] <= 1e-6 * std::abs(range[1]);
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
}

void ColorFirst(
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
    UsePreset(display, ColoredBy(display).Name, data);
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
    UsePreset(display, array.Name, data);
    display->RescaleTransferFunctionToDataRange(true, false);
  }
}

void WhitenContour(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port)
{
  const ColoredArray array = ColoredBy(display);
  if (!array.Name.empty() &&
    (array.Name == ContouredArray(source) || HasOneValue(source->GetDataInformation(port), array)))
  {
    display->SetScalarColoring(nullptr, vtkDataObject::POINT);
    display->UpdateVTKObjects();
  }
}

void ColorByPreset(
  vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port, const char* preset)
{
  const ColoredArray array = ColoredBy(display);
  display->SetScalarColoring(array.Name.c_str(), array.Association); // it is, but has no colors yet
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable", true).GetAsProxy();
  if (colors && vtkSMTransferFunctionPresets::GetInstance()->HasPreset(preset))
  {
    const double white = IsUsedByOthers(colors, display)
      ? 0.0
      : LightThatIsWhite(source->GetDataInformation(port), array.Name);
    ApplyFixedPreset(colors, preset, white);
    if (white > 0.0)
    {
      FollowEyeOfLight(source, port, colors, array.Name);
    }
  }
}

void UsePresetOfArray(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port)
{
  const std::string array = ColoredBy(display).Name;
  vtkPVDataInformation* data = source->GetDataInformation(port);
  vtkSMProxy* colors = vtkSMPropertyHelper(display, "LookupTable", true).GetAsProxy();
  if (colors && array == "Sunlight" && HasLight(data) && !IsSaved(array) &&
    ColorsOf(colors) == ColorsOfAnyArray(display->GetSessionProxyManager()))
  {
    ApplyFixedPreset(colors, presetOfLight, LightThatIsWhite(data, array));
  }
  else if (!array.empty())
  {
    UsePreset(display, array, data);
  }
}

bool HasLight(vtkPVDataInformation* data)
{
  return data->GetArrayInformation("WhiteLight", vtkDataObject::FIELD) != nullptr;
}

} // namespace nephoscope
