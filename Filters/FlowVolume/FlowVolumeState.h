// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkFlowVolume keeps between updates.
#ifndef nephoscope_FlowVolumeState_h
#define nephoscope_FlowVolumeState_h

#include "VelocityFields.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <memory>

namespace nephoscope
{
// The velocity of a dataset, and what its polygon and automatic settings are made from.
struct FlowField
{
  std::unique_ptr<const DataSetField> Field;
  vtkSmartPointer<vtkDataObject> Data; // a shared copy, which the field refers to
  VelocityArray Velocity;
  double Diagonal = 0.0;  // of the bounds
  vtkMTimeType MTime = 0; // of the data when the field was made

  bool IsOf(vtkMTimeType newest, const VelocityArray& velocity) const
  {
    return this->MTime == newest && this->Velocity.Name == velocity.Name &&
      this->Velocity.OnCells == velocity.OnCells;
  }
};

struct FlowVolumeState
{
  std::shared_ptr<const FlowField> Field; // of the last input
};
}

#endif
