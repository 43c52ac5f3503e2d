// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How vectors look on the splats: all of it is the mapper's.
#include "vtkTexturedSplatsRepresentation.h"

#include "vtkTexturedSplatMapper.h"

#include "vtkScalarsToColors.h"

#include <string>

void vtkTexturedSplatsRepresentation::SetVectorStyle(int style)
{
  this->Mapper->SetVectorStyle(style);
}

void vtkTexturedSplatsRepresentation::SetVectorPlacement(int placement)
{
  this->Mapper->SetVectorPlacement(placement);
}

void vtkTexturedSplatsRepresentation::SetLayerAxis(int axis)
{
  this->Mapper->SetLayerAxis(axis);
}

void vtkTexturedSplatsRepresentation::SetVectorUnit(double length)
{
  this->VectorUnit = length;
  this->Mapper->SetVectorUnit(length); // several ranks decide anew
}

void vtkTexturedSplatsRepresentation::SetStreakWidth(double width)
{
  this->Mapper->SetStreakWidth(width);
}

void vtkTexturedSplatsRepresentation::SetSegmentLength(double length)
{
  this->Mapper->SetSegmentLength(length);
}

void vtkTexturedSplatsRepresentation::SetSegmentWidth(double pixels)
{
  this->Mapper->SetSegmentWidth(pixels);
}

void vtkTexturedSplatsRepresentation::SetPhaseSteps(int steps)
{
  this->Mapper->SetPhaseSteps(steps);
}

void vtkTexturedSplatsRepresentation::SetVectorColorFunction(vtkScalarsToColors* function)
{
  this->VectorColorFunction = function;
}

void vtkTexturedSplatsRepresentation::SetVectorColorArray(const char* name)
{
  const std::string chosen = name ? name : "";
  const std::string array = chosen == "None" ? std::string() : chosen;
  if (array != this->Mapper->GetVectorColorArrayName())
  {
    this->Mapper->SetVectorColorArrayName(array);
    this->MarkModified(); // the range of the default colours is of all ranks
  }
}
