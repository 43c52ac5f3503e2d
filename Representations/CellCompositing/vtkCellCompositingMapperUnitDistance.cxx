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
  nephoscope::ScalarSelection scalars, opacity;
  if (!input || !property || !nephoscope::selectScalars(this, input, property, scalars).empty() ||
    !nephoscope::selectOpacity(this->OpacityArrayName, input, scalars, opacity).empty())
  {
    return 0.0;
  }
  const nephoscope::ScalarSelection& read = opacity.Array ? opacity : scalars;
  const nephoscope::CellMedium medium{ read.Array, read.OnCells,
    nephoscope::fullOpacity(property->GetScalarOpacity()) };
  const nephoscope::MediumBounds bounds = nephoscope::robustBoundsOfCells(input);
  return nephoscope::defaultUnitDistance(
    nephoscope::measureCells(input, medium, bounds), bounds, false);
}
