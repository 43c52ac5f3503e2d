// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Media whose opacity is an array, without an opacity function: smoke by its density, lit clouds by
// the extinction that their light was computed for.
#include "vtkMediumRepresentation.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPVLODVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace
{
// Extinction is the density itself: a straight line through 0, up to the largest density there is.
void SetOpacityByDensity(vtkPiecewiseFunction* opacity, double largest, double opacityThere)
{
  if (opacity->GetSize() != 2 || opacity->GetRange()[1] != largest ||
    opacity->GetValue(largest) != opacityThere)
  {
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(largest, opacityThere);
  }
}
}

// Beside the light; null if nothing is coloured by it.
vtkDataArray* vtkMediumRepresentation::FindExtinctionOfLight(vtkDataSet* data)
{
  int association = 0;
  const char* name = nullptr;
  const bool isLit = this->GetOpacityArrayName().empty() &&
    this->FindColorArray(data, association, name) && name == std::string("Sunlight") &&
    data->GetFieldData()->HasArray("SunDirection");
  return isLit ? data->GetAttributes(association)->GetArray("ScaledExtinction") : nullptr;
}

std::string vtkMediumRepresentation::PrepareOpacity(vtkDataSet* data)
{
  vtkDataArray* extinction = this->FindExtinctionOfLight(data);
  if (!extinction)
  {
    return this->GetOpacityArrayName();
  }
  this->FollowDensity(extinction, true);
  return extinction->GetName();
}

void vtkMediumRepresentation::FollowDensity(vtkDataArray* density, bool isExtinction)
{
  double range[2];
  density->GetFiniteRange(range);
  const double largest = range[1] > 0.0 ? range[1] : 1.0;
  SetOpacityByDensity(this->DensityOpacity, largest, isExtinction ? 1.0 : largest);
  this->DensityProperty->SetScalarOpacity(this->DensityOpacity);
  this->DensityProperty->SetScalarOpacityUnitDistance(
    isExtinction ? 1.0 / largest : this->ActualUnitDistance);
  vtkVolumeProperty* colored = this->Actor->GetProperty();
  if (colored->GetColorChannels() == 3)
  {
    this->DensityProperty->SetColor(colored->GetRGBTransferFunction());
  }
  else
  {
    this->DensityProperty->SetColor(colored->GetGrayTransferFunction());
  }
  this->Actor->SetProperty(this->DensityProperty);
}
