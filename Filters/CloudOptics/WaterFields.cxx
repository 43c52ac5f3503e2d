// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WaterFields.h"

#include "ArrayNames.h"
#include "FieldUnits.h"
#include "LowerCase.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace nephoscope
{
namespace
{
struct NamesOfModels
{
  const char* Words;
  const char* Property;
  std::vector<const char*> Names;
};

const NamesOfModels& NamesOf(WaterFields::Kind kind)
{
  static const std::array<NamesOfModels, WaterFields::NumberOfFields> names = { {
    { "cloud water", "TotalWaterArrayName", { "clwmr", "tot_qc_dia", "CLDWAT", "QN" } },
    { "cloud liquid", "LiquidArrayName",
      { "clwc", "clw", "qc", "ql", "q_l", "cloud_liquid", "QCLOUD", "LWC", "cldliq",
        "cloud_mixing_ratio", "specific_cloud_liquid_water_content" } },
    { "cloud ice", "IceArrayName",
      { "ciwc", "cli", "qi", "q_i", "cloud_ice", "icmr", "QICE", "IWC", "cldice",
        "ice_water_mixing_ratio", "specific_cloud_ice_water_content" } },
    { "rain", "RainArrayName",
      { "crwc", "rwmr", "qr", "QRAIN", "rain_mixing_ratio", "specific_rain_water_content" } },
    { "snow", "SnowArrayName",
      { "cswc", "snmr", "qs", "QSNOW", "snow_mixing_ratio", "specific_snow_water_content" } },
    { "temperature", "TemperatureArrayName",
      { "t", "ta", "tk", "tmp", "temp", "TABS", "temperature", "air_temperature" } },
    { "pressure", "PressureArrayName", { "p", "pressure", "pres", "pfull", "air_pressure" } },
    { "cloud fraction", "CloudFractionArrayName",
      { "cloud_fraction", "cc", "cl", "clc", "CLDFRA" } },
    { "land fraction", "LandArrayName", { "lsm", "land", "sftlf", "LANDMASK", "fr_land" } },
    { "height", "HeightArrayName", { "Height", "gh", "zg" } },
  } };
  return names[kind];
}

vtkDataArray* ArrayOf(vtkDataSet* data, bool onCells, const std::string& name)
{
  vtkDataSetAttributes* attributes =
    onCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  return attributes->GetArray(name.c_str());
}

// By the exact name, otherwise by a name in other case, as models spell it: QC of COSMO.
vtkDataArray* FirstOf(vtkDataSet* data, bool onCells, WaterFields::Kind kind)
{
  for (const char* name : NamesOf(kind).Names)
  {
    if (vtkDataArray* array = ArrayOf(data, onCells, name))
    {
      return array;
    }
  }
  vtkDataSetAttributes* attributes =
    onCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  for (const char* name : NamesOf(kind).Names)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() &&
        nephoscope::LowerCase(array->GetName()) == nephoscope::LowerCase(name))
      {
        return array;
      }
    }
  }
  return nullptr;
}

std::string AllArrays(vtkDataSet* data)
{
  return "Point arrays: " + QuotedArrayNames(data->GetPointData()) +
    "; cell arrays: " + QuotedArrayNames(data->GetCellData()) + ".";
}

using Kind = WaterFields::Kind;

void Take(vtkDataSet* data, const FieldNames& names, WaterFields& fields)
{
  for (int k = 0; k < WaterFields::NumberOfFields; ++k)
  {
    const auto kind = static_cast<Kind>(k);
    fields.Arrays[k] = names[k] == "none" ? nullptr
      : names[k].empty()                  ? FirstOf(data, fields.OnCells, kind)
                                          : ArrayOf(data, fields.OnCells, names[k]);
  }
  // GFS uses the same name for the liquid that it used for the sum before it had ice.
  vtkDataArray* total = fields.Arrays[WaterFields::Total];
  if (names[WaterFields::Total].empty() && names[WaterFields::Liquid].empty() && total &&
    nephoscope::LowerCase(total->GetName()) == "clwmr" && fields.Has(WaterFields::Ice) &&
    !fields.Has(WaterFields::Liquid))
  {
    fields.Arrays[WaterFields::Liquid] = total;
  }
  // A sum beside its parts would count twice, unless it has been named.
  if (names[WaterFields::Total].empty() &&
    (fields.Has(WaterFields::Liquid) || fields.Has(WaterFields::Ice)))
  {
    fields.Arrays[WaterFields::Total] = nullptr;
  }
}

