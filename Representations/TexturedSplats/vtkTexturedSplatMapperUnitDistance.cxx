// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The unit distance that makes splats visible, whatever their size and number, and streaks that
// leave them readable.
#include "vtkTexturedSplatMapper.h"

#include "ArraySelection.h"
#include "SplatMeasures.h"
#include "SplatShapes.h"
#include "SplatVectorBounds.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkVolumeProperty.h"

vtkDataArray* vtkTexturedSplatMapper::FindVectors(bool& onCells)
{
  vtkDataSet* input = this->GetDataSetInput();
  int cellFlag = 0;
  if (!input ||
    !vtkAbstractMapper::GetScalars(
      input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag))
  {
    return nullptr;
  }
  onCells = cellFlag == 1;
  vtkDataArray* vectors = input->GetAttributes(onCells ? vtkDataObject::CELL : vtkDataObject::POINT)
                            ->GetArray(this->VectorArrayName.c_str());
  return vectors && vectors->GetNumberOfComponents() == 3 ? vectors : nullptr;
}

void vtkTexturedSplatMapper::SuitVectorsToMedium(bool opacity, bool share)
{
  bool onCells = false;
  vtkDataArray* vectors = this->FindVectors(onCells);
  if (!vectors)
  {
    return;
  }
  vtkDataSet* input = this->GetDataSetInput();
  nephoscope::SplatSampling sampling = this->GetSampling(onCells);
  sampling.RadiusFactor = 1.0;
  const nephoscope::MediumBounds bounds = nephoscope::BoundsOfSamples(input, sampling);
  const nephoscope::SpeedCounts speeds = nephoscope::CountSpeeds(input, sampling, vectors);
  const double full = this->MaximumSpeed > 0 ? this->MaximumSpeed : speeds.GetFull();
  const nephoscope::MediumMeasures measures =
    nephoscope::MeasureSplats(input, sampling, vectors, {}, bounds, full);
  const nephoscope::SuitedVectors suited =
    nephoscope::SuitVectorsTo(measures, bounds, full, speeds.GetNumber());
  if (share)
  {
    this->SetVectorFraction(suited.Share);
  }
  if (opacity)
  {
    this->SetVectorOpacity(suited.Opacity);
  }
}

double vtkTexturedSplatMapper::FindVectorUnit()
{
  bool onCells = false;
  vtkDataArray* vectors = this->FindVectors(onCells);
  if (this->VectorUnit > 0 || !vectors)
  {
    return this->VectorUnit;
  }
  const nephoscope::SplatShapes shapes(this->GetDataSetInput(), this->GetSampling(onCells));
  return this->GetStreakUnit(nephoscope::SumVectors(shapes, vectors).MeanCell());
}

double vtkTexturedSplatMapper::FindUnitDistance(vtkVolumeProperty* property)
{
  vtkDataSet* input = this->GetDataSetInput();
  nephoscope::ScalarSelection scalars;
  const nephoscope::ScalarSelection read =
    nephoscope::SelectOpaque(this, input, property, this->OpacityArrayName, scalars);
  if (!read.Array || read.OnCells != scalars.OnCells)
  {
    return 0.0; // drawing will tell
  }
  nephoscope::SplatSampling sampling = this->GetSampling(scalars.OnCells);
  sampling.RadiusFactor = 1.0; // the mass of wider splats is the same
  const nephoscope::MediumBounds bounds = nephoscope::BoundsOfSamples(input, sampling);
  return nephoscope::DefaultUnitDistance(
    nephoscope::MeasureSplats(
      input, sampling, read.Array, nephoscope::FullOpacity(property->GetScalarOpacity()), bounds),
    bounds, false);
}
