// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of vtkCellCompositingMapper, printed and copied.
#include "vtkCellCompositingMapper.h"

#include "MapperSettings.h"

void vtkCellCompositingMapper::ShallowCopy(vtkAbstractMapper* other)
{
  auto* mapper = vtkCellCompositingMapper::SafeDownCast(other);
  if (mapper == this)
  {
    return;
  }
  this->Superclass::ShallowCopy(other);
  if (mapper)
  {
    nephoscope::CopyVolumeSettings(mapper, this);
    this->SetBlendMode(mapper->BlendMode);
    this->SetMethod(mapper->Method);
    this->SetIntegration(mapper->Integration);
    this->SetCellInterpolation(mapper->CellInterpolation);
    this->SetVisibilityOrder(mapper->VisibilityOrder);
    this->SetOpacityScale(mapper->OpacityScale);
    this->SetOpacityArrayName(mapper->OpacityArrayName);
    this->SetSplitAtControlPoints(mapper->SplitAtControlPoints);
    this->SetAutoAdjustSampleDistances(mapper->AutoAdjustSampleDistances);
    this->SetImageSampleDistance(mapper->ImageSampleDistance);
    this->SetMaximumImageSampleDistance(mapper->MaximumImageSampleDistance);
    this->SetPickOpacity(mapper->PickOpacity);
    this->SetCellIdArrayName(mapper->CellIdArrayName);
    this->SetPointIdArrayName(mapper->PointIdArrayName);
    this->SetCompositeIdArrayName(mapper->CompositeIdArrayName);
    this->SetProcessIdArrayName(mapper->ProcessIdArrayName);
    this->Modified();
  }
}

void vtkCellCompositingMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* methods[] = { "Projection", "Rays", "TrianglesLinear", "TrianglesTable", "Faces",
    "Automatic" };
  os << indent << "Method: " << methods[this->Method] << "\n";
  os << indent << "Integration: " << (this->Integration == EXACT_INTEGRATION ? "Exact" : "Average")
     << "\n";
  const char* const interpolations[] = { "Tetrahedra", "Trilinear", "Automatic" };
  os << indent << "CellInterpolation: " << interpolations[this->CellInterpolation] << "\n";
  const char* orders[] = { "Exact", "Centroid", "None" };
  os << indent << "VisibilityOrder: " << orders[this->VisibilityOrder] << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "OpacityArrayName: " << this->OpacityArrayName << "\n";
  os << indent << "SplitAtControlPoints: " << this->SplitAtControlPoints << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "PickOpacity: " << this->PickOpacity << "\n";
  os << indent << "CellIdArrayName: " << this->CellIdArrayName << "\n";
  os << indent << "PointIdArrayName: " << this->PointIdArrayName << "\n";
  os << indent << "CompositeIdArrayName: " << this->CompositeIdArrayName << "\n";
  os << indent << "ProcessIdArrayName: " << this->ProcessIdArrayName << "\n";
  os << indent << "NumberOfTetrahedra: " << this->GetNumberOfTetrahedra() << "\n";
  os << indent << "NumberOfDrawnTetrahedra: " << this->GetNumberOfDrawnTetrahedra() << "\n";
  os << indent << "NumberOfRayLayers: " << this->GetNumberOfRayLayers() << "\n";
  os << indent << "OrderIndependent: " << this->GetOrderIndependent() << "\n";
  os << indent << "NumberOfVisibilityCycles: " << this->GetNumberOfVisibilityCycles() << "\n";
  os << indent << "NumberOfCyclicTetrahedra: " << this->GetNumberOfCyclicTetrahedra() << "\n";
  os << indent << "NumberOfBrokenRelations: " << this->GetNumberOfBrokenRelations() << "\n";
}
