// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Smoke in vtkCellCompositingRepresentation: opaque by its density, whatever it is coloured by.
#include "vtkCellCompositingRepresentation.h"

#include "SmokeCells.h"
#include "vtkCellCompositingMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
// Extinction is the density itself: a straight line through 0, up to the largest density there is.
void followDensity(vtkPiecewiseFunction* opacity, double largest)
{
  if (opacity->GetSize() != 2 || opacity->GetRange()[1] != largest)
  {
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(largest, largest);
  }
}
}

bool vtkCellCompositingRepresentation::DrawsSmoke(vtkDataSet* cells) const
{
  return this->GetOpacityArrayName().empty() && nephoscope::smokeDensity(cells) != nullptr;
}

void vtkCellCompositingRepresentation::PrepareOpacity(vtkDataSet* cells)
{
  this->Mapper->SetOpacityArrayName(this->GetOpacityArrayName());
  if (!this->DrawsSmoke(cells))
  {
    return;
  }
  vtkVolumeProperty* colored = this->Actor->GetProperty();
  vtkDataArray* smoke = nephoscope::visibleSmoke(cells);
  double range[2];
  smoke->GetFiniteRange(range);
  followDensity(this->SmokeOpacity, range[1] > 0.0 ? range[1] : 1.0);
  this->SmokeProperty->SetScalarOpacity(this->SmokeOpacity);
  this->SmokeProperty->SetScalarOpacityUnitDistance(this->ActualUnitDistance);
  if (colored->GetColorChannels() == 3)
  {
    this->SmokeProperty->SetColor(colored->GetRGBTransferFunction());
  }
  else
  {
    this->SmokeProperty->SetColor(colored->GetGrayTransferFunction());
  }
  this->Mapper->SetOpacityArrayName(smoke->GetName());
  this->Actor->SetProperty(this->SmokeProperty);
}
