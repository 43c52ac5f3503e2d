// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkFlowVolume that follows a time series: which time step is read next, and what is
// done with it.
//
//   RequestInformation    the times of the series
//   RequestUpdateExtent   PlanReading: begin anew, go on, or nothing to read
//   RequestData           ReadTimeStep, BeginStreak once, AdvanceStreak; again
//                         (CONTINUE_EXECUTING) until the requested time lies within the steps
//                         that have been read; WriteStreak
#include "vtkFlowVolume.h"

#include "ArrayBlend.h"
#include "ChangeOfInput.h"
#include "DataSets.h"
#include "FlowVolumeExchange.h"
#include "FlowVolumeState.h"
#include "SmokeData.h"
#include "SmokeOutput.h"
#include "TemporalField.h"
#include "TimeUnit.h"
#include "WholeVolume.h"

#include "vtkBoundingBox.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
constexpr double advancingShare = 0.9; // of the time, about; the rest is interpolating arrays

std::vector<nephoscope::CellHint> HintsOfSecond(std::vector<nephoscope::CellHint> hints)
{
  for (nephoscope::CellHint& hint : hints)
  {
    hint.Cell = hint.SecondCell;
    hint.Block = hint.SecondBlock;
  }
  return hints;
}
}

vtkTypeBool vtkFlowVolume::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto& state = *this->State;
  if (state.RestartsUpdate(request))
  {
    state.Streak = {};
    if (state.Continuing)
    {
      vtkErrorMacro("The input has not delivered the time step at "
        << state.NextTime() << ", so there is no volume at later times.");
      state.Stop(this->GetExecutive());
    }
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkFlowVolume::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->State->TakeTimes(inputs[0]->GetInformationObject(0)))
  {
    this->State->Streak = {};
  }
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

bool vtkFlowVolume::CheckSeries()
{
  const auto& times = this->State->Times;
  if (!this->Unsteady)
  {
    return true;
  }
  if (this->State->HasSeries && times.empty())
  {
    vtkErrorMacro(
      "The input's time series has no time steps, so there is no flow to follow. Check the reader's files, or "
      "switch Unsteady off.");
    return false;
  }
  if (times.size() < 2)
  {
    vtkWarningMacro("Unsteady needs a time series, but the input has "
      << (times.empty() ? "no time steps" : "one time step only")
      << ". The volume of the present, steady flow is made.");
    return true;
  }
  const std::size_t i = this->State->FirstOutOfOrder();
  if (i < times.size())
  {
    vtkErrorMacro("The times of the input's time steps must increase, but time step "
      << i << " is at " << times[i] << " after " << times[i > 0 ? i - 1 : 0]
      << ". Sort the time steps, or switch Unsteady off.");
    return false;
  }
  if (this->StartTime > times.back())
  {
    vtkErrorMacro("StartTime is " << this->StartTime << ", after the last time step, which is at "
                                  << times.back() << ". Choose an earlier one.");
    return false;
  }
  return true;
}

bool vtkFlowVolume::HasTimeSteps() const
{
  return this->Unsteady && this->State->Times.size() > 1;
}

// For a message about its data.
std::string vtkFlowVolume::NameOfTimeStep() const
{
  std::ostringstream name;
  if (this->HasTimeSteps())
  {
    name << " This is time step " << this->State->Next << ", at " << this->State->NextTime()
         << ": leave it out, or choose a later StartTime.";
  }
  return name.str();
}

double vtkFlowVolume::Seconds(double time) const
{
  const double scale = this->TimeScale > 0.0 ? this->TimeScale : this->State->Streak.TimeUnit;
  return (time - this->State->Times.front()) * scale;
}

double vtkFlowVolume::StartSeconds() const
{
  return std::max(this->State->Streak.StillUntil, this->Seconds(this->StartTime));
}

double vtkFlowVolume::RequestedSeconds() const
{
  return this->Seconds(std::min(this->State->Requested, this->State->Times.back()));
}

int vtkFlowVolume::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->HasTimeSteps())
  {
    this->PlanReading(outputs->GetInformationObject(0));
    inputs[0]->GetInformationObject(0)->Set(SDDP::UPDATE_TIME_STEP(), this->State->NextTime());
  }
  this->Exchange().RequestParts(inputs);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

