// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How vectors look on the splats: what the mapper does, and what suits them to a medium.
#include "vtkTexturedSplatsRepresentation.h"

#include "DataBlocks.h"
#include "RankMeasures.h"
#include "SplatMeasures.h"
#include "SplatMeeting.h"
#include "SplatShapes.h"
#include "SplatVectorBounds.h"
#include "vtkTexturedSplatMapper.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <string>

namespace
{
// Travels with the data, so that every time step keeps its own.
const char* const suitedName = "NephoscopeSuitedVectors";

double StoredNumber(vtkDataSet* data, vtkIdType index, double otherwise)
{
  vtkDataArray* numbers = data ? data->GetFieldData()->GetArray(suitedName) : nullptr;
  return numbers && numbers->GetNumberOfTuples() > index ? numbers->GetComponent(index, 0)
                                                         : otherwise;
}
}

void vtkTexturedSplatsRepresentation::SetVectorOpacity(double opacity)
{
  this->VectorOpacity = opacity;
}

void vtkTexturedSplatsRepresentation::SetVectorShare(double share)
{
  this->VectorShare = share;
}

void vtkTexturedSplatsRepresentation::SetUseVectorColor(int use)
{
  this->UseVectorColor = use;
}

void vtkTexturedSplatsRepresentation::SetVectorColor(double red, double green, double blue)
{
  this->VectorColor = { { red, green, blue } };
}

bool vtkTexturedSplatsRepresentation::DrawsMedium()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name =
    info && info->Has(vtkDataObject::FIELD_NAME()) ? info->Get(vtkDataObject::FIELD_NAME()) : "";
  vtkPiecewiseFunction* opacity = this->Property->GetScalarOpacity();
  bool isDrawn = !name || !*name; // of one colour
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    isDrawn = isDrawn || node[1] > 0.0;
  }
  return isDrawn && this->Opacity * this->OpacityScale > 0.0;
}

// Called by all ranks.
void vtkTexturedSplatsRepresentation::StoreSuited(
  const nephoscope::SplatSampling& sampling, const std::array<double, 6>& common)
{
  const std::string name = this->Mapper->GetVectorArrayName();
  if (name.empty())
  {
    return;
  }
  vtkDataSetAttributes* attributes =
    this->Piece->GetAttributes(sampling.OnCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  vtkDataArray* vectors = attributes->GetArray(name.c_str());
  const nephoscope::SpeedCounts speeds =
    nephoscope::SpeedsOfRanks(nephoscope::CountSpeeds(this->Piece, sampling, vectors));
  this->WarnOfLongVectors(this->GreatestSpeed > 0.0 ? "" : speeds.DescribeLong(name));
  const double full = this->GreatestSpeed > 0.0 ? this->GreatestSpeed : speeds.GetFull();
  const auto all = nephoscope::ReduceOverRanks(
    nephoscope::MeasureSplats(this->Piece, sampling, vectors, {}, common, full));
  const auto suited = nephoscope::SuitVectorsTo(all, common, full, speeds.GetNumber());
  nephoscope::StoreNumbers(this->Piece, suitedName, { suited.Opacity, suited.Share });
}

double vtkTexturedSplatsRepresentation::GetShareOf(vtkDataSet* data)
{
  const bool isSuited = this->Mapper->GetVectorStyle() == vtkTexturedSplatMapper::STREAKS;
  return this->VectorShare > 0.0 ? this->VectorShare : isSuited ? StoredNumber(data, 1, 1.0) : 1.0;
}

void vtkTexturedSplatsRepresentation::SuitVectors(vtkDataSet* data)
{
  constexpr double alone = 2.0;
  const bool medium = this->DrawsMedium();
  this->Mapper->SetVectorFraction(this->GetShareOf(data));
  this->Mapper->SetVectorOpacity(this->VectorOpacity > 0.0 ? this->VectorOpacity
      : medium                                             ? StoredNumber(data, 0, alone)
                                                           : alone);
  const bool contrasts = this->UseVectorColor == AUTOMATIC_COLOR && medium &&
    this->Mapper->GetVectorColorArrayName().empty();
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (contrasts && view)
  {
    vtkRenderer* renderer = view->GetRenderer();
    this->Mapper->SuitVectorColor(this->Actor->GetProperty(), renderer->GetBackground(),
      renderer->GetGradientBackground() ? renderer->GetBackground2() : renderer->GetBackground());
    return;
  }
  this->Mapper->SetUseVectorColor(this->UseVectorColor == ONE_COLOR);
  this->Mapper->SetVectorColor(this->VectorColor.data());
}

// A second of the mapper's film is a unit of the animation time or, where no scale is given, the
// time of a cycle.
void vtkTexturedSplatsRepresentation::MoveVectors()
{
  this->Mapper->SetPhase(this->GetPhaseNow());
  this->Mapper->SetTrueSpeed(this->TrueSpeed);
  this->Mapper->SetTimeScale(this->TimeScale / this->LengthUnit); // in the unit of the vectors
  const double unit =
    this->TimeScale > 0.0 ? 1.0 : this->GetLoopTime() / this->Mapper->GetPhaseCycles();
  const double time = this->MoveWithTime ? this->GetUpdateTime() - this->InputTimes[0] : 0.0;
  this->Mapper->SetFilmTime(time / unit);
  this->SpeedKey->SetFilmUnitSeconds(1.0 / unit);
}

bool vtkTexturedSplatsRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetNonCompositedRenderer()->AddViewProp(this->SpeedKey);
  }
  return this->Superclass::AddToView(view);
}

bool vtkTexturedSplatsRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetNonCompositedRenderer()->RemoveViewProp(this->SpeedKey);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkTexturedSplatsRepresentation::SetVectorUnit(double length)
{
  this->VectorUnit = length;
  this->Mapper->SetVectorUnit(length); // several ranks decide anew
}

void vtkTexturedSplatsRepresentation::SetVectorColorFunction(vtkScalarsToColors* function)
{
  this->VectorColorFunction = function;
}

void vtkTexturedSplatsRepresentation::SetLengthUnit(double metres)
{
  this->SpeedKey->SetLengthUnit(metres);
  this->LengthUnit = this->SpeedKey->GetLengthUnit(); // clamped
}

void vtkTexturedSplatsRepresentation::SetVectorColorArray(const char* name)
{
  const std::string chosen = name ? name : "";
  const std::string array = chosen == "None" ? std::string() : chosen;
  if (array != this->Mapper->GetVectorColorArrayName())
  {
    this->Mapper->SetVectorColorArrayName(array);
    this->MarkModified(); // the range of the default colours is of all ranks
  }
}
