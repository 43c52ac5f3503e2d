// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// All settings of vtkTexturedSplatMapper, printed and copied.
#include "vtkTexturedSplatMapper.h"

#include "vtkScalarsToColors.h"

void vtkTexturedSplatMapper::CopySettings(vtkTexturedSplatMapper* mapper)
{
  this->SetKernel(mapper->Kernel);
  this->SetCellSize(mapper->CellSize);
  this->SetRadiusFactor(mapper->RadiusFactor);
  this->SetErrorTolerance(mapper->ErrorTolerance);
  this->SetErrorToleranceUnit(mapper->ErrorToleranceUnit);
  this->SetErrorMeasure(mapper->ErrorMeasure);
  this->SetLevelBlending(mapper->LevelBlending);
  this->SetInteractiveMaximumNumberOfSplats(mapper->InteractiveMaximumNumberOfSplats);
  this->SetInteractiveUpdateRate(mapper->InteractiveUpdateRate);
  this->SetAutoAdjustSampleDistances(mapper->AutoAdjustSampleDistances);
  this->SetImageSampleDistance(mapper->ImageSampleDistance);
  this->SetMaximumImageSampleDistance(mapper->MaximumImageSampleDistance);
  this->SetShapeArrayName(mapper->ShapeArrayName);
  this->SetCellSizeArrayName(mapper->CellSizeArrayName);
  this->SetCellSizeArrayHoldsVolumes(mapper->CellSizeArrayHoldsVolumes);
  this->SetCellSizeFromCells(mapper->CellSizeFromCells);
  this->SetCellSizeFromNeighbors(mapper->CellSizeFromNeighbors);
  this->SetOpacityScale(mapper->OpacityScale);
  this->SetOpacityArrayName(mapper->OpacityArrayName);
  this->SetInterpolateScalarsBeforeMapping(mapper->InterpolateScalarsBeforeMapping);
  this->SetOrderByLayers(mapper->OrderByLayers);
  this->SetVectorArrayName(mapper->VectorArrayName);
  this->SetVectorOpacity(mapper->VectorOpacity);
  this->SetMaximumSpeed(mapper->MaximumSpeed);
  this->SetVectorStyle(mapper->VectorStyle);
  this->SetVectorPlacement(mapper->VectorPlacement);
  this->SetLayerAxis(mapper->LayerAxis);
  this->SetVectorUnit(mapper->VectorUnit);
  this->SetVectorFraction(mapper->VectorFraction);
  this->SetStreakPeriod(mapper->StreakPeriod);
  this->SetStreakWidth(mapper->StreakWidth);
  this->SetSegmentLength(mapper->SegmentLength);
  this->SetSegmentWidth(mapper->SegmentWidth);
  this->SetVectorColorArrayName(mapper->VectorColorArrayName);
  this->SetUseVectorColor(mapper->UseVectorColor);
  this->SetPhase(mapper->Phase);
  this->SetPhaseCycles(mapper->PhaseCycles);
  this->SetPhaseSteps(mapper->PhaseSteps);
  this->SetTrueSpeed(mapper->TrueSpeed);
  this->SetTimeScale(mapper->TimeScale);
  this->SetFilmTime(mapper->FilmTime);
  this->SetVectorColorFunction(mapper->VectorColorFunction);
  this->SetVectorColor(mapper->VectorColor);
  this->SetRegion(mapper->Region);
  this->SetCommonFrame(
    mapper->CommonOrigin, mapper->CommonLongestEdge, mapper->CommonNumberOfSamples);
}

void vtkTexturedSplatMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* kernels[] = { "Cubic", "Quadratic", "Gaussian" };
  const char* measures[] = { "Greatest", "Root mean square", "Picture" };
  os << indent << "Kernel: " << kernels[this->Kernel] << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "RadiusFactor: " << this->RadiusFactor << "\n";
  os << indent << "CellSizeArrayName: " << this->CellSizeArrayName
     << (this->CellSizeArrayHoldsVolumes ? " (volumes)\n" : " (lengths)\n");
  os << indent << "CellSizeFromCells: " << this->CellSizeFromCells << "\n";
  os << indent << "CellSizeFromNeighbors: " << this->CellSizeFromNeighbors << "\n";
  os << indent << "ShapeArrayName: " << this->ShapeArrayName << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "OpacityArrayName: " << this->OpacityArrayName << "\n";
  os << indent << "OrderByLayers: " << this->OrderByLayers << "\n";
  os << indent << "InterpolateScalarsBeforeMapping: " << this->InterpolateScalarsBeforeMapping
     << "\n";
  os << indent << "VectorArrayName: " << this->VectorArrayName << "\n";
  os << indent << "VectorOpacity: " << this->VectorOpacity << "\n";
  os << indent << "MaximumSpeed: " << this->MaximumSpeed << "\n";
  os << indent << "StreakPeriod: " << this->StreakPeriod << "\n";
  os << indent << "VectorStyle: " << (this->VectorStyle == SEGMENTS ? "Segments" : "Streaks")
     << "\n";
  os << indent
     << "VectorPlacement: " << (this->VectorPlacement == PLACEMENT_LAYERS ? "Layers" : "Middle")
     << "\n";
  os << indent << "LayerAxis: " << this->LayerAxis << "\n";
  os << indent << "VectorUnit: " << this->VectorUnit << "\n";
  os << indent << "VectorFraction: " << this->VectorFraction << "\n";
  os << indent << "StreakWidth: " << this->StreakWidth << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "SegmentWidth: " << this->SegmentWidth << "\n";
  os << indent << "VectorColorArrayName: " << this->VectorColorArrayName << "\n";
  os << indent << "VectorColorFunction: " << this->VectorColorFunction.Get() << "\n";
  os << indent << "PhaseSteps: " << this->PhaseSteps << "\n";
  os << indent << "VectorColor: " << this->VectorColor[0] << " " << this->VectorColor[1] << " "
     << this->VectorColor[2] << "\n";
  os << indent << "UseVectorColor: " << this->UseVectorColor << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "PhaseCycles: " << this->PhaseCycles << "\n";
  os << indent << "TrueSpeed: " << this->TrueSpeed << "\n";
  os << indent << "TimeScale: " << this->TimeScale << "\n";
  os << indent << "FilmTime: " << this->FilmTime << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance
     << (this->ErrorToleranceUnit == UNIT_OF_IMAGE ? " of the image\n" : " of the data\n");
  os << indent << "ErrorMeasure: " << measures[this->ErrorMeasure] << "\n";
  os << indent << "LevelBlending: " << this->LevelBlending << "\n";
  os << indent << "InteractiveMaximumNumberOfSplats: " << this->InteractiveMaximumNumberOfSplats
     << "\n";
  os << indent << "InteractiveUpdateRate: " << this->InteractiveUpdateRate << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "NumberOfDrawnSplats: " << this->GetNumberOfDrawnSplats() << "\n";
}