void vtkFlowVolume::PlanReading(vtkInformation* output)
{
  auto& state = *this->State;
  auto& streak = state.Streak;
  const auto& times = state.Times;
  state.AwaitsData = true;
  if (state.Continuing)
  {
    return; // the next one has been chosen
  }
  state.Requested =
    output->Has(SDDP::UPDATE_TIME_STEP()) ? output->Get(SDDP::UPDATE_TIME_STEP()) : times.back();
  const vtkMTimeType newest = nephoscope::ChangeOfPipeline(this);
  const double seconds = this->RequestedSeconds();
  const bool isPast = streak.Volume && streak.Volume->IsAfter(seconds);
  if (!streak.Second || streak.MTime != newest || isPast)
  {
    streak = {};
    streak.MTime = newest;
    const auto after = std::upper_bound(times.begin(), times.end(), this->StartTime);
    state.Next = std::max(0, static_cast<int>(after - times.begin()) - 1);
  }
  else
  {
    const double read = times[static_cast<std::size_t>(streak.LastRead)];
    const bool isBehind = streak.Volume && !streak.Volume->IsAt(this->Seconds(read));
    const bool isRead = state.Requested <= read || isBehind; // the steps in memory are still needed
    const int last = static_cast<int>(times.size()) - 1;
    state.Next = std::min(last, streak.LastRead + (isRead ? 0 : 1));
  }
  this->MakeRoom();
}

// The last step read becomes the first of two, and what was first is freed before the input makes
// the next.
void vtkFlowVolume::MakeRoom()
{
  auto& streak = this->State->Streak;
  if (streak.LastRead != this->State->Next)
  {
    streak.First = std::move(streak.Second);
    streak.Second = nullptr;
  }
}

void vtkFlowVolume::MakeUnsteadyVolume(vtkInformation* request, vtkDataObject* input,
  vtkPolyData* given, vtkInformation* outputInformation)
{
  auto& state = *this->State;
  auto& streak = state.Streak;
  vtkUnstructuredGrid* output =
    vtkUnstructuredGrid::SafeDownCast(outputInformation->Get(vtkDataObject::DATA_OBJECT()));
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), state.Requested);
  state.AwaitsData = false;
  const bool goesOn =
    this->ReadTimeStep(input) && this->BeginStreak(given) && this->AdvanceStreak();
  if (!goesOn)
  {
    this->EndSeries(request);
    return;
  }
  const auto read = static_cast<std::size_t>(streak.LastRead);
  if (state.Requested > state.Times[read] && read + 1 < state.Times.size())
  {
    state.Next = streak.LastRead + 1;
    this->MakeRoom();
    state.GoOn(request);
    return;
  }
  state.End(request);
  if (this->RequestedSeconds() <= this->StartSeconds())
  {
    this->WarnOfNoSmokeYet();
    this->WriteBounds(output);
  }
  else if (streak.Volume)
  {
    this->WriteStreak(output);
  }
}

// Where the smoke will be, for cameras that are set before there is any.
void vtkFlowVolume::WriteBounds(vtkUnstructuredGrid* output) const
{
  const auto sets = nephoscope::DataSetsOf(this->State->Streak.Second->Data);
  double bounds[6];
  this->Exchange().BoundsOf(sets).GetBounds(bounds);
  nephoscope::PutBoundsToCome(output, bounds);
}

void vtkFlowVolume::EndSeries(vtkInformation* request)
{
  this->State->Streak = {};
  this->State->End(request);
}

bool vtkFlowVolume::ReadTimeStep(vtkDataObject* input)
{
  auto& streak = this->State->Streak;
  if (streak.LastRead == this->State->Next)
  {
    return true;
  }
  if (streak.LastRead < 0)
  {
    const auto units = this->Exchange().Gather({ nephoscope::SecondsInUnitOfTime(input) });
    const double told = *std::max_element(units.begin(), units.end()); // a rank may have no data
    streak.TimeUnit = told > 0.0 ? told : 1.0;
  }
  streak.Second = this->MakeField(input);
  streak.LastRead = this->State->Next;
  const auto missing = streak.Second ? this->CountMissing(*streak.Second) : streak.Missing;
  if (missing.Missing > streak.Missing.Missing)
  {
    streak.Missing = missing;
    streak.MissingTime = this->State->NextTime();
  }
  if (streak.Volume)
  {
    streak.Volume->TurnHints();
  }
  return streak.Second != nullptr;
}

