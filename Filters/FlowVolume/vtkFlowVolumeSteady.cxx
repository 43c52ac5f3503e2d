// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkFlowVolume that makes the volume of a steady flow, and says how it was coarsened.
#include "vtkFlowVolume.h"

#include "ChangeOfInput.h"
#include "DataSets.h"
#include "FlowVolumeExchange.h"
#include "FlowVolumeState.h"
#include "PolygonFlow.h"
#include "WholeVolume.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
// A sentence for the air of a whole globe whose heights are hardly exaggerated: it is thinner than
// any smoke that can be seen.
std::string RemedyForThinAir(vtkDataObject* data)
{
  constexpr double little = 10.0;
  const std::vector<vtkDataSet*> sets = nephoscope::DataSetsOf(data);
  vtkFieldData* fields = sets.empty() ? nullptr : sets.front()->GetFieldData();
  const auto value = [fields](const char* name, double otherwise) {
    vtkDataArray* array = fields ? fields->GetArray(name) : nullptr;
    return array && array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : otherwise;
  };
  const double exaggeration = value("VerticalExaggeration", little);
  if (value("GlobeGridProjection", 1.0) != 0.0 || exaggeration >= little)
  {
    return {};
  }
  std::ostringstream text;
  text << " The air of a globe is thin: exaggerate its heights first (vertical exaggeration, now "
       << exaggeration << ").";
  return text.str();
}

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

void vtkFlowVolume::WarnOfManySteps(double duration)
{
  const double usual = this->UsualTimeStep(duration);
  vtkWarningMacro("The smoke is coarser than usual: for a Duration of "
    << duration << " s, a TimeStep of " << usual
    << " s would make more than a million steps, so it is " << this->TimeStepUsed
    << " s. Shorten Duration, to " << usual * maximumNumberOfSteps << " s or less.");
}

// Automatic settings give a volume of moderate size; explicit requests that cannot be met are
// reported, and what is much coarser.
bool vtkFlowVolume::IsSizeAutomatic() const
{
  return this->TimeStep == 0.0 && this->PolygonEdgeLength == 0.0 &&
    this->MaximumEdgeLength == 0.0 && this->MaximumNumberOfTetrahedra >= moderateNumberOfTetrahedra;
}

void vtkFlowVolume::WarnOfCoarsening(double polygonEdgeLength, bool isMuch)
{
  if (this->IsSizeAutomatic() && !isMuch)
  {
    return;
  }
  vtkWarningMacro("The smoke is "
    << (this->IsSizeAutomatic() ? "much coarser than usual" : "coarser than requested")
    << ", so that its whole duration fits into MaximumNumberOfTetrahedra ("
    << this->MaximumNumberOfTetrahedra << "). It has a TimeStep of " << this->TimeStepUsed
    << ", a PolygonEdgeLength of " << polygonEdgeLength << " and a MaximumEdgeLength of "
    << this->MaximumEdgeLengthUsed << ". Allow more tetrahedra, or shorten the Duration.");
}

void vtkFlowVolume::WarnOfLongEdges()
{
  if (!this->IsSizeAutomatic())
  {
    vtkWarningMacro(
      "The smoke is coarser than requested, so that its whole duration fits into MaximumNumberOfTetrahedra ("
      << this->MaximumNumberOfTetrahedra << "). Some edges are longer than MaximumEdgeLength ("
      << this->MaximumEdgeLengthUsed << "), or turn by more than MaximumTurnAngle ("
      << this->MaximumTurnAngle << "). Allow more tetrahedra, or lengthen MaximumEdgeLength.");
  }
}

void vtkFlowVolume::WarnOfObstacles(const nephoscope::SmokeReport& report, bool isMissing)
{
  constexpr double noticed = 0.01; // of the smoke
  const auto percent = [&](double mass) { return std::round(100.0 * mass / report.EmittedMass); };
  if (report.Stopped || !(report.ObstacleMass > noticed * report.EmittedMass))
  {
    return;
  }
  const char* cell = this->HasTimeSteps() ? "tetrahedron" : "prism";
  std::ostringstream folded;
  if (percent(report.FoldedMass) > 0.0)
  {
    folded << ", and " << percent(report.FoldedMass) << " % where the flow would have folded it";
  }
  vtkWarningMacro("The volume lacks smoke: "
    << percent(report.ObstacleMass) << " % of it ended at "
    << (isMissing ? "missing velocities or " : "") << "obstacles inside the data (ObstacleMass)"
    << folded.str() << ". A " << cell
    << " ends as a whole where one of its corners meets a body. For smaller ones shorten MaximumEdgeLength (now "
    << this->MaximumEdgeLengthUsed
    << ") to a fraction of the body, and raise MaximumNumberOfTetrahedra (now "
    << this->MaximumNumberOfTetrahedra << ").");
}

