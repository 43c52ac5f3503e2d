// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of vtkTexturedSplatMapper, printed and copied, without those of vectors.
#include "vtkTexturedSplatMapper.h"

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
