// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolume.h"

#include "DataSets.h"
#include "FlowVolumeExchange.h"
#include "FlowVolumeState.h"
#include "GeneratingPolygon.h"
#include "MessageSuppression.h"
#include "PolygonFlow.h"
#include "PolygonShape.h"
#include "RequiredInput.h"
#include "SmokeData.h"
#include "SmokeOutput.h"
#include "VelocityChoice.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkFlowVolume);

vtkFlowVolume::vtkFlowVolume()
  : State(std::make_unique<nephoscope::FlowVolumeState>())
{
  this->SetNumberOfInputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkFlowVolume::~vtkFlowVolume()
{
  this->SetController(nullptr);
}

vtkCxxSetObjectMacro(vtkFlowVolume, Controller, vtkMultiProcessController);

namespace
{
// There is no flow anywhere in the data of this process.
bool IsStillHere(const nephoscope::FlowField& field)
{
  const auto sets = nephoscope::DataSetsOf(field.Data);
  return std::all_of(sets.begin(), sets.end(), [&](vtkDataSet* set) {
    vtkDataArray* velocity =
      set->GetAttributes(field.Velocity.OnCells ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(field.Velocity.Name.c_str());
    double speeds[2] = { 0, 0 };
    if (velocity)
    {
      velocity->GetFiniteRange(speeds, -1);
    }
    return !(speeds[1] > 0.0);
  });
}

}

nephoscope::FlowVolumeExchange vtkFlowVolume::Exchange() const
{
  return nephoscope::FlowVolumeExchange(this->Controller);
}

void vtkFlowVolume::SetPolygonConnection(vtkAlgorithmOutput* polygon)
{
  this->SetInputConnection(1, polygon);
}

int vtkFlowVolume::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkFlowVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  const nephoscope::MessageSuppression otherRanks(this, !this->Exchange().ReportsMessages());
  const auto polygon = this->Exchange().GatherPolygon(vtkPolyData::GetData(inputs[1], 0));
  this->ResetResults();
  if (this->CheckSettings() && this->CheckSeries())
  {
    if (this->HasTimeSteps())
    {
      this->MakeUnsteadyVolume(request, input, polygon, outputs->GetInformationObject(0));
    }
    else
    {
      this->MakeSteadyVolume(input, polygon, output);
    }
  }
  if (this->Exchange().AnyTrue(this->CheckAbort()))
  {
    output->Initialize(); // nothing rather than a part
    this->ResetResults();
    this->EndSeries(request);
  }
  // A message has told why there is no smoke.
  const bool ends = !request->Has(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  this->ErrorCode =
    ends && output->GetNumberOfCells() == 0 ? vtkErrorCode::UserError : vtkErrorCode::NoError;
  return 1;
}

std::shared_ptr<const nephoscope::FlowField> vtkFlowVolume::MakeField(vtkDataObject* input)
{
  auto& last = this->State->Field;
  const auto sets = nephoscope::DataSetsOf(input);
  const auto exchange = this->Exchange();
  if (!exchange.AnyTrue(!sets.empty()))
  {
    vtkErrorMacro("The input has no cells, so there is no flow. Connect a dataset with cells."
      << nephoscope::RemedyFor(input) << this->NameOfTimeStep());
    return nullptr;
  }
  nephoscope::VelocityArray velocity;
  std::string problem;
  if (!exchange.ChooseVelocity(input, this->GetInputArrayInformation(0), velocity, problem))
  {
    vtkErrorMacro(<< problem << this->NameOfTimeStep());
    return nullptr;
  }
  const vtkMTimeType newest = nephoscope::NewestMTime(input);
  if (exchange.AllTrue(last && last->IsOf(newest, velocity)))
  {
    return last;
  }
  last = nullptr; // its memory first
  auto made = std::make_shared<nephoscope::FlowField>();
  made->Data = nephoscope::SharedCopy(input);
  made->Velocity = velocity;
  made->Diagonal = exchange.DiagonalOf(sets);
  made->BlankedSize = exchange.SmallestBlanked(sets);
  made->MTime = newest;
  made->Field = exchange.MakeVelocityField(made->Data, velocity, problem);
  if (!made->Field)
  {
    vtkErrorMacro(<< problem);
    return nullptr;
  }
  last = made;
  return made;
}

bool vtkFlowVolume::MakePolygon(const nephoscope::FlowField& field,
  const nephoscope::VelocityField& velocity, double time, vtkPolyData* given,
  nephoscope::PolygonMesh& polygon)
{
  const auto make = [&](double edge) {
    return this->TriangulatePolygon(field, velocity, time, given, edge, polygon);
  };
  if (!make(this->PolygonEdgeLength))
  {
    return false;
  }
  // The edges of unsteady smoke cannot become shorter than those of the polygon.
  const double longest = this->HasTimeSteps() ? this->MaximumEdgeLength : 0.0;
  return longest == 0.0 || nephoscope::LongestEdge(polygon) <= longest || make(longest);
}

bool vtkFlowVolume::TriangulatePolygon(const nephoscope::FlowField& field,
  const nephoscope::VelocityField& velocity, double time, vtkPolyData* given, double edge,
  nephoscope::PolygonMesh& polygon)
{
  return given ? this->MakeGivenPolygon(field, velocity, time, given, edge, polygon)
               : this->MakeRegularPolygon(field, velocity, time, edge, polygon);
}

bool vtkFlowVolume::MakeGivenPolygon(const nephoscope::FlowField& field,
  const nephoscope::VelocityField& velocity, double time, vtkPolyData* given, double edge,
  nephoscope::PolygonMesh& polygon)
{
  std::string problem;
  if (!nephoscope::TriangulatePolygons(given, edge, polygon, problem))
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  nephoscope::Vector3 direction{};
  const nephoscope::Vector3 center = nephoscope::Center(polygon);
  if (this->NormalToFlow == NORMAL_TO_FLOW)
  {
    if (!this->FindDirection(field, velocity, time, center, direction))
    {
      return false;
    }
    nephoscope::TurnNormalTo(polygon, center, direction);
  }
  return true;
}

bool vtkFlowVolume::MakeRegularPolygon(const nephoscope::FlowField& field,
  const nephoscope::VelocityField& velocity, double time, double edge,
  nephoscope::PolygonMesh& polygon)
{
  nephoscope::RegularPolygon regular;
  std::copy_n(this->Center, 3, regular.Center.begin());
  std::copy_n(this->Normal, 3, regular.Normal.begin());
  regular.Radius = this->Radius > 0.0 ? this->Radius : field.Diagonal / 50.0;
  regular.Sides = this->NumberOfSides;
  if (this->NormalToFlow != AS_GIVEN &&
    !this->FindDirection(field, velocity, time, regular.Center, regular.Normal))
  {
    return false;
  }
  if (!(nephoscope::Norm(regular.Normal) > 0.0))
  {
    vtkErrorMacro("Normal is (0, 0, 0): give the polygon a direction, or switch NormalToFlow on.");
    return false;
  }
  polygon = nephoscope::TriangulateRegularPolygon(regular, edge);
  if (polygon.Triangles.empty())
  {
    vtkErrorMacro("The generating polygon of radius "
      << regular.Radius << " cannot be divided into triangles with edges of " << edge
      << ": there would be too many. Choose a longer PolygonEdgeLength or a smaller Radius.");
    return false;
  }
  return true;
}

bool vtkFlowVolume::IsStill(const nephoscope::FlowField& field) const
{
  return this->Exchange().AllTrue(IsStillHere(field));
}

void vtkFlowVolume::ReportZeroVelocity(const nephoscope::FlowField& field, const std::string& where)
{
  const bool everywhere = this->IsStill(field);
  const char* throughout = this->HasTimeSteps()
    ? "everywhere at all times from StartTime on, so no smoke moves. Choose another array of velocities, or an earlier StartTime."
    : "everywhere, so no smoke moves. Choose another array of velocities, or another time.";
  vtkErrorMacro("The flow (array '" << field.Velocity.Name << "') is zero "
                                    << (everywhere ? throughout : where));
}

bool vtkFlowVolume::FindDirection(const nephoscope::FlowField& field,
  const nephoscope::VelocityField& velocity, double time, const nephoscope::Vector3& center,
  nephoscope::Vector3& direction)
{
  nephoscope::Vector3 found{};
  nephoscope::CellHint hint;
  unsigned char inside = 0;
  velocity.Sample({ 1, &center, time, &found, &inside, &hint });
  if (!inside)
  {
    const auto why = this->Exchange().WhyNoVelocity(nephoscope::DataSetsOf(field.Data), center);
    vtkErrorMacro(
      "The generating polygon cannot be turned normal to the flow at its centre. " << why);
    return false;
  }
  direction = nephoscope::Normalized(found);
  if (!(nephoscope::Norm(direction) > 0.0))
  {
    std::ostringstream where;
    where << "at the centre of the generating polygon, (" << center[0] << ", " << center[1] << ", "
          << center[2] << "): move the polygon into the flow, or switch NormalToFlow off.";
    this->ReportZeroVelocity(field, where.str());
    return false;
  }
  return true;
}

bool vtkFlowVolume::CheckPlace(const nephoscope::FlowField& field,
  const nephoscope::PolygonMesh& polygon, const nephoscope::PolygonFlow& flow)
{
  std::copy_n(flow.Normal.begin(), 3, this->NormalUsed);
  const std::size_t count = polygon.Points.size();
  if (count == 0 || !(flow.Area > 0.0))
  {
    vtkErrorMacro(
      "The generating polygon has no area: give it at least three corners that are not on a line.");
    return false;
  }
  if (flow.PointsInside == 0)
  {
    const auto why =
      this->Exchange().WhyNoVelocity(nephoscope::DataSetsOf(field.Data), polygon.Points[0]);
    vtkErrorMacro("No smoke comes from the generating polygon. " << why);
    return false;
  }
  if (flow.PointsInside < count)
  {
    vtkWarningMacro(
      << count - flow.PointsInside << " of the " << count
      << " points of the generating polygon are outside the data, in blanked cells or where the velocity is not a "
         "number; no smoke comes from there. Make the polygon smaller or move it.");
  }
  return true;
}

bool vtkFlowVolume::CheckFlow(
  const nephoscope::FlowField& field, const nephoscope::PolygonFlow& flow)
{
  if (flow.MeanSpeed == 0.0)
  {
    this->ReportZeroVelocity(field, "at the generating polygon: move it into the flow.");
    return false;
  }
  if (flow.IsParallel())
  {
    vtkErrorMacro(
      "The flow is parallel to the generating polygon, so no smoke comes from it: turn it (Normal), or switch NormalToFlow on.");
    return false;
  }
  return true;
}

bool vtkFlowVolume::CheckSettings()
{
  struct Setting
  {
    const char* Name;
    double Value;
    const char* Zero;
  };
  const Setting settings[] = { { "Radius", this->Radius, "automatic" },
    { "PolygonEdgeLength", this->PolygonEdgeLength, "automatic" },
    { "Duration", this->Duration, "automatic" }, { "TimeStep", this->TimeStep, "automatic" },
    { "MaximumEdgeLength", this->MaximumEdgeLength, "automatic" },
    { "MinimumEdgeLength", this->MinimumEdgeLength, "never merged" },
    { "MaximumAreaRatio", this->MaximumAreaRatio, "any" },
    { "MaximumDivergence", this->MaximumDivergence, "any" },
    { "ObstacleSize", this->ObstacleSize, "automatic" },
    { "TimeScale", this->TimeScale, "the unit that the data tell, or seconds" } };
  for (const Setting& setting : settings)
  {
    if (!(setting.Value >= 0.0) || !std::isfinite(setting.Value))
    {
      vtkErrorMacro(<< setting.Name << " is " << setting.Value << "; it must be positive, or 0 ("
                    << setting.Zero << ").");
      return false;
    }
  }
  if (this->MaximumEdgeLength > 0.0 && this->MinimumEdgeLength > this->MaximumEdgeLength)
  {
    vtkErrorMacro("MinimumEdgeLength ("
      << this->MinimumEdgeLength << ") is longer than MaximumEdgeLength ("
      << this->MaximumEdgeLength
      << "). Edges are merged up to a third of MaximumEdgeLength: choose a MinimumEdgeLength of "
      << this->MaximumEdgeLength / 3.0 << " or less.");
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    if (!std::isfinite(this->Center[c]) || !std::isfinite(this->Normal[c]))
    {
      vtkErrorMacro("Center and Normal must be finite numbers.");
      return false;
    }
  }
  if (!std::isfinite(this->InitialDensity) || std::isnan(this->StartTime))
  {
    vtkErrorMacro("InitialDensity (" << this->InitialDensity << ") and StartTime ("
                                     << this->StartTime << ") must be finite numbers.");
    return false;
  }
  return true;
}

bool vtkFlowVolume::CheckNumberOfSteps(double duration, double timeStep)
{
  if (!(duration / timeStep <= maximumNumberOfSteps))
  {
    vtkErrorMacro("A duration of " << duration << " s in time steps of " << timeStep
                                   << " s is more than a million steps. Choose a longer TimeStep.");
    return false;
  }
  return true;
}

bool vtkFlowVolume::Report(double share)
{
  this->UpdateProgress(share);
  return this->Exchange().AllTrue(!this->CheckAbort());
}

void vtkFlowVolume::WriteOutput(nephoscope::SmokeMesh& mesh,
  const nephoscope::ArraySampler& sampleArrays, vtkUnstructuredGrid* output)
{
  if (!this->Report(nephoscope::buildingShare))
  {
    return;
  }
  nephoscope::AverageDensities(mesh);
  nephoscope::SmokeMesh share;
  const nephoscope::SmokeMesh& written = this->Exchange().ShareOf(mesh, share);
  if (nephoscope::PutSmoke(written, this->InitialDensity, sampleArrays, output))
  {
    vtkWarningMacro("The point array 'Age' of the input has been replaced. Rename it to keep it.");
  }
  this->WriteMasses(output);
  if (this->Unsteady)
  {
    nephoscope::PutInitialDensity(output, this->InitialDensity);
  }
  this->UpdateProgress(1.0);
}

void vtkFlowVolume::WriteMasses(vtkUnstructuredGrid* output) const
{
  const std::pair<const char*, double> masses[] = { { "EmittedMass", this->EmittedMass },
    { "LostMass", this->LostMass }, { "ObstacleMass", this->ObstacleMass },
    { "FoldedMass", this->FoldedMass } };
  for (const auto& mass : masses)
  {
    vtkNew<vtkDoubleArray> value;
    value->SetName(mass.first);
    value->InsertNextValue(mass.second);
    output->GetFieldData()->AddArray(value);
  }
}

void vtkFlowVolume::ResetResults()
{
  std::fill_n(this->NormalUsed, 3, 0.0);
  this->DurationUsed = 0.0;
  this->TimeStepUsed = 0.0;
  this->MaximumEdgeLengthUsed = 0.0;
  this->EmittedMass = 0.0;
  this->LostMass = 0.0;
  this->ObstacleMass = 0.0;
  this->FoldedMass = 0.0;
  this->ExpiredMass = 0.0;
}

void vtkFlowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& value) {
    os << indent << name << ": " << value << "\n";
  };
  const auto printVector = [&](const char* name, const double* value) {
    os << indent << name << ": " << value[0] << " " << value[1] << " " << value[2] << "\n";
  };
  printVector("Center", this->Center);
  print("Radius", this->Radius);
  print("NumberOfSides", this->NumberOfSides);
  printVector("Normal", this->Normal);
  print("NormalToFlow", this->NormalToFlow);
  print("PolygonEdgeLength", this->PolygonEdgeLength);
  print("Duration", this->Duration);
  print("TimeStep", this->TimeStep);
  print("MaximumEdgeLength", this->MaximumEdgeLength);
  print("MinimumEdgeLength", this->MinimumEdgeLength);
  print("EdgeLevels", this->EdgeLevels);
  print("MaximumTurnAngle", this->MaximumTurnAngle);
  print("MaximumAreaRatio", this->MaximumAreaRatio);
  print("MaximumDivergence", this->MaximumDivergence);
  print("MaximumHalvings", this->MaximumHalvings);
  print("ObstacleLevels", this->ObstacleLevels);
  print("ObstacleSize", this->ObstacleSize);
  print("Integrator", this->Integrator == RUNGE_KUTTA_4 ? "RungeKutta4" : "RungeKutta45");
  print("Tolerance", this->Tolerance);
  print("Unsteady", this->Unsteady);
  print("StartTime", this->StartTime);
  print("TimeScale", this->TimeScale);
  print("InitialDensity", this->InitialDensity);
  print("MaximumNumberOfTetrahedra", this->MaximumNumberOfTetrahedra);
  printVector("NormalUsed", this->NormalUsed);
  print("DurationUsed", this->DurationUsed);
  print("TimeStepUsed", this->TimeStepUsed);
  print("MaximumEdgeLengthUsed", this->MaximumEdgeLengthUsed);
  print("EmittedMass", this->EmittedMass);
  print("LostMass", this->LostMass);
  print("ObstacleMass", this->ObstacleMass);
  print("FoldedMass", this->FoldedMass);
  print("ExpiredMass", this->ExpiredMass);
}
