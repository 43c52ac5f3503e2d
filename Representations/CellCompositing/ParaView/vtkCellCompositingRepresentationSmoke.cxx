// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Smoke in vtkCellCompositingRepresentation: opaque by its density, whatever it is coloured by; by
// its extinction where it is coloured by light.
#include "vtkCellCompositingRepresentation.h"

#include "SmokeData.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <string>

bool vtkCellCompositingRepresentation::DrawsSmoke(vtkDataSet* cells) const
{
  return this->GetOpacityArrayName().empty() && nephoscope::SmokeDensity(cells) != nullptr;
}

std::string vtkCellCompositingRepresentation::PrepareOpacity(vtkDataSet* cells)
{
  if (!this->DrawsSmoke(cells) || cells->GetPointData()->HasArray("SmokeExtinction")) // lit
  {
    return this->Superclass::PrepareOpacity(cells);
  }
  vtkDataArray* density = nephoscope::VisibleSmoke(cells);
  this->FollowDensity(density, false);
  return density->GetName();
}
