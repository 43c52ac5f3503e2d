// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_FieldUnits_h
#define nephoscope_FieldUnits_h

#include "HeightUnits.h"

#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <string>

namespace nephoscope
{
// The CF reader writes the units of variable x into the field data array x_units. Empty if there is
// none.
inline std::string UnitsOf(vtkFieldData* fieldData, const std::string& name)
{
  auto* units = fieldData
    ? vtkStringArray::SafeDownCast(fieldData->GetAbstractArray((name + "_units").c_str()))
    : nullptr;
  return PlainUnits(units && units->GetNumberOfValues() > 0 ? units->GetValue(0) : std::string());
}
}

#endif
