// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEarthRepresentation.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationStringKey.h"
#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkEarthRepresentation);

void vtkEarthRepresentation::UpdateColoringParameters()
{
  vtkInformation* array = this->GetInputArrayInformation(0);
  const char* name = array->Get(vtkDataObject::FIELD_NAME());
  const std::string chosen = name ? name : "";
  if (chosen.empty())
  {
    array->Set(vtkDataObject::FIELD_NAME(), "Earth");
    array->Set(vtkDataObject::FIELD_ASSOCIATION(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  }
  this->Superclass::UpdateColoringParameters();
  array->Set(vtkDataObject::FIELD_NAME(), chosen.c_str());
}
