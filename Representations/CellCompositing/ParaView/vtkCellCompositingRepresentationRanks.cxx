// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How several ranks draw one picture: each the part of every ray that is in its region, through
// whole cells.
#include "vtkCellCompositingRepresentation.h"

#include "CellMeasures.h"
#include "DataBlocks.h"
#include "RankContours.h"
#include "RankDivisions.h"
#include "RankRegions.h"
#include "TetrahedraAmongCells.h"
#include "VolumetricCells.h"
#include "vtkCellCompositingMapper.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeRepresentation.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPlane.h"
#include "vtkUnstructuredGrid.h"
#include "vtkView.h"

#include <cmath>
#include <vector>

namespace
{
constexpr const char* formName = "NephoscopeFormOfCells";

bool EndsRays(int method)
{
  return method != vtkCellCompositingMapper::TRIANGLES_LINEAR_METHOD &&
    method != vtkCellCompositingMapper::TRIANGLES_TABLE_METHOD &&
    method != vtkCellCompositingMapper::FACES_METHOD;
}

void AddCellsTo(vtkBoundingBox& box, vtkDataSet* piece)
{
  if (piece && piece->GetNumberOfCells() > 0)
  {
    const nephoscope::MediumBounds bounds = nephoscope::BoundsOfCells(piece);
    box.AddBounds(bounds.data());
  }
}

// By more than rounding: neighbours share a face.
bool Overlap(vtkBoundingBox a, const vtkBoundingBox& b)
{
  const double rounding = 1e-6 * a.GetMaxLength();
  return a.IsValid() && b.IsValid() && a.IntersectBox(b) && a.GetLength(0) > rounding &&
    a.GetLength(1) > rounding && a.GetLength(2) > rounding;
}

// All ranks call it, each with a box of its own.
bool DoAnyOverlap(const vtkBoundingBox& box)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  double mine[6];
  box.GetBounds(mine);
  std::vector<double> all(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(mine, all.data(), 6);
  for (std::size_t i = 0; i < all.size(); i += 6)
  {
    for (std::size_t j = 0; j < i; j += 6)
    {
      if (Overlap(vtkBoundingBox(&all[i]), vtkBoundingBox(&all[j])))
      {
        return true;
      }
    }
  }
  return false;
}
}

// Ranks are ordered by the boxes about all grids that stay on them. There is no order where the
// pieces of several grids make these overlap.
bool vtkCellCompositingRepresentation::HasSeveralGrids() const
{
  vtkBoundingBox box;
  AddCellsTo(box, this->Piece);
  bool others = false;
  vtkView* view = this->GetView();
  for (int i = 0; view && i < view->GetNumberOfRepresentations(); ++i)
  {
    vtkDataRepresentation* shown = view->GetRepresentation(i);
    if (auto* choice = vtkCompositeRepresentation::SafeDownCast(shown))
    {
      shown = choice->GetActiveRepresentation();
    }
    auto* other = vtkCellCompositingRepresentation::SafeDownCast(shown);
    if (other && other != this && other->GetVisibility() && other->KeepsPiece)
    {
      AddCellsTo(box, other->Piece);
      others = true;
    }
  }
  return others && DoAnyOverlap(box);
}

void vtkCellCompositingRepresentation::MovePiece(vtkMatrix4x4* matrix)
{
  this->Superclass::MovePiece(matrix);
  const bool aligned =
    this->Piece->GetNumberOfCells() == 0 || nephoscope::IsAxisAligned(this->Piece);
  if (this->AxisAligned && MinimumOverRanks(aligned ? 1 : 0) == 0)
  {
    this->AxisAligned = false;
    this->MakeListOfCells();
  }
}

void vtkCellCompositingRepresentation::FinishPiece()
{
  if (GetNumberOfRanks() == 1)
  {
    return;
  }
  const std::string chosen = this->Mapper->GetContourArrayName();
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const char* name = chosen.c_str();
  const bool isFound = !chosen.empty() || this->FindColorArray(this->Piece, association, name);
  const bool onPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->HasGradients = this->NeedsGradients();
  nephoscope::StoreRankContours(
    this->Piece, isFound && onPoints ? name : nullptr, !chosen.empty(), this->HasGradients);
}

