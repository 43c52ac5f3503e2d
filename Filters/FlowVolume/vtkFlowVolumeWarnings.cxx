// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkFlowVolume that says what the smoke lacks, and what to do: first of any smoke,
// then of that in a time series.
#include "vtkFlowVolume.h"

#include "DataSets.h"
#include "FlowVolumeExchange.h"
#include "FlowVolumeState.h"
#include "WholeVolume.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

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

// Once for a series: an animation has many frames, and comes back to its beginning.
bool vtkFlowVolume::IsToldFirst(vtkMTimeType& told)
{
  const bool isFirst = told != this->State->Streak.MTime;
  told = this->State->Streak.MTime;
  return isFirst;
}

void vtkFlowVolume::WarnOfNoSmokeYet()
{
  auto& state = *this->State;
  if (!this->IsToldFirst(state.ToldOfNoSmoke))
  {
    return;
  }
  const auto read = static_cast<std::size_t>(state.Streak.LastRead);
  const bool isStill = state.Streak.WasStill && !state.Streak.Volume;
  const double start = isStill ? state.Times[read] : std::max(this->StartTime, state.Times.front());
  std::ostringstream later;
  if (state.Times.back() > start)
  {
    later << ", such as " << state.Times.back();
  }
  vtkWarningMacro("There is no smoke at time "
    << state.Requested << ": "
    << (isStill ? "the flow is zero everywhere up to time "
                : "unsteady smoke leaves the generating polygon from time ")
    << start << (isStill ? "" : " on, and needs time to grow")
    << ". Play the animation, choose a later time" << later.str() << ", or switch Unsteady off.");
}

// Times may be in another unit than is assumed. A wind that begins later is too slow at first.
void vtkFlowVolume::WarnOfTimeScale(double speed)
{
  constexpr double little = 0.01; // of the diagonal: a quarter of the default width of the polygon
  constexpr double much = 8.0;
  auto& state = *this->State;
  const double diagonal = state.Streak.Second->Diagonal;
  const double series = this->Seconds(state.Times.back());
  const bool endsEarly = this->Duration > 0.0 && this->Duration < series;
  const double seconds = endsEarly ? this->Duration : series;
  const double way = speed * seconds;
  const double inStep = speed * series / static_cast<double>(state.Times.size() - 1);
  const bool isLittle = way < (little * diagonal);
  const bool isMuch = inStep > (much * diagonal);
  if (!(way > 0.0) || (!isLittle && !isMuch) || !this->IsToldFirst(state.ToldOfTimeScale))
  {
    return;
  }
  std::ostringstream moves;
  if (isLittle)
  {
    moves << "moves by only " << way << " (" << 100.0 * way / diagonal
          << " % of the diagonal of the data) in the " << seconds
          << (endsEarly ? " seconds of Duration. Lengthen it: it is in seconds."
                        : " seconds from the first time step to the last.");
  }
  else
  {
    moves << "crosses the data " << std::round(inStep / diagonal)
          << " times between two time steps.";
  }
  vtkWarningMacro("With its speed of "
    << speed << ", the flow at the generating polygon " << moves.str() << " TimeScale is "
    << series / (state.Times.back() - state.Times.front())
    << " s per unit of time: set it to 3600 for time steps in hours, to 86400 for days, to "
       "1 for seconds. If the coordinates have another unit of length than the velocity, convert "
       "them.");
}

void vtkFlowVolume::WarnOfNoDataYet()
{
  auto& state = *this->State;
  const double last = state.Times.back();
  const double rounding = 1e-9 * (last - state.Times.front());
  if (state.Requested > last + rounding && this->IsToldFirst(state.ToldOfNoData))
  {
    vtkWarningMacro("There are no data at time "
      << state.Requested << ": the last time step of the input is at " << last
      << ", and the smoke is that of this time. Choose an earlier time, or add time steps.");
  }
}

// Smoke that ended inside the data. In a time step without any velocity, no obstacle is the cause.
void vtkFlowVolume::WarnOfLoss(const nephoscope::SmokeReport& report)
{
  constexpr double noticed = 0.01; // of the smoke
  auto& state = *this->State;
  const nephoscope::StreakState& streak = state.Streak;
  const bool isMissing = this->Exchange().AnyTrue(streak.Missing.Missing > 0);
  const bool isHere = streak.Missing.Missing > 0; // on this rank
  const bool isWhole = isHere && streak.Missing.Missing == streak.Missing.All;
  const double share = report.LostMass / report.EmittedMass;
  if (isHere && share > noticed && this->IsToldFirst(state.ToldOfMissing))
  {
    const nephoscope::MissingVelocities& missing = streak.Missing;
    vtkWarningMacro("The velocity (array '"
      << streak.Second->Velocity.Name << "') is not a finite number at " << missing.Missing
      << " of " << missing.All << (streak.Second->Velocity.OnCells ? " cells" : " points")
      << " at time " << streak.MissingTime << ". Smoke that reaches them ends there; "
      << std::round(100.0 * share) << " % of it has ended or left the data (LostMass). "
      << (isWhole ? "Leave this time step out: the velocity is linear between the others."
                  : "Replace the missing values if it should go on."));
  }
  if (!isWhole && report.ObstacleMass > noticed * report.EmittedMass &&
    this->IsToldFirst(state.ToldOfObstacles))
  {
    this->WarnOfObstacles(report, isMissing);
  }
}
