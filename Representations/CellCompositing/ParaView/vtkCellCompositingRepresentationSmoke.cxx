// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Smoke in vtkCellCompositingRepresentation: opaque by its density, whatever it is coloured by; and lit clouds, by the extinction that
// their light was computed for.
#include "vtkCellCompositingRepresentation.h"

#include "SmokeCells.h"
#include "vtkCellCompositingMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <string>

namespace
{
// Extinction is the density itself: a straight line through 0, up to the largest density there is.
void followDensity(vtkPiecewiseFunction* opacity, double largest, double opacityThere)
{
  if (opacity->GetSize() != 2 || opacity->GetRange()[1] != largest ||
    opacity->GetValue(largest) != opacityThere)
  {
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(largest, opacityThere);
  }
}

// That of clouds that vtkSunlight has lit; else null.
vtkDataArray* extinctionOfLight(vtkDataSet* cells)
{
  vtkPointData* points = cells->GetPointData();
  return points->HasArray("Sunlight") && cells->GetFieldData()->HasArray("SunDirection")
    ? points->GetArray("ScaledExtinction")
    : nullptr;
}
}

bool vtkCellCompositingRepresentation::DrawsSmoke(vtkDataSet* cells) const
{
  return this->GetOpacityArrayName().empty() && nephoscope::smokeDensity(cells) != nullptr;
}

void vtkCellCompositingRepresentation::PrepareOpacity(vtkDataSet* cells)
{
  this->Mapper->SetOpacityArrayName(this->GetOpacityArrayName());
  int association = 0;
  const char* name = nullptr;
  const bool isColoredByLight =
    this->FindColorArray(cells, association, name) && name == std::string("Sunlight");
  if (this->DrawsSmoke(cells))
  {
    this->FollowDensity(nephoscope::visibleSmoke(cells), false);
  }
  else if (vtkDataArray* extinction = this->GetOpacityArrayName().empty() && isColoredByLight
      ? extinctionOfLight(cells)
      : nullptr)
  {
    this->FollowDensity(extinction, true);
  }
}

// With `isExtinction` the optical depth of a length is that of the array.
void vtkCellCompositingRepresentation::FollowDensity(vtkDataArray* density, bool isExtinction)
{
  double range[2];
  density->GetFiniteRange(range);
  const double largest = range[1] > 0.0 ? range[1] : 1.0;
  followDensity(this->SmokeOpacity, largest, isExtinction ? 1.0 : largest);
  this->SmokeProperty->SetScalarOpacity(this->SmokeOpacity);
  this->SmokeProperty->SetScalarOpacityUnitDistance(
    isExtinction ? 1.0 / largest : this->ActualUnitDistance);
  vtkVolumeProperty* colored = this->Actor->GetProperty();
  if (colored->GetColorChannels() == 3)
  {
    this->SmokeProperty->SetColor(colored->GetRGBTransferFunction());
  }
  else
  {
    this->SmokeProperty->SetColor(colored->GetGrayTransferFunction());
  }
  this->Mapper->SetOpacityArrayName(density->GetName());
  this->Actor->SetProperty(this->SmokeProperty);
}
