// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkFlowVolume that makes the volume of a steady flow.
#include "vtkFlowVolume.h"

#include "ChangeOfInput.h"
#include "FlowVolumeExchange.h"
#include "FlowVolumeState.h"
#include "PolygonFlow.h"
#include "WholeVolume.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
// So much that the picture shows it: paths have corners, or folds of the smoke are missing.
bool IsMuchCoarser(const nephoscope::WholeVolume& whole,
  const nephoscope::FlowVolumeSettings& automatic, const nephoscope::PolygonFlow& flow)
{
  constexpr double longSteps = 4.0, longEdges = 8.0;
  return whole.Settings.TimeStep > longSteps * automatic.TimeStep ||
    whole.Settings.MaximumEdgeLength > longEdges * automatic.MaximumEdgeLength ||
    whole.PolygonEdgeLength > longEdges * flow.LongestEdge;
}
}

void vtkFlowVolume::MakeSteadyVolume(
  vtkDataObject* input, vtkPolyData* given, vtkUnstructuredGrid* output)
{
  constexpr double anyTime = 0.0;
  const auto field = this->MakeField(input);
  nephoscope::PolygonMesh polygon;
  if (!field || !this->MakePolygon(*field, *field->Field, anyTime, given, polygon))
  {
    return;
  }
  const nephoscope::PolygonFlow flow(*field->Field, polygon, anyTime);
  nephoscope::FlowVolumeSettings settings;
  if (!this->CheckPlace(*field, polygon, flow) || !this->CheckFlow(*field, flow) ||
    !this->FindSettings(*field, flow, settings))
  {
    return;
  }
  const auto coarser = [&](double edge) {
    nephoscope::PolygonMesh remade;
    this->TriangulatePolygon(*field, *field->Field, anyTime, given, edge, remade);
    return remade;
  };
  auto whole =
    nephoscope::BuildWholeVolume(*field->Field, polygon, settings, anyTime, this->Duration == 0.0,
      coarser, [this](double share) { return this->Report(nephoscope::buildingShare * share); });
  this->ReportSteady(whole);
  const bool isMissing = this->WarnOfMissing(*field);
  this->WarnOfObstacles(whole.Mesh.Report, this->Exchange().AnyTrue(isMissing));
  this->WarnOfLeaving(whole.Mesh, *field);
  if (whole.IsCoarser && !this->HasTooManySteps(settings.Duration) &&
    !whole.Mesh.Report.LimitReached && !whole.Mesh.Report.Stopped && !whole.Mesh.Tetrahedra.empty())
  {
    this->WarnOfCoarsening(whole.PolygonEdgeLength, IsMuchCoarser(whole, settings, flow));
  }
  this->WriteOutput(
    whole.Mesh,
    [&](const nephoscope::SmokeMesh& smoke, vtkPointData* arrays) {
      field->Field->SampleArrays(
        smoke.Points.size(), smoke.Points.data(), smoke.Hints.data(), arrays);
    },
    output);
}

// Another would make the smoke of a film longer and shorter. A flow that has become four times as
// fast or as slow needs another all the same.
double vtkFlowVolume::FindCrossingTime(
  const nephoscope::FlowField& field, const nephoscope::PolygonFlow& flow)
{
  constexpr double most = 4.0;
  nephoscope::CrossingTime& kept = this->State->Crossing;
  const nephoscope::CrossingTime now = { field.Diagonal / flow.MeanSpeed,
    nephoscope::ChangeOfPipeline(this) };
  if (this->Exchange().AnyTrue(now.Change != kept.Change || now.Seconds > most * kept.Seconds ||
        kept.Seconds > most * now.Seconds))
  {
    kept = now;
  }
  return kept.Seconds;
}

double vtkFlowVolume::UsualTimeStep(double duration) const
{
  return std::min(duration / 64.0, this->State->Crossing.Seconds / 32.0);
}

// So many that the longer steps make layers of smoke visible.
bool vtkFlowVolume::HasTooManySteps(double duration) const
{
  constexpr double most = 2.0;
  return this->TimeStep == 0.0 &&
    duration / maximumNumberOfSteps > most * this->UsualTimeStep(duration);
}

bool vtkFlowVolume::FindSettings(const nephoscope::FlowField& field,
  const nephoscope::PolygonFlow& flow, nephoscope::FlowVolumeSettings& settings)
{
  const double crossing = this->FindCrossingTime(field, flow);
  settings.Duration = this->Duration > 0.0 ? this->Duration : 0.5 * crossing;
  // However long the duration is, a step must not lead out of the data at once.
  const double automaticStep = std::max(
    this->UsualTimeStep(settings.Duration), 1.000001 * settings.Duration / maximumNumberOfSteps);
  settings.TimeStep = this->TimeStep > 0.0 ? this->TimeStep : automaticStep;
  settings.MaximumEdgeLength = this->MaximumEdgeLength > 0.0
    ? this->MaximumEdgeLength
    : std::max(3.0 * flow.LongestEdge, flow.MeanSpeed * settings.TimeStep);
  settings.MinimumEdgeLength = this->MinimumEdgeLength;
  settings.EdgeLevels = this->EdgeLevels;
  settings.MaximumTurnAngle = vtkMath::RadiansFromDegrees(this->MaximumTurnAngle);
  settings.MaximumAreaRatio = this->MaximumAreaRatio;
  settings.MaximumDivergence = this->MaximumDivergence;
  settings.MaximumHalvings = this->MaximumHalvings;
  settings.ObstacleLevels = this->ObstacleLevels;
  settings.ObstacleSize = this->ObstacleSize > 0.0 ? this->ObstacleSize : field.BlankedSize;
  settings.Adaptive = this->Integrator == RUNGE_KUTTA_45;
  settings.Tolerance = this->Tolerance;
  settings.FarthestObstacle = field.Diagonal;
  settings.MaximumNumberOfTetrahedra = static_cast<std::size_t>(this->MaximumNumberOfTetrahedra);
  return this->CheckNumberOfSteps(settings.Duration, settings.TimeStep);
}

void vtkFlowVolume::ReportSteady(const nephoscope::WholeVolume& whole)
{
  const nephoscope::SmokeReport& report = whole.Mesh.Report;
  this->DurationUsed = whole.Settings.Duration;
  this->TimeStepUsed = whole.Settings.TimeStep;
  this->MaximumEdgeLengthUsed = whole.Settings.MaximumEdgeLength;
  this->EmittedMass = this->InitialDensity * report.EmittedMass;
  this->LostMass = this->InitialDensity * report.LostMass;
  this->ObstacleMass = this->InitialDensity * report.ObstacleMass;
  this->FoldedMass = this->InitialDensity * report.FoldedMass;
  if (report.LimitReached)
  {
    this->WarnOfLimit();
  }
  else if (report.Stopped)
  {
    return;
  }
  else if (this->HasTooManySteps(whole.Settings.Duration))
  {
    this->WarnOfManySteps(whole.Settings.Duration);
  }
  else if (whole.Mesh.Tetrahedra.empty())
  {
    this->WarnOfNothing(report);
  }
}
