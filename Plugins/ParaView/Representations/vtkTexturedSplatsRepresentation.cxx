// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTexturedSplatsRepresentation.h"

#include "SplatKernel.h"
#include "SplatMeasures.h"
#include "SplatPieces.h"
#include "SplatShapes.h"
#include "vtkTexturedSplatMapper.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>

vtkStandardNewMacro(vtkTexturedSplatsRepresentation);

vtkTexturedSplatsRepresentation::vtkTexturedSplatsRepresentation()
{
  this->Actor->SetMapper(this->Mapper);
}

vtkTexturedSplatsRepresentation::~vtkTexturedSplatsRepresentation() = default;

int vtkTexturedSplatsRepresentation::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->InputTimes[0] = this->InputTimes[1] = 0.0;
  vtkInformation* input =
    inputVector[0]->GetNumberOfInformationObjects() == 1 ? inputVector[0]->GetInformationObject(0) : nullptr;
  if (input && input->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    input->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), this->InputTimes);
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

void vtkTexturedSplatsRepresentation::PreparePiece(vtkDataObject* input)
{
  this->Piece = nephoscope::sampledPart(input);
  int association = vtkDataObject::POINT;
  vtkDataArray* scalars = this->Piece ? this->FindOpacityArray(this->Piece, association) : nullptr;
  const bool onCells = association == vtkDataObject::CELL;
  const nephoscope::CellMeasures all = nephoscope::reduceOverRanks(
    nephoscope::measureSplats(this->Piece, scalars, onCells, this->CellSize));
  if (all.Volume <= 0.0 && IsFirstRank())
  {
    vtkWarningMacro("Textured Splats draws points or cells, and the input has none: nothing is drawn.");
  }
  vtkMath::UninitializeBounds(this->DataBounds);
  if (this->Piece)
  {
    const auto kernel = static_cast<nephoscope::SplatKernel>(this->Mapper->GetKernel());
    nephoscope::FindSplatBounds(nephoscope::SplatShapes(this->Piece, { onCells, this->CellSize }),
      nephoscope::KernelRadius(kernel), this->DataBounds);
  }
  else
  {
    this->Piece = vtkSmartPointer<vtkPolyData>::New();
  }
  StoreUnitDistance(
    this->Piece, nephoscope::meanChord(all) * nephoscope::meanRamp(all) / MeanOpticalDepth);
}

void vtkTexturedSplatsRepresentation::DescribePiece(vtkInformation* inInfo)
{
  this->Superclass::DescribePiece(inInfo);
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
}

bool vtkTexturedSplatsRepresentation::HoldsMedium(vtkDataSet* data) const
{
  return data->GetNumberOfPoints() > 0;
}

int vtkTexturedSplatsRepresentation::GetUniformAssociation() const
{
  return vtkDataObject::POINT;
}

void vtkTexturedSplatsRepresentation::PrepareMapper(vtkDataSet* data)
{
  this->Superclass::PrepareMapper(data);
  this->Mapper->SetOpacityArrayName(this->GetOpacityArrayName());
  this->Mapper->SetOpacityScale(this->OpacityScale * this->Opacity);
  this->Mapper->SetPhase(this->GetPhaseNow());
}

double vtkTexturedSplatsRepresentation::GetPhaseNow()
{
  if (!this->MoveWithTime)
  {
    return this->Phase;
  }
  const double range = this->InputTimes[1] - this->InputTimes[0];
  const double duration = this->LoopDuration > 0.0 ? this->LoopDuration : range > 0.0 ? range : 1.0;
  const double phase = this->Phase + (this->GetUpdateTime() - this->InputTimes[0]) / duration;
  return phase - std::floor(phase);
}

void vtkTexturedSplatsRepresentation::SetKernel(int kernel)
{
  if (kernel != this->Mapper->GetKernel())
  {
    this->Mapper->SetKernel(kernel);
    this->MarkModified(); // the bounds depend on it
  }
}

void vtkTexturedSplatsRepresentation::SetCellSize(double size)
{
  if (size != this->CellSize)
  {
    this->CellSize = size;
    this->Mapper->SetCellSize(size);
    this->MarkModified(); // so do the bounds and the automatic unit distance
  }
}

void vtkTexturedSplatsRepresentation::SetVectorArray(const char* name)
{
  const std::string chosen = name ? name : "";
  this->Mapper->SetVectorArrayName(chosen == "None" ? std::string() : chosen);
}

void vtkTexturedSplatsRepresentation::SetVectorOpacity(double opacity)
{
  this->Mapper->SetVectorOpacity(opacity);
}

void vtkTexturedSplatsRepresentation::SetGreatestSpeed(double speed)
{
  this->Mapper->SetGreatestSpeed(speed);
}

void vtkTexturedSplatsRepresentation::SetStreakPeriod(double cells)
{
  this->Mapper->SetStreakPeriod(cells);
}

void vtkTexturedSplatsRepresentation::SetUseVectorColor(bool use)
{
  this->Mapper->SetUseVectorColor(use);
}

void vtkTexturedSplatsRepresentation::SetVectorColor(double red, double green, double blue)
{
  this->Mapper->SetVectorColor(red, green, blue);
}

void vtkTexturedSplatsRepresentation::SetPhaseCycles(int cycles)
{
  this->Mapper->SetPhaseCycles(cycles);
}

void vtkTexturedSplatsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MoveWithTime: " << this->MoveWithTime << "\n";
  os << indent << "LoopDuration: " << this->LoopDuration << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