bool HasWater(const WaterFields& fields)
{
  return fields.Has(WaterFields::Total) || fields.Has(WaterFields::Liquid) ||
    fields.Has(WaterFields::Ice) || fields.Has(WaterFields::Rain) || fields.Has(WaterFields::Snow);
}

// At points, or otherwise at cells.
void TakeWhereWaterIs(vtkDataSet* data, const FieldNames& names, WaterFields& fields)
{
  Take(data, names, fields);
  if (!HasWater(fields))
  {
    WaterFields onCells;
    onCells.OnCells = true;
    Take(data, names, onCells);
    fields = HasWater(onCells) ? onCells : fields;
  }
}

// Named by the user, but not there.
std::string MissingNames(const FieldNames& names, const WaterFields& fields)
{
  std::string text;
  for (int k = 0; k < WaterFields::NumberOfFields; ++k)
  {
    if (!names[k].empty() && names[k] != "none" && !fields.Arrays[k])
    {
      text += "There is no " + std::string(fields.OnCells ? "cell" : "point") + " array '" +
        names[k] + "' of the " + WordsFor(static_cast<Kind>(k)) + ", as " +
        NamesOf(static_cast<Kind>(k)).Property + " says. ";
    }
  }
  return text;
}

bool IsNamed(const FieldNames& names, Kind kind)
{
  return !names[kind].empty() && names[kind] != "none";
}

// "separate ice from liquid and to compute the density of the air"; empty if the water needs no
// temperature.
std::string PurposesOfTemperature(const WaterFields& fields, bool water, bool pressure)
{
  std::string text = !water || fields.Has(WaterFields::Total) ? "separate ice from liquid"
    : fields.Has(WaterFields::Ice)                            ? "find the size of ice crystals"
                                                              : "";
  text += !text.empty() && pressure ? " and to " : "";
  return pressure ? text + "compute the density of the air" : text;
}

// All that is missing, so that it can be set at once. Without water, what most water needs.
std::string Missing(
  vtkDataSet* data, const FieldNames& names, WaterUnits units, const WaterFields& fields)
{
  const bool water = HasWater(fields);
  const bool pressure =
    water ? fields.NeedsPressure() : units == WaterUnits::Automatic || IsMixingRatio(units);
  const std::string purposes = PurposesOfTemperature(fields, water, pressure);
  std::string text = MissingNames(names, fields);
  if (!water && text.empty())
  {
    text +=
      "There is no array of cloud water: set TotalWaterArrayName, or LiquidArrayName and IceArrayName. ";
  }
  if (!purposes.empty() && !fields.Has(WaterFields::Temperature) &&
    !IsNamed(names, WaterFields::Temperature))
  {
    text += "There is no temperature, which is needed to " + purposes +
      ": set TemperatureArrayName (K). ";
  }
  if (pressure && !fields.Has(WaterFields::Pressure) && !fields.Has(WaterFields::Height) &&
    !IsNamed(names, WaterFields::Pressure))
  {
    text +=
      "There is no pressure, which is needed to convert water from kg/kg to kg/m3: set PressureArrayName (Pa or hPa), or HeightArrayName (m) for the "
      "pressure of the standard atmosphere, which Globe Grid adds to its output, or set WaterUnits to kg/m3 or g/m3, if that is what they are. ";
  }
  return text.empty() ? text : text + AllArrays(data);
}

std::string WrongShape(vtkDataSet* data, const WaterFields& fields)
{
  const vtkIdType count = fields.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  for (vtkDataArray* array : fields.Arrays)
  {
    if (array && (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count))
    {
      return "The array '" + std::string(array->GetName()) + "' has " +
        std::to_string(array->GetNumberOfTuples()) + " values of " +
        std::to_string(array->GetNumberOfComponents()) + " components; it must have " +
        std::to_string(count) + " of one.";
    }
  }
  return std::string();
}

WaterUnits UnitsOfField(vtkDataSet* data, vtkDataArray* array)
{
  const WaterUnits told = WaterUnitsOf(UnitsOf(data->GetFieldData(), array->GetName()));
  const std::string name = nephoscope::LowerCase(array->GetName());
  const bool isContent = name == "lwc" || name == "iwc";
  return told != WaterUnits::Automatic ? told
    : isContent                        ? WaterUnits::Content
                                       : WaterUnits::MixingRatio;
}

bool IsCelsius(const std::string& text)
{
  const char* words[] = { "c", "degc", "degreec", "degreesc", "deg_c", "degree_c", "degrees_c",
    "celsius", "degcelsius", "deg_celsius", "degreecelsius", "degreescelsius", "degree_celsius",
    "degrees_celsius", "°c" };
  return std::find(std::begin(words), std::end(words), text) != std::end(words);
}