// Puts the polygon into the flow, once the steps around the start time have been read.
bool vtkFlowVolume::BeginStreak(vtkPolyData* given)
{
  auto& state = *this->State;
  auto& streak = state.Streak;
  const double start = this->StartSeconds();
  const double read = this->Seconds(state.Times[static_cast<std::size_t>(streak.LastRead)]);
  if (streak.Volume || start > read || (!streak.First && start < read))
  {
    return true;
  }
  const bool isLast = read == this->Seconds(state.Times.back());
  const bool isStill =
    this->IsStill(*streak.Second) && (!streak.First || this->IsStill(*streak.First));
  if (isStill && !isLast)
  {
    streak.WasStill = true;
    streak.StillUntil = read;
    return true;
  }
  const double placed = streak.WasStill ? read : start; // when the polygon is turned to the flow
  const auto velocity = this->StreakVelocity();
  nephoscope::PolygonMesh polygon;
  if (!this->MakePolygon(*streak.Second, *velocity, placed, given, polygon))
  {
    return false;
  }
  if (!this->CheckPlace(
        *streak.Second, polygon, nephoscope::PolygonFlow(*velocity, polygon, placed)))
  {
    return false;
  }
  const double followed = this->Seconds(state.Times.back()) - start;
  nephoscope::StreakSettings settings;
  settings.StartTime = start;
  settings.TimeStep = this->TimeStep > 0.0 ? this->TimeStep
    : followed > 0.0                       ? followed / 64.0
                                           : 1.0;
  settings.Duration = this->Duration;
  settings.MaximumTurnAngle = vtkMath::RadiansFromDegrees(this->MaximumTurnAngle);
  settings.MaximumHalvings = this->MaximumHalvings;
  settings.ObstacleSize =
    this->ObstacleSize > 0.0 ? this->ObstacleSize : streak.Second->BlankedSize;
  settings.MaximumNumberOfTetrahedra = static_cast<std::size_t>(this->MaximumNumberOfTetrahedra);
  if (!this->CheckNumberOfSteps(followed, settings.TimeStep))
  {
    return false;
  }
  const auto coarser = [&](double edge) {
    nephoscope::PolygonMesh remade;
    this->TriangulatePolygon(*streak.Second, *velocity, placed, given, edge, remade);
    return remade;
  };
  streak.IsCoarser = nephoscope::FitReleases(polygon, settings, followed, coarser);
  const nephoscope::PolygonFlow flow(*velocity, polygon, placed);
  this->WarnOfTimeScale(streak.WasStill ? 0.0 : flow.MeanSpeed);
  streak.PolygonEdgeLength = flow.LongestEdge;
  // Edges of the polygon are not divided, so tetrahedra beside them cannot get shorter edges.
  settings.MaximumEdgeLength = this->MaximumEdgeLength > 0.0
    ? std::max(this->MaximumEdgeLength, flow.LongestEdge)
    : 3.0 * std::max(flow.LongestEdge, flow.MeanSpeed * settings.TimeStep);
  settings.MinimumEdgeLength = this->MinimumEdgeLength;
  settings.ObstacleEdge =
    this->ObstacleLevels > 0 ? std::ldexp(settings.MaximumEdgeLength, -this->ObstacleLevels) : 0.0;
  settings.FarthestObstacle = streak.Second->Diagonal;
  settings.Adaptive = this->Integrator == RUNGE_KUTTA_45;
  settings.Tolerance = this->Tolerance * flow.LongestEdge;
  streak.Normal = flow.Normal;
  streak.Volume = std::make_unique<nephoscope::StreakVolume>(polygon, settings);
  return true;
}

std::unique_ptr<nephoscope::VelocityField> vtkFlowVolume::StreakVelocity() const
{
  const auto& streak = this->State->Streak;
  const auto time = [&](int step) {
    return this->Seconds(this->State->Times[static_cast<std::size_t>(std::max(0, step))]);
  };
  const auto& first = streak.First ? streak.First : streak.Second;
  return std::make_unique<nephoscope::TemporalField>(*first->Field,
    time(streak.First ? streak.LastRead - 1 : streak.LastRead), *streak.Second->Field,
    time(streak.LastRead));
}