// Cells that the view may spread over ranks, which all draw the same kind of field.
void vtkCellCompositingRepresentation::MakeListOfCells()
{
  const vtkSmartPointer<vtkUnstructuredGrid> cells = nephoscope::VisibleCells(this->Piece);
  if (GetNumberOfRanks() > 1)
  {
    nephoscope::StoreRankDivisions(cells);
  }
  const auto mine = nephoscope::FormOfWholeCells(cells);
  using Form = nephoscope::WholeCells;
  const bool canBeTrilinear = MinimumOverRanks(mine == Form::Tetrahedra ? 0 : 1) == 1;
  const bool isWarped = MinimumOverRanks(mine == Form::Trilinear ? 0 : 1) == 0;
  const bool mostAreTetrahedra =
    SumOverRanks(static_cast<double>(nephoscope::TetrahedraBeyondOthers(cells))) > 0;
  const Form all = !canBeTrilinear   ? Form::Tetrahedra
    : isWarped || !mostAreTetrahedra ? Form::Trilinear
                                     : Form::Either;
  this->Piece = cells;
  nephoscope::StoreNumbers(cells, formName, { static_cast<double>(all) });
}

void vtkCellCompositingRepresentation::DescribePiece(vtkInformation* inInfo)
{
  if (this->AxisAligned && GetNumberOfRanks() > 1 && this->HasSeveralGrids())
  {
    this->AxisAligned = false;
    this->MakeListOfCells();
  }
  this->KeepsPiece = this->AxisAligned;
  this->Superclass::DescribePiece(inInfo);
  if (MinimumOverRanks(this->Piece->GetNumberOfCells() == 0 ? 1 : 0) == 1)
  {
    return; // without bounds it has no part in the regions of the ranks
  }
  if (this->AxisAligned)
  {
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
    return;
  }
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
    vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  // Every rank gets all cells that reach into its region, whole, and ends its rays at the borders.
  vtkPVRenderView::SetRedistributionModeToDuplicateBoundaryCells(inInfo, this);
}

vtkDataSet* vtkCellCompositingRepresentation::CompletePiece(vtkDataSet* data, vtkInformation*)
{
  // A method that cannot end rays draws each cell on the rank that owns it.
  const bool divided = data && GetNumberOfRanks() > 1 && !this->AxisAligned &&
    EndsRays(this->Mapper->GetMethod()) && nephoscope::BoxesOfRanks(this->GetView()) != nullptr;
  this->EndRaysAt(divided ? nephoscope::RegionOfRank(this->GetView()) : nephoscope::wholeSpace);
  if (!divided)
  {
    return data;
  }
  if (data != this->Delivered || data->GetMTime() != this->DeliveredTime)
  {
    this->Complete = nephoscope::WithoutGhosts(data);
    this->Delivered = data;
    this->DeliveredTime = data->GetMTime();
  }
  return this->Complete;
}

void vtkCellCompositingRepresentation::EndRaysAt(const std::array<double, 6>& region)
{
  if (region == this->Region)
  {
    return;
  }
  this->Region = region;
  this->Mapper->RemoveAllClippingPlanes();
  for (std::size_t side = 0; side < 6; ++side)
  {
    if (std::isfinite(region[side]))
    {
      double origin[3] = { 0, 0, 0 }, normal[3] = { 0, 0, 0 };
      origin[side / 2] = region[side];
      normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0; // inwards
      vtkNew<vtkPlane> border;
      border->SetOrigin(origin);
      border->SetNormal(normal);
      this->Mapper->AddClippingPlane(border);
    }
  }
}

// The same on one rank and on several, where each has other cells.
int vtkCellCompositingRepresentation::ChooseInterpolation(vtkDataSet* cells) const
{
  using Form = nephoscope::WholeCells;
  constexpr int automatic = vtkCellCompositingMapper::AUTOMATIC_INTERPOLATION;
  constexpr int tetrahedra = vtkCellCompositingMapper::TETRAHEDRA_INTERPOLATION;
  vtkDataArray* stored = cells->GetFieldData()->GetArray(formName);
  if (!stored)
  {
    return this->CellInterpolation;
  }
  const auto form = static_cast<Form>(static_cast<int>(stored->GetComponent(0, 0)));
  if (form == Form::Tetrahedra)
  {
    return tetrahedra;
  }
  const int byDefault =
    form == Form::Trilinear ? vtkCellCompositingMapper::TRILINEAR_INTERPOLATION : tetrahedra;
  return this->CellInterpolation == automatic ? byDefault : this->CellInterpolation;
}
