// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The unit distance that makes cells visible, whatever their size and number.
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellMeasures.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkVolumeProperty.h"

double vtkCellCompositingMapper::FindUnitDistance(vtkVolumeProperty* property)
{
  vtkDataSet* input = this->GetDataSetInput();
  nephoscope::ScalarSelection scalars;
  const nephoscope::ScalarSelection read =
    nephoscope::SelectOpaque(this, input, property, this->OpacityArrayName, scalars);
  if (!read.Array)
  {
    return 0.0;
  }
  const nephoscope::CellMedium medium{ read.Array, read.OnCells,
    nephoscope::FullOpacity(property->GetScalarOpacity()) };
  const nephoscope::MediumBounds bounds = nephoscope::RobustBoundsOfCells(input);
  return nephoscope::DefaultUnitDistance(
    nephoscope::MeasureCells(input, medium, bounds), bounds, false);
}
