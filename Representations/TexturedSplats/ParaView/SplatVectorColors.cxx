// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatVectorColors.h"

#include "DataBlocks.h"
#include "RankMeasures.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

namespace nephoscope
{
namespace
{
const char* const rangeName = "NephoscopeVectorColorRange";
}

void StoreVectorColorRange(vtkDataSet* data, bool onCells, const std::string& array)
{
  double range[2] = { 1.0, -1.0 }; // empty
  vtkDataArray* values = array.empty()
    ? nullptr
    : data->GetAttributes(onCells ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(array.c_str());
  if (values && values->GetNumberOfTuples() > 0)
  {
    FindFiniteRange(values, range);
  }
  ReduceRange(range);
  const bool found = range[0] <= range[1];
  StoreNumbers(data, rangeName, { found ? range[0] : 0.0, found ? range[1] : 1.0 });
}

vtkColorTransferFunction* DefaultVectorColors::Over(vtkDataSet* data)
{
  vtkDataArray* stored = data->GetFieldData()->GetArray(rangeName);
  std::array<double, 2> range{ { 0.0, 1.0 } };
  if (stored && stored->GetNumberOfTuples() >= 2)
  {
    range = { { stored->GetComponent(0, 0), stored->GetComponent(1, 0) } };
  }
  if (range != this->Range)
  {
    this->Range = range;
    this->Function->RemoveAllPoints();
    this->Function->SetColorSpaceToDiverging();
    this->Function->AddRGBPoint(range[0], 0.231373, 0.298039, 0.752941);
    this->Function->AddRGBPoint(
      range[1] > range[0] ? range[1] : range[0] + 1.0, 0.705882, 0.0156863, 0.14902);
  }
  return this->Function;
}

} // namespace nephoscope