// Where it fills a small part of the data only because it has left them.
void vtkFlowVolume::WarnOfLeaving(
  const nephoscope::SmokeMesh& mesh, const nephoscope::FlowField& field)
{
  constexpr double most = 0.5, small = 0.15; // of the smoke; of the diagonal
  const double left = (mesh.Report.LostMass - mesh.Report.ObstacleMass) / mesh.Report.EmittedMass;
  vtkBoundingBox box;
  for (const nephoscope::Vector3& point : mesh.Points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
  if (mesh.Report.Stopped || mesh.Tetrahedra.empty() || !(left > most) ||
    box.GetDiagonalLength() > small * field.Diagonal)
  {
    return;
  }
  vtkWarningMacro("Most of the smoke, "
    << std::round(100.0 * left)
    << " %, leaves the data at once, so that little of it is seen: it extends over "
    << std::round(100.0 * box.GetDiagonalLength() / field.Diagonal)
    << " % of the diagonal of the data. Move the generating polygon (Center) upstream, or to where the flow goes far before it leaves the data."
    << RemedyForThinAir(field.Data));
}

void vtkFlowVolume::WarnOfLimit()
{
  vtkWarningMacro(
    "The volume ends early: even the coarsest volume has more tetrahedra than MaximumNumberOfTetrahedra ("
    << this->MaximumNumberOfTetrahedra << "). Allow more, or make the generating polygon simpler.");
}

nephoscope::MissingVelocities vtkFlowVolume::CountMissing(const nephoscope::FlowField& field) const
{
  nephoscope::MissingVelocities count;
  for (vtkDataSet* set : nephoscope::DataSetsOf(field.Data))
  {
    auto* attributes = field.Velocity.OnCells
      ? static_cast<vtkDataSetAttributes*>(set->GetCellData())
      : static_cast<vtkDataSetAttributes*>(set->GetPointData());
    vtkDataArray* velocity = attributes->GetArray(field.Velocity.Name.c_str());
    if (!velocity || velocity->GetNumberOfComponents() != 3)
    {
      continue;
    }
    count.All += velocity->GetNumberOfTuples();
    for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
    {
      double v[3];
      velocity->GetTuple(i, v);
      count.Missing += std::isfinite(v[0] + v[1] + v[2]) ? 0 : 1;
    }
  }
  return count;
}

bool vtkFlowVolume::WarnOfMissing(const nephoscope::FlowField& field)
{
  if (!(this->LostMass > 0.0))
  {
    return false; // no smoke can have met one
  }
  const auto count = this->CountMissing(field);
  if (count.Missing > 0)
  {
    vtkWarningMacro("The velocity (array '"
      << field.Velocity.Name << "') is not a finite number at " << count.Missing << " of "
      << count.All << (field.Velocity.OnCells ? " cells" : " points")
      << ". Smoke that reaches them ends there. Replace the missing values if it should go on.");
  }
  return count.Missing > 0;
}

void vtkFlowVolume::WarnOfNothing(const nephoscope::SmokeReport& report)
{
  if (!(report.Flux > 0.0))
  {
    vtkWarningMacro(
      "No smoke comes from the generating polygon: none of its triangles is entirely inside the data and crossed by the flow in "
      "one direction. Shorten PolygonEdgeLength, make the polygon smaller or move it.");
  }
  else if (report.EndedTriangles == 0)
  {
    vtkWarningMacro(
      "The volume is too thin for the precision of the coordinates, so there is no smoke. Make the generating polygon wider or "
      "TimeStep longer.");
  }
  else
  {
    vtkWarningMacro(
      "The volume ended at once: within the first time step the flow leaves the data, or reaches blanked cells or values "
      "that are not numbers. Shorten TimeStep or move the generating polygon.");
  }
}
