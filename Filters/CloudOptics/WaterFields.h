// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a dataset that the optics of clouds need, found by name.
#ifndef nephoscope_WaterFields_h
#define nephoscope_WaterFields_h

#include "WaterUnits.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

#include <array>
#include <string>

namespace nephoscope
{
struct WaterFields
{
  enum Kind
  {
    Total,
    Liquid,
    Ice,
    Rain,
    Snow,
    NumberOfWaters,
    Temperature = NumberOfWaters,
    Pressure,
    CloudFraction,
    Land,
    Height,
    NumberOfFields
  };

  std::array<vtkDataArray*, NumberOfFields> Arrays{};
  std::array<WaterUnits, NumberOfWaters> Units{};
  double ToKelvin = 0;                          // added to temperatures: 273.15 for degrees Celsius
  double ToPascal = 1, ToCover = 1, ToLand = 1; // factors of pressures, of cloud and land fractions
  bool OnCells = false;

  bool Has(Kind kind) const { return this->Arrays[kind] != nullptr; }
  double Value(Kind kind, vtkIdType i) const { return this->Arrays[kind]->GetComponent(i, 0); }
  double Kelvin(vtkIdType i) const { return this->Value(Temperature, i) + this->ToKelvin; }
  bool NeedsPressure() const;
};

/**
 * Names that the user has given: empty, the array is found by the names that models use; "none", it
 * is left out.
 */
using FieldNames = std::array<std::string, WaterFields::NumberOfFields>;

/** Fills `fields`; returns the problem and its remedy, or an empty string. */
std::string FindWaterFields(
  vtkDataSet* data, const FieldNames& names, WaterUnits units, WaterFields& fields);

/** Whether there is any water, at points or at cells. */
bool HasCloudWater(vtkDataSet* data, const FieldNames& names);

/** The words for a field in messages. */
const char* WordsFor(WaterFields::Kind kind);
}

#endif