// To the requested time or, if that is later, to the last step read. Stops are the steps and the
// times of release, whatever times are requested, so that an animation and a direct request give
// the same.
bool vtkFlowVolume::AdvanceStreak()
{
  auto& streak = this->State->Streak;
  const double read = this->Seconds(this->State->Times[static_cast<std::size_t>(streak.LastRead)]);
  const double requested = this->RequestedSeconds();
  if (!streak.Volume || requested < this->StartSeconds())
  {
    return true;
  }
  const auto velocity = this->StreakVelocity();
  const double start = this->StartSeconds();
  const auto report = [&](double now) {
    return this->Report(advancingShare * (now - start) / std::max(requested - start, 1e-300));
  };
  return requested < read ? streak.Volume->AdvanceToLastRelease(*velocity, requested, report)
                          : streak.Volume->AdvanceTo(*velocity, read, report);
}

nephoscope::SmokeMesh vtkFlowVolume::StreakMeshAt(double seconds)
{
  const auto& streak = this->State->Streak;
  if (streak.Volume->IsAt(seconds))
  {
    return streak.Volume->Mesh();
  }
  const auto toTheEnd = [](double) { return true; };
  nephoscope::StreakVolume shown = *streak.Volume; // which itself stops where every animation does
  shown.AdvanceTo(*this->StreakVelocity(), seconds, toTheEnd);
  return shown.Mesh();
}

void vtkFlowVolume::WriteStreak(vtkUnstructuredGrid* output)
{
  const auto& streak = this->State->Streak;
  const double requested = this->RequestedSeconds();
  auto mesh = this->StreakMeshAt(requested);
  const bool isNone = mesh.Report.EmittedMass == 0.0;
  if (isNone && !mesh.Report.LimitReached)
  {
    vtkWarningMacro(
      "No smoke has come from the generating polygon: there the flow has been zero or parallel to it. Move or turn it.");
  }
  else if (!isNone && mesh.Tetrahedra.empty())
  {
    vtkWarningMacro(
      "All smoke has left the data, met blanked cells or values that are not numbers, or is older than Duration.");
  }
  this->WarnOfNoDataYet();
  std::copy_n(streak.Normal.begin(), 3, this->NormalUsed);
  this->DurationUsed = mesh.Report.FollowedTime;
  this->TimeStepUsed = streak.Volume->TimeStep();
  this->MaximumEdgeLengthUsed = streak.Volume->MaximumEdgeLength();
  if (mesh.Report.LimitReached)
  {
    this->WarnOfLimit();
  }
  else if (streak.IsCoarser)
  {
    this->WarnOfCoarsening(streak.PolygonEdgeLength, false);
  }
  else if (mesh.Report.Coarser)
  {
    this->WarnOfLongEdges();
  }
  this->WarnOfLoss(mesh.Report);
  this->EmittedMass = this->InitialDensity * mesh.Report.EmittedMass;
  this->LostMass = this->InitialDensity * mesh.Report.LostMass;
  this->ObstacleMass = this->InitialDensity * mesh.Report.ObstacleMass;
  this->ExpiredMass = this->InitialDensity * mesh.Report.ExpiredMass;
  this->WriteOutput(
    mesh,
    [&](const nephoscope::SmokeMesh& smoke, vtkPointData* arrays) {
      this->SampleStreakArrays(smoke, arrays);
    },
    output);
}

// The arrays of the step at the requested time, or what lies between the steps around it.
void vtkFlowVolume::SampleStreakArrays(const nephoscope::SmokeMesh& mesh, vtkPointData* arrays)
{
  const auto& streak = this->State->Streak;
  const auto& times = this->State->Times;
  const auto last = static_cast<std::size_t>(streak.LastRead);
  const double requested = std::min(this->State->Requested, times.back());
  const auto hints = streak.First ? HintsOfSecond(mesh.Hints) : mesh.Hints;
  const std::size_t count = mesh.Points.size();
  streak.Second->Field->SampleArrays(count, mesh.Points.data(), hints.data(), arrays);
  if (streak.First && requested < times[last])
  {
    vtkNew<vtkPointData> before;
    streak.First->Field->SampleArrays(count, mesh.Points.data(), mesh.Hints.data(), before);
    nephoscope::BlendArrays(
      before, (requested - times[last - 1]) / (times[last] - times[last - 1]), arrays);
  }
}
