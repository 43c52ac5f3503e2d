// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTexturedSplatsRepresentation.h"

#include "RankMeasures.h"
#include "SplatMeasures.h"
#include "SplatPieces.h"
#include "SplatShapes.h"
#include "SplatVectorColors.h"
#include "vtkMediumVolume.h"
#include "vtkTexturedSplatMapper.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

int vtkTexturedSplatsRepresentation::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->InputTimes[0] = this->InputTimes[1] = 0.0;
  this->NumberOfInputTimes = 0;
  vtkInformation* input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? inputVector[0]->GetInformationObject(0)
    : nullptr;
  if (input && input->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    input->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), this->InputTimes);
    this->NumberOfInputTimes = input->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

int vtkTexturedSplatsRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (GetNumberOfRanks() > 1 && inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    // Neighbours give cells at a border between pieces the shape that they have inside, and tell
    // which points have two owners.
    inputVector[0]->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 1);
  }
  return done;
}

bool vtkTexturedSplatsRepresentation::DrawsCells()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME())
    ? info->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  return name && name[0] && info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::CELL;
}

nephoscope::SplatSampling vtkTexturedSplatsRepresentation::GetSampling(bool onCells) const
{
  nephoscope::SplatSampling sampling{ onCells, this->CellSize };
  sampling.SizeArrayName = this->Mapper->GetCellSizeArrayName();
  sampling.SizesAreVolumes = this->Mapper->GetCellSizeArrayHoldsVolumes();
  sampling.FromCells = true; // which is the mapper's default
  return sampling;
}

void vtkTexturedSplatsRepresentation::PreparePiece(vtkDataObject* input)
{
  const bool onCells = this->DrawsCells();
  const vtkSmartPointer<vtkDataSet> whole = nephoscope::SampledPart(input);
  this->Piece = whole;
  this->Piece = GetNumberOfRanks() > 1
    ? nephoscope::SplatVertices(this->Piece, this->GetSampling(onCells))
    : nephoscope::WithShapesOfCells(this->Piece, this->GetSampling(onCells));
  const bool inCells =
    this->GetAssociationInPiece(onCells ? vtkDataObject::CELL : vtkDataObject::POINT) ==
    vtkDataObject::CELL;
  nephoscope::SplatSampling sampling = this->GetSampling(inCells);
  sampling.ShapeArrayName = nephoscope::splatShapeName;
  sampling.WholeCells = onCells; // also where all samples are
  int association = vtkDataObject::POINT;
  vtkDataArray* scalars = this->Piece ? this->FindOpacityArray(this->Piece, association) : nullptr;
  const bool together = (association == vtkDataObject::CELL) == inCells;
  const nephoscope::MediumBounds common =
    nephoscope::BoundsOfSamples(this->Piece, sampling, nephoscope::ReductionOverRanks());
  nephoscope::MediumMeasures mine =
    nephoscope::MeasureSplats(this->Piece, sampling, together ? scalars : nullptr, {}, common);
  vtkDataArray* ofWhole = scalars && whole
    ? whole->GetAttributes(onCells ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(scalars->GetName())
    : nullptr;
  if (ofWhole && together && mine.Volume > 0.0) // as on one rank, where hidden samples stay
  {
    nephoscope::FindFiniteRange(ofWhole, mine.ScalarRange);
  }
  const nephoscope::MediumMeasures all = nephoscope::ReduceOverRanks(mine);
  if (HoldsAnything(input) && all.Volume <= 0.0 && IsFirstRank())
  {
    vtkWarningMacro(
      "Textured Splats draws points or cells, and the input has none: nothing is drawn.");
  }
  vtkMath::UninitializeBounds(this->DataBounds);
  if (this->Piece && this->Piece->GetNumberOfPoints() > 0)
  {
    sampling.RadiusFactor = this->Mapper->GetRadiusFactor();
    // Farther out splats are faint. The camera sees what is left of them there, because it sees the
    // ball around these bounds.
    constexpr double seen = 1.0; // of their kernels
    nephoscope::FindSplatBounds(
      nephoscope::SplatShapes(this->Piece, sampling), seen, this->DataBounds);
  }
  if (!this->Piece)
  {
    this->Piece = vtkSmartPointer<vtkPolyData>::New();
  }
  StoreMeasures(this->Piece, nephoscope::DefaultUnitDistance(all, common, true), all.ScalarRange);
  this->StoreSuited(sampling, common);
  nephoscope::StoreVectorColorRange(this->Piece, inCells, this->Mapper->GetVectorColorArrayName());
}

void vtkTexturedSplatsRepresentation::MovePiece(vtkMatrix4x4* matrix)
{
  this->Superclass::MovePiece(matrix);
  nephoscope::MoveShapes(this->Piece, matrix);
}

void vtkTexturedSplatsRepresentation::DescribePiece(vtkInformation* inInfo)
{
  this->Superclass::DescribePiece(inInfo);
  // On several ranks samples are single vertices, each of which goes to the rank in whose region it
  // lies.
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
    vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  vtkPVRenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inInfo, this);
}

