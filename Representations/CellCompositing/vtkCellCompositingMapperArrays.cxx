// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which arrays of its input vtkCellCompositingMapper reads, and what it says of those that cannot be drawn.
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellGeometry.h"
#include "ContourSettings.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#if __has_include("vtkCellTypeUtilities.h") // VTK 9.6 deprecates the name lookup of vtkCellTypes
#include "vtkCellTypeUtilities.h"
using CellTypeNames = vtkCellTypeUtilities;
#else
#include "vtkCellTypes.h"
using CellTypeNames = vtkCellTypes;
#endif

using nephoscope::arrayNames;
using nephoscope::CellGeometry;
using nephoscope::checkLength;
using nephoscope::ScalarSelection;

namespace
{
std::string remedy(vtkDataSet* input)
{
  return " Choose an array with SelectScalarArray and SetScalarMode; point arrays: " +
    arrayNames(input->GetPointData()) + "; cell arrays: " + arrayNames(input->GetCellData()) + ".";
}

std::string missingArray(const char* association, const char* name, vtkDataSet* input)
{
  return std::string("No ") + association + " array named '" + (name ? name : "") + "'." + remedy(input);
}
}

std::string vtkCellCompositingMapper::SelectScalars(
  vtkDataSet* input, vtkVolumeProperty* property, ScalarSelection& scalars)
{
  int cellFlag = 0;
  scalars.Array = vtkAbstractMapper::GetScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  scalars.OnCells = cellFlag == 1;
  vtkScalarsToColors* colors = property->GetColorChannels() == 3 ? property->GetRGBTransferFunction() : nullptr;
  const bool magnitude = colors && colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE;
  scalars.Component = magnitude ? -1 : colors ? colors->GetVectorComponent() : 0;
  if (!scalars.Array)
  {
    const bool cells = this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
    const bool named = this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME &&
      (cells || this->ScalarMode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    return named ? missingArray(cells ? "cell" : "point", this->ArrayName, input)
                 : "The input has no active scalars." + remedy(input);
  }
  return cellFlag > 1 ? "Field data cannot be drawn." + remedy(input) : checkLength(input, scalars);
}

std::string vtkCellCompositingMapper::SelectOpacity(
  vtkDataSet* input, const ScalarSelection& scalars, ScalarSelection& opacity)
{
  if (this->OpacityArrayName.empty())
  {
    return std::string();
  }
  // The association of the colour array first.
  vtkFieldData* data[2] = { input->GetPointData(), input->GetCellData() };
  for (const bool onCells : { scalars.OnCells, !scalars.OnCells })
  {
    opacity.Array = data[onCells]->GetArray(this->OpacityArrayName.c_str());
    opacity.OnCells = onCells;
    if (opacity.Array)
    {
      return checkLength(input, opacity);
    }
  }
  return missingArray("point or cell", this->OpacityArrayName.c_str(), input);
}

std::string vtkCellCompositingMapper::SelectContours(vtkDataSet* input, ScalarSelection& contoured)
{
  contoured = {};
  const std::string& name = this->Contours->ArrayName;
  if (this->Contours->Surfaces.empty() || name.empty())
  {
    return std::string();
  }
  contoured.Array = input->GetPointData()->GetArray(name.c_str());
  if (!contoured.Array)
  {
    const bool onCells = input->GetCellData()->GetArray(name.c_str()) != nullptr;
    return "No point array named '" + name + "' to contour" +
      (onCells ? "; a cell array has no surfaces inside its cells: apply Cell Data to Point Data. " : ". ") +
      "Point arrays: " + arrayNames(input->GetPointData()) + ".";
  }
  return checkLength(input, contoured);
}

std::string vtkCellCompositingMapper::SelectLayers(vtkDataSet* input, vtkDataArray*& layers)
{
  layers = nullptr;
  const std::string& name = this->Contours->LayerArrayName;
  if (name.empty() || this->Contours->LayerProperties.empty())
  {
    return std::string();
  }
  layers = input->GetCellData()->GetArray(name.c_str());
  if (!layers)
  {
    return "No cell array named '" + name + "' for the layers. Cell arrays: " + arrayNames(input->GetCellData()) + ".";
  }
  return checkLength(input, { layers, true, 0 });
}

void vtkCellCompositingMapper::WarnAboutGeometry(
  const CellGeometry& geometry, const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  const auto quoted = [](vtkDataArray* array) {
    return std::string("'") + (array->GetName() ? array->GetName() : "(unnamed)") + "'";
  };
  const std::string names = quoted(scalars.Array) + (opacity.Array ? ", " + quoted(opacity.Array) : "");

  if (geometry.NumberOfInvalidCells > 0)
  {
    vtkWarningMacro(<< geometry.NumberOfInvalidCells << " cells are not drawn because array "
                    << names << " or a coordinate is not finite there. Blank such points, or replace the values.");
  }
  if (geometry.NumberOfUnsupportedCells > 0)
  {
    const char* type = CellTypeNames::GetClassNameFromTypeId(geometry.UnsupportedCellType);
    vtkWarningMacro(<< geometry.NumberOfUnsupportedCells << " cells are not drawn (" << type
                    << ", for example): only 3-D cells can be composited.");
  }
  if (geometry.NumberOfNonConvexCells > 0)
  {
    vtkWarningMacro(<< geometry.NumberOfNonConvexCells
                    << (geometry.NumberOfNonConvexCells == 1 ? " polyhedron is" : " polyhedra are")
                    << " not convex and drawn wrong: run vtkPolyhedronToTetrahedra first.");
  }
}
