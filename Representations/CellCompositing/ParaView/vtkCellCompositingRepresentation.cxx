// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingRepresentation.h"

#include "CellMeasures.h"
#include "ForwardedMessages.h"
#include "PickedNumbers.h"
#include "RankMeasures.h"
#include "RankRegions.h"
#include "Ranks.h"
#include "SmokeData.h"
#include "VolumetricCells.h"
#include "vtkCellCompositingMapper.h"

#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkCellCompositingRepresentation);

namespace
{
constexpr double smokeOpticalDepth = 1.0; // of smoke, through the generating polygon's diameter
}

vtkCellCompositingRepresentation::vtkCellCompositingRepresentation()
  : Region(nephoscope::wholeSpace)
  , CellInterpolation(this->Mapper->GetCellInterpolation())
{
  this->Actor->SetMapper(this->Mapper);
  nephoscope::ForwardMessages(this->Mapper, this);
}

vtkCellCompositingRepresentation::~vtkCellCompositingRepresentation() = default;

bool vtkCellCompositingRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->RegisterPropForHardwareSelection(this, this->Actor);
  }
  return this->Superclass::AddToView(view);
}

bool vtkCellCompositingRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  }
  return this->Superclass::RemoveFromView(view);
}

vtkSmartPointer<vtkDataObject> vtkCellCompositingRepresentation::NumberInput(vtkDataObject* input)
{
  return GetNumberOfRanks() > 1 ? vtkSmartPointer<vtkDataObject>(input)
                                : nephoscope::WithPickedNumbers(input);
}

