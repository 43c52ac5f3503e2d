// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArraySelection.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <sstream>

namespace nephoscope
{
namespace
{
std::string Remedy(vtkDataSet* input)
{
  return " Choose an array with SelectScalarArray and SetScalarMode; point arrays: " +
    NamesOfArrays(input->GetPointData()) + "; cell arrays: " + NamesOfArrays(input->GetCellData()) +
    ".";
}

std::string MissingArray(const char* association, const char* name, vtkDataSet* input)
{
  return std::string("No ") + association + " array named '" + (name ? name : "") + "'." +
    Remedy(input);
}
}

std::string CheckLength(vtkDataSet* input, const ScalarSelection& scalars)
{
  const vtkIdType expected =
    scalars.OnCells ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  const vtkIdType found = scalars.Array->GetNumberOfTuples();
  if (found == expected)
  {
    return std::string();
  }
  const char* name = scalars.Array->GetName();
  return std::string("Array '") + (name ? name : "(unnamed)") + "' has " + std::to_string(found) +
    " values where the input has " + std::to_string(expected) +
    (scalars.OnCells ? " cells." : " points.");
}

std::string SelectScalars(vtkAbstractVolumeMapper* mapper, vtkDataSet* input,
  vtkVolumeProperty* property, ScalarSelection& scalars)
{
  const int mode = mapper->GetScalarMode();
  int cellFlag = 0;
  scalars.Array = vtkAbstractMapper::GetScalars(input, mode, mapper->GetArrayAccessMode(),
    mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  scalars.OnCells = cellFlag == 1;
  vtkScalarsToColors* colors =
    property->GetColorChannels() == 3 ? property->GetRGBTransferFunction() : nullptr;
  const bool magnitude = colors && colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE;
  scalars.Component = magnitude ? -1 : colors ? colors->GetVectorComponent() : 0;
  if (!scalars.Array)
  {
    const bool cells = mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
    const bool named = mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME &&
      (cells || mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    return named ? MissingArray(cells ? "cell" : "point", mapper->GetArrayName(), input)
                 : "The input has no active scalars." + Remedy(input);
  }
  return cellFlag > 1 ? "Field data cannot be drawn." + Remedy(input) : CheckLength(input, scalars);
}

std::string SelectOpacity(const std::string& name, vtkDataSet* input,
  const ScalarSelection& scalars, ScalarSelection& opacity)
{
  if (name.empty())
  {
    return std::string();
  }
  // The association of the colour array first.
  bool isText = false;
  vtkFieldData* data[2] = { input->GetPointData(), input->GetCellData() };
  for (const bool onCells : { scalars.OnCells, !scalars.OnCells })
  {
    opacity.Array = data[onCells]->GetArray(name.c_str());
    opacity.OnCells = onCells;
    if (opacity.Array)
    {
      return CheckLength(input, opacity);
    }
    isText = isText || data[onCells]->GetAbstractArray(name.c_str());
  }
  return (isText ? "The opacity array '" + name + "' holds text, no numbers."
                 : "No point or cell array named '" + name + "' for the opacity.") +
    " Choose another OpacityArrayName; point arrays: " + NamesOfArrays(input->GetPointData()) +
    "; cell arrays: " + NamesOfArrays(input->GetCellData()) + ".";
}

ScalarSelection SelectOpaque(vtkAbstractVolumeMapper* mapper, vtkDataSet* input,
  vtkVolumeProperty* property, const std::string& name, ScalarSelection& scalars)
{
  ScalarSelection opacity;
  if (!input || !property || !SelectScalars(mapper, input, property, scalars).empty() ||
    !SelectOpacity(name, input, scalars, opacity).empty())
  {
    return {};
  }
  return opacity.Array ? opacity : scalars;
}

std::string CheckIsDataSet(vtkDataObject* input)
{
  if (!input || input->IsA("vtkDataSet"))
  {
    return std::string();
  }
  const std::string kind = input->GetClassName();
  const std::string remedy = input->IsA("vtkCompositeDataSet")
    ? "Make one dataset of its blocks first: add each of them to a vtkAppendFilter (AddInputData)."
    : input->IsA("vtkHyperTreeGrid") ? "Apply vtkHyperTreeGridToUnstructuredGrid first."
                                     : "Apply a filter that makes a dataset of it first.";
  return "The input is a " + kind + "; one dataset is needed. " + remedy;
}

std::string CheckUnitDistance(vtkVolumeProperty* property)
{
  return property->GetScalarOpacityUnitDistance() > 0
    ? std::string()
    : "ScalarOpacityUnitDistance must be positive: it is the length over which an opacity function of 1 "
      "gives an optical depth of 1.";
}

std::string CheckLengths(vtkDataSet* input, double largest)
{
  const double length = input->GetLength();
  if (!(length > largest) || !std::isfinite(length))
  {
    return std::string();
  }
  std::ostringstream message;
  message
    << "The data are " << length
    << " long, too long for the single precision of graphics cards. Choose a larger unit, so that they are at most "
    << largest << " long.";
  return message.str();
}

} // namespace nephoscope