double SummandToKelvin(vtkDataSet* data, vtkDataArray* temperature)
{
  return temperature && IsCelsius(UnitsOf(data->GetFieldData(), temperature->GetName())) ? 273.15
                                                                                         : 0.0;
}

double GreatestOf(vtkDataArray* array)
{
  double range[2] = { 0, 0 };
  array->GetFiniteRange(range, 0);
  return range[1] < 1e20 ? range[1] : 0;
}

// Percent, by the units or by values that no fraction has.
double ToFraction(vtkDataSet* data, vtkDataArray* array)
{
  const std::string units = array ? UnitsOf(data->GetFieldData(), array->GetName()) : std::string();
  return array && (units == "%" || units == "percent" || GreatestOf(array) > 1.5) ? 0.01 : 1.0;
}

// Without units, by the size of values: clouds are below 120 hPa of height, where kPa are less than
// 120, and hPa than 2000.
double FactorToPascal(vtkDataSet* data, vtkDataArray* array)
{
  const std::string units = array ? UnitsOf(data->GetFieldData(), array->GetName()) : std::string();
  const double greatest = array ? GreatestOf(array) : 0;
  if (units == "pa")
  {
    return 1.0;
  }
  if (units == "hpa" || units == "mb" || units == "mbar" || units == "millibars")
  {
    return 100.0;
  }
  return greatest <= 0 ? 1.0 : greatest < 120 ? 1000.0 : greatest < 2000 ? 100.0 : 1.0;
}

// What could not be: the sum of all water in a cloud is below 20 g/kg, and no air as cold as 130 K.
std::string WrongUnits(const WaterFields& fields)
{
  vtkDataArray* temperature = fields.Arrays[WaterFields::Temperature];
  double celsius[2] = { 0, 1000 };
  if (temperature)
  {
    temperature->GetFiniteRange(celsius, 0);
  }
  if (celsius[1] + fields.ToKelvin < 130 && (celsius[0] < celsius[1] || celsius[1] != 0))
  {
    return "The array '" + std::string(temperature->GetName()) + "' has values up to " +
      std::to_string(celsius[1]) +
      ", which is too cold for a temperature in kelvin. Add 273.15, if it is in degrees Celsius.";
  }
  for (int k = 0; k < WaterFields::NumberOfWaters; ++k)
  {
    double range[2] = { 0, 0 };
    if (fields.Arrays[k])
    {
      fields.Arrays[k]->GetFiniteRange(range, 0);
    }
    if (range[1] * KilogramsPer(fields.Units[k]) > 0.03 && range[1] < 1e20)
    {
      return "The array '" + std::string(fields.Arrays[k]->GetName()) + "' has values up to " +
        std::to_string(range[1]) + ", which is too much " + WordsFor(static_cast<Kind>(k)) +
        " for kg/kg or kg/m3. Set WaterUnits to g/kg or g/m3, if that is what they are.";
    }
  }
  return std::string();
}
}

bool WaterFields::NeedsPressure() const
{
  for (int k = 0; k < NumberOfWaters; ++k)
  {
    if (this->Arrays[k] && IsMixingRatio(this->Units[k]))
    {
      return true;
    }
  }
  return false;
}

const char* WordsFor(WaterFields::Kind kind)
{
  return NamesOf(kind).Words;
}

bool HasCloudWater(vtkDataSet* data, const FieldNames& names)
{
  WaterFields fields;
  TakeWhereWaterIs(data, names, fields);
  return HasWater(fields);
}

std::string FindWaterFields(
  vtkDataSet* data, const FieldNames& names, WaterUnits units, WaterFields& fields)
{
  TakeWhereWaterIs(data, names, fields);
  for (int k = 0; k < WaterFields::NumberOfWaters; ++k)
  {
    fields.Units[k] = units == WaterUnits::Automatic && fields.Arrays[k]
      ? UnitsOfField(data, fields.Arrays[k])
      : units;
  }
  fields.ToKelvin = SummandToKelvin(data, fields.Arrays[WaterFields::Temperature]);
  fields.ToPascal = FactorToPascal(data, fields.Arrays[WaterFields::Pressure]);
  fields.ToCover = ToFraction(data, fields.Arrays[WaterFields::CloudFraction]);
  fields.ToLand = ToFraction(data, fields.Arrays[WaterFields::Land]);
  const std::string problem = Missing(data, names, units, fields);
  const std::string shape = problem.empty() ? WrongShape(data, fields) : problem;
  return shape.empty() ? WrongUnits(fields) : shape;
}
}
