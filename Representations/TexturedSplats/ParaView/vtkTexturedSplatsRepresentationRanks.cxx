// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How several ranks draw one picture: each in its region, with the splats of others that reach into
// it, and by common measures.
#include "vtkTexturedSplatsRepresentation.h"

#include "ForwardedMessages.h"
#include "RankRegions.h"
#include "ReportedError.h"
#include "SplatKernel.h"
#include "SplatMeeting.h"
#include "SplatPieces.h"
#include "SplatVectorColors.h"
#include "vtkTexturedSplatMapper.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkTexturedSplatsRepresentation);

struct vtkTexturedSplatsRepresentation::vtkMeeting
{
  using Regions = std::vector<nephoscope::SplatRegion>;
  using Reaches = std::tuple<double, double, bool, bool, double, double, double>;
  // Delivered piece, its time, regions, the array of vectors.
  using CommonsKey = std::tuple<vtkDataSet*, vtkMTimeType, Regions, std::string>;

  CommonsKey MetFor;
  Reaches ReachedFor;
  nephoscope::SplatCommons Commons;
  nephoscope::ReportedError LongVectors;
  double Share = 1.0; // of the samples whose vectors are drawn
  vtkSmartPointer<vtkDataSet> Complete;
  vtkNew<vtkUnstructuredGrid> Nothing; // of a rank to which nothing was delivered
};

vtkTexturedSplatsRepresentation::vtkTexturedSplatsRepresentation()
  : DefaultColors(new nephoscope::DefaultVectorColors)
  , Meeting(new vtkMeeting)
{
  // On several ranks samples travel without the cells between them and without their grid; pictures
  // on one are the same.
  this->Mapper->InterpolateScalarsBeforeMappingOff();
  this->Mapper->OrderByLayersOff();
  this->Actor->SetMapper(this->Mapper);
  nephoscope::ForwardMessages(this->Mapper, this);
  this->SpeedKey->SetVolume(this->Actor);
  this->SpeedKey->SetFilmUnit("unit of animation time");
  this->SpeedKey->SetPosition(0.2, 0.03); // beside the orientation axes
  this->SpeedKey->VisibilityOff();
  this->Mapper->SetShapeArrayName(nephoscope::splatShapeName); // where there is one
}

vtkTexturedSplatsRepresentation::~vtkTexturedSplatsRepresentation() = default;

namespace
{
// Empty where ranks do not draw in regions of their own.
std::vector<nephoscope::SplatRegion> RegionsOf(vtkView* view)
{
  const std::vector<vtkBoundingBox>* boxes = nephoscope::BoxesOfRanks(view);
  return boxes ? nephoscope::RegionsOfRanks(*boxes) : std::vector<nephoscope::SplatRegion>();
}

bool OnAnyRank(bool here)
{
  const int mine = here ? 1 : 0;
  int any = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &mine, &any, 1, vtkCommunicator::MAX_OP);
  return any != 0;
}

double LeastOverRanks(double mine)
{
  double least = mine;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &mine, &least, 1, vtkCommunicator::MIN_OP);
  return least;
}
}

vtkDataSet* vtkTexturedSplatsRepresentation::CompletePiece(vtkDataSet* data, vtkInformation*)
{
  if (GetNumberOfRanks() < 2)
  {
    return data;
  }
  vtkMeeting& meeting = *this->Meeting;
  vtkDataSet* piece = data ? data : meeting.Nothing.Get();
  const vtkMeeting::Regions regions = RegionsOf(this->GetView());
  const vtkMeeting::CommonsKey key(
    piece, piece->GetMTime(), regions, this->Mapper->GetVectorArrayName());
  const bool met = !OnAnyRank(key != meeting.MetFor);
  if (!met)
  {
    meeting.Commons = nephoscope::FindSplatCommons(piece, this->Mapper->GetVectorArrayName());
    meeting.MetFor = key;
  }
  meeting.Share = LeastOverRanks(this->GetShareOf(piece)); // 1 where nothing was delivered
  this->UseCommons(regions);
  const nephoscope::SplatReaches reaches = this->GetReaches();
  const vtkMeeting::Reaches reached(reaches.KernelRadius, reaches.RadiusFactor, reaches.Vectors,
    reaches.Look.Segments, reaches.Look.Unit, reaches.Look.StreakPeriod,
    reaches.Look.SegmentLength);
  if (!met || reached != meeting.ReachedFor) // settings are the same on all ranks
  {
    meeting.Complete = regions.empty() ? vtkSmartPointer<vtkDataSet>(piece)
                                       : nephoscope::WithNeighbors(piece, regions, reaches);
    meeting.ReachedFor = reached;
  }
  return meeting.Complete;
}

// The mapper tells it on one rank.
void vtkTexturedSplatsRepresentation::WarnOfLongVectors(const std::string& text)
{
  if (this->Meeting->LongVectors.IsNew(text) && GetNumberOfRanks() > 1 && IsFirstRank())
  {
    vtkWarningMacro(<< text);
  }
}

void vtkTexturedSplatsRepresentation::UseCommons(
  const std::vector<nephoscope::SplatRegion>& regions)
{
  const nephoscope::SplatCommons& commons = this->Meeting->Commons;
  const auto rank =
    static_cast<std::size_t>(vtkMultiProcessController::GetGlobalController()->GetLocalProcessId());
  nephoscope::SplatRegion region = rank < regions.size() ? regions[rank] : nephoscope::WholeSpace;
  this->Mapper->SetRegion(region.data());
  this->Mapper->SetCommonFrame(commons.Origin, commons.LongestEdge, commons.MostSamples);
  this->Mapper->SetMaximumSpeed(
    this->GreatestSpeed > 0.0 ? this->GreatestSpeed : commons.MaximumSpeed);
  const double unit =
    commons.MeanCell / std::cbrt(std::max(this->Meeting->Share, 1e-6)); // as the mapper does
  this->Mapper->SetVectorUnit(this->VectorUnit > 0.0 ? this->VectorUnit : unit);
}

nephoscope::SplatReaches vtkTexturedSplatsRepresentation::GetReaches()
{
  nephoscope::SplatReaches reaches;
  reaches.KernelRadius =
    nephoscope::KernelRadius(static_cast<nephoscope::SplatKernel>(this->Mapper->GetKernel()));
  reaches.RadiusFactor = this->Mapper->GetRadiusFactor();
  reaches.Vectors = !this->Mapper->GetVectorArrayName().empty();
  reaches.Look.Segments = this->Mapper->GetVectorStyle() == vtkTexturedSplatMapper::SEGMENTS;
  reaches.Look.Unit = this->Mapper->GetVectorUnit();
  reaches.Look.StreakPeriod = this->Mapper->GetStreakPeriod();
  reaches.Look.SegmentLength = this->Mapper->GetSegmentLength();
  return reaches;
}