bool vtkTexturedSplatsRepresentation::DrawsBlock(vtkDataObject* block) const
{
  return block->GetNumberOfElements(vtkDataObject::POINT) > 0 ||
    block->GetNumberOfElements(vtkDataObject::CELL) > 0; // hyper tree grids
}

bool vtkTexturedSplatsRepresentation::HoldsMedium(vtkDataSet* data) const
{
  return data->GetNumberOfPoints() > 0;
}

int vtkTexturedSplatsRepresentation::GetUniformAssociation() const
{
  return this->GetAssociationInPiece(vtkDataObject::POINT);
}

int vtkTexturedSplatsRepresentation::GetAssociationInPiece(int association) const
{
  return GetNumberOfRanks() > 1 ? static_cast<int>(vtkDataObject::CELL) : association;
}

void vtkTexturedSplatsRepresentation::PrepareMapper(vtkDataSet* data)
{
  this->Superclass::PrepareMapper(data);
  this->Mapper->SetOpacityArrayName(this->PrepareOpacity(data));
  this->Mapper->SetOpacityScale(this->OpacityScale * this->Opacity);
  if (!this->Mapper->GetVectorArrayName().empty()) // which may reach farther than the splats
  {
    double none[6];
    vtkMath::UninitializeBounds(none);
    static_cast<vtkMediumVolume*>(this->Actor.Get())->SetSeenBounds(none);
  }
  this->MoveVectors();
  this->SuitVectors(data);
  this->Mapper->SetVectorColorFunction(
    this->VectorColorFunction ? this->VectorColorFunction.Get() : this->DefaultColors->Over(data));
}

double vtkTexturedSplatsRepresentation::GetPhaseNow()
{
  if (!this->MoveWithTime)
  {
    return this->Phase;
  }
  const double phase =
    this->Phase + (this->GetUpdateTime() - this->InputTimes[0]) / this->GetLoopTime();
  return phase - std::floor(phase);
}

double vtkTexturedSplatsRepresentation::GetLoopTime() const
{
  const double range = this->InputTimes[1] - this->InputTimes[0];
  const int steps = this->NumberOfInputTimes - 1;
  if (this->LoopDuration > 0.0)
  {
    return this->LoopDuration;
  }
  if (!(range > 0.0))
  {
    return 1.0;
  }
  if (steps < 1)
  {
    return range;
  }
  // If a period took a single step, the streaks would be in the same place at each step.
  constexpr double stepsOfPeriod = 4.0;
  return range * std::max(1.0, stepsOfPeriod * this->Mapper->GetPhaseCycles() / steps);
}

void vtkTexturedSplatsRepresentation::SetKernel(int kernel)
{
  this->Mapper->SetKernel(kernel);
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

void vtkTexturedSplatsRepresentation::SetCellSizeArray(const char* name)
{
  const std::string chosen = name && std::string(name) != "None" ? name : "";
  if (chosen != this->Mapper->GetCellSizeArrayName())
  {
    this->Mapper->SetCellSizeArrayName(chosen);
    this->MarkModified();
  }
}

void vtkTexturedSplatsRepresentation::SetCellSizeArrayHoldsVolumes(bool volumes)
{
  if (volumes != this->Mapper->GetCellSizeArrayHoldsVolumes())
  {
    this->Mapper->SetCellSizeArrayHoldsVolumes(volumes);
    this->MarkModified();
  }
}

void vtkTexturedSplatsRepresentation::SetRadiusFactor(double factor)
{
  if (factor != this->Mapper->GetRadiusFactor())
  {
    this->Mapper->SetRadiusFactor(factor);
    this->MarkModified(); // the bounds depend on it
  }
}

void vtkTexturedSplatsRepresentation::SetVectorArray(const char* name)
{
  const std::string chosen = name && std::string(name) != "None" ? name : "";
  if (chosen != this->Mapper->GetVectorArrayName())
  {
    this->Mapper->SetVectorArrayName(chosen);
    this->MarkModified(); // what suits them is of all ranks
  }
}

void vtkTexturedSplatsRepresentation::SetGreatestSpeed(double speed)
{
  if (speed != this->GreatestSpeed)
  {
    this->GreatestSpeed = speed;
    this->Mapper->SetMaximumSpeed(speed); // several ranks decide anew
    this->MarkModified();                 // so does what suits them
  }
}

void vtkTexturedSplatsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MoveWithTime: " << this->MoveWithTime << "\n";
  os << indent << "LoopDuration: " << this->LoopDuration << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "TrueSpeed: " << this->TrueSpeed << "\n";
  os << indent << "TimeScale: " << this->TimeScale << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "ShowSpeedKey: " << this->SpeedKey->GetVisibility() << "\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