void vtkCellCompositingRepresentation::PreparePiece(vtkDataObject* input)
{
  this->Piece =
    nephoscope::WithConvexCells(nephoscope::VolumetricPart(input, GetNumberOfRanks() > 1));
  this->HasOwnNumbers = GetNumberOfRanks() == 1 && nephoscope::HasNumbersOf(input, this->Piece);
  nephoscope::DropSharedNumbers(input, this->Piece);
  int association = 0;
  vtkDataArray* scalars = this->Piece ? this->FindOpacityArray(this->Piece, association) : nullptr;
  const nephoscope::CellMedium medium{ scalars,
    association == vtkDataObject::FIELD_ASSOCIATION_CELLS };
  const nephoscope::MediumBounds mine = nephoscope::BoundsOfCells(this->Piece);
  const nephoscope::MediumBounds common =
    nephoscope::RobustBoundsOfCells(this->Piece, nephoscope::ReductionOverRanks());
  const nephoscope::MediumMeasures all =
    nephoscope::ReduceOverRanks(nephoscope::MeasureCells(this->Piece, medium, common));
  std::copy(mine.begin(), mine.end(), this->DataBounds);
  double smokeDistance = 0.0;
  const bool isSmoke =
    nephoscope::MaximumOverRanks(nephoscope::SmokeDensity(this->Piece) ? 1 : 0) == 1;
  if (this->GetOpacityArrayName().empty() && isSmoke && all.Volume > 0.0)
  {
    // The density at the polygon makes the times of an unsteady flow comparable.
    const double initial = nephoscope::InitialSmokeDensity(this->Piece);
    const double density = initial > 0.0 ? initial : all.ScalarIntegral / all.Volume;
    smokeDistance =
      nephoscope::WidthOfSmoke(this->Piece, nephoscope::OtherRanks()) * density / smokeOpticalDepth;
  }

  // The measures are those of a sample.
  const bool hasNoVolume =
    all.Volume <= 0.0 && MinimumOverRanks(nephoscope::HoldsVolume(this->Piece) ? 0 : 1) == 1;
  if (hasNoVolume)
  {
    this->Piece = nullptr; // the mapper would tell the same in its own words
  }
  this->WarnOfNoVolume(hasNoVolume && HoldsAnything(input));
  // A rank without cells can not know what the others hold; an empty unstructured grid goes with
  // either.
  this->AxisAligned = !this->Piece || nephoscope::IsAxisAligned(this->Piece);
  if (!this->Piece)
  {
    this->Piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  if (GetNumberOfRanks() > 1)
  {
    this->AxisAligned = MinimumOverRanks(this->AxisAligned ? 1 : 0) != 0;
    if (!this->AxisAligned)
    {
      this->MakeListOfCells();
    }
  }
  StoreMeasures(this->Piece,
    smokeDistance > 0.0 ? smokeDistance : nephoscope::DefaultUnitDistance(all, common, true),
    all.ScalarRange);
}

// Once until there is a volume again: a slice that is dragged has none in any place.
void vtkCellCompositingRepresentation::WarnOfNoVolume(bool hasNoVolume)
{
  if (hasNoVolume && !this->HadNoVolume && IsFirstRank())
  {
    vtkWarningMacro(
      "Nothing is drawn: Cell Compositing needs 3-D cells that are visible and have a volume, and the input has none. "
      "Choose the representation Surface or Textured Splats, or make cells by Delaunay 3D.");
  }
  this->HadNoVolume = hasNoVolume;
}

bool vtkCellCompositingRepresentation::DrawsBlock(vtkDataObject* block) const
{
  return block->GetNumberOfElements(vtkDataObject::CELL) > 0 && !vtkPolyData::SafeDownCast(block);
}

bool vtkCellCompositingRepresentation::HoldsMedium(vtkDataSet* data) const
{
  return data->GetNumberOfCells() > 0;
}

int vtkCellCompositingRepresentation::GetUniformAssociation() const
{
  return vtkDataObject::CELL;
}

void vtkCellCompositingRepresentation::PrepareMapper(vtkDataSet* cells)
{
  this->Superclass::PrepareMapper(cells);
  this->Mapper->SetOpacityArrayName(this->PrepareOpacity(cells));
  this->Mapper->SetOpacityScale(this->OpacityScale * this->Opacity);
  this->Mapper->SetVisibilityOrder(
    this->VisibilityOrder); // while the camera moves too: rays need no sorting
  this->Mapper->SetCellInterpolation(this->ChooseInterpolation(cells));
  // Without these arrays nothing is found: cells of other numbers must not be selected.
  this->Mapper->SetCellIdArrayName(this->HasOwnNumbers ? "" : nephoscope::pickedCellsName);
  this->Mapper->SetPointIdArrayName(this->HasOwnNumbers ? "" : nephoscope::pickedPointsName);
  this->Mapper->SetCompositeIdArrayName(this->HasOwnNumbers ? "" : nephoscope::pickedBlocksName);
  this->PrepareContours();
  this->PrepareMaterial();
  this->PreparePolygons();
  this->PrepareLayers();
}

// Smoke is as opaque as it is dense.
vtkDataArray* vtkCellCompositingRepresentation::FindOpacityArray(
  vtkDataSet* cells, int& association)
{
  if (this->DrawsSmoke(cells))
  {
    association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    return nephoscope::SmokeDensity(cells);
  }
  return this->Superclass::FindOpacityArray(cells, association);
}

void vtkCellCompositingRepresentation::SetMethod(int method)
{
  this->Mapper->SetMethod(method);
}

void vtkCellCompositingRepresentation::SetIntegration(int integration)
{
  this->Mapper->SetIntegration(integration);
}

void vtkCellCompositingRepresentation::SetCellInterpolation(int interpolation)
{
  this->CellInterpolation = interpolation; // the mapper gets it before each render
}

void vtkCellCompositingRepresentation::SetVisibilityOrder(int order)
{
  this->VisibilityOrder = order; // the mapper gets it before each render
}

void vtkCellCompositingRepresentation::SetSplitAtControlPoints(bool split)
{
  this->Mapper->SetSplitAtControlPoints(split);
}

void vtkCellCompositingRepresentation::SetAutoAdjustSampleDistances(bool adjust)
{
  this->Mapper->SetAutoAdjustSampleDistances(adjust);
}

void vtkCellCompositingRepresentation::SetMaximumImageSampleDistance(double distance)
{
  this->Mapper->SetMaximumImageSampleDistance(distance);
}

void vtkCellCompositingRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VisibilityOrder: " << this->VisibilityOrder << "\n";
  os << indent << "CellInterpolation: " << this->CellInterpolation << "\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
