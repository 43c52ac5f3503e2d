// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTextureCoordinateAdvection that checks what it is given and makes a time step of
// it.
#include "vtkTextureCoordinateAdvection.h"

#include "CartesianFlow.h"
#include "DataSets.h"
#include "GlobeFlow.h"
#include "TextureState.h"
#include "VelocityChoice.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
constexpr double maximumNumberOfSteps = 1e6; // of a path
constexpr double day = 86400.0;              // s
constexpr double crossingsInPeriod = 0.25;
constexpr double stepsInPeriod = 24.0;
}

double vtkTextureCoordinateAdvection::FindCrossingTime(vtkDataSet* winds)
{
  nephoscope::VelocityArray velocity;
  std::string problem;
  if (!winds ||
    !nephoscope::ChooseVelocity(winds, this->GetInputArrayInformation(0), velocity, problem))
  {
    return 0.0;
  }
  vtkFieldData* arrays =
    velocity.OnCells ? static_cast<vtkFieldData*>(winds->GetCellData()) : winds->GetPointData();
  vtkDataArray* values = arrays->GetArray(velocity.Name.c_str());
  double fastest = 0.0;
  for (vtkIdType id = 0; values && id < values->GetNumberOfTuples(); ++id)
  {
    double v[3];
    values->GetTuple(id, v);
    const double speed = vtkMath::Norm(v);
    fastest = std::isfinite(speed) ? std::max(fastest, speed) : fastest;
  }
  const double crossing = fastest > 0.0 ? winds->GetLength() / fastest : 0.0;
  return nephoscope::IsPositive(crossing) ? crossing : 0.0;
}

double vtkTextureCoordinateAdvection::FindPeriod(vtkDataSet* winds)
{
  const double crossing = this->FindCrossingTime(winds);
  return crossing > 0.0 && !winds->GetFieldData()->HasArray("GlobeGridProjection")
    ? crossingsInPeriod * crossing
    : day;
}

double vtkTextureCoordinateAdvection::GetPeriodUsed() const
{
  const double usual = this->State->UsualPeriod > 0.0 ? this->State->UsualPeriod : day;
  return this->Period != 0.0 ? this->Period : usual;
}

double vtkTextureCoordinateAdvection::GetTimeStepUsed() const
{
  const double usual = this->State->UsualPeriod > 0.0 ? this->State->UsualPeriod : day;
  return this->TimeStep != 0.0 ? this->TimeStep : usual / stepsInPeriod;
}

vtkMTimeType vtkTextureCoordinateAdvection::PipelineMTime()
{
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetExecutive());
  return pipeline ? pipeline->GetPipelineMTime() : this->GetMTime();
}

// Whether nothing is automatic, or what is has been found in these data.
bool vtkTextureCoordinateAdvection::KnowsPeriod()
{
  return (this->Period != 0.0 && this->TimeStep != 0.0) ||
    this->State->UsualPeriodOf == this->PipelineMTime();
}

void vtkTextureCoordinateAdvection::TakePeriodOf(vtkDataSet* winds)
{
  this->State->UsualPeriod = this->FindPeriod(winds);
  this->State->UsualPeriodOf = this->PipelineMTime();
}

bool vtkTextureCoordinateAdvection::CheckSettings()
{
  struct Setting
  {
    const char* Name;
    double Value;
    bool MayBeZero;
  };
  const Setting settings[] = { { "Period", this->Period, true },
    { "TimeStep", this->TimeStep, true }, { "Tolerance", this->Tolerance, false },
    { "TimeScale", this->TimeScale, false }, { "KeyFrameInterval", this->KeyFrameInterval, true },
    { "PlanetRadius", this->PlanetRadius, true }, { "TextureLength", this->TextureLength, true },
    { "MaximumStretch", this->MaximumStretch, true } };
  for (const Setting& setting : settings)
  {
    if (!nephoscope::IsPositive(setting.Value) && !(setting.MayBeZero && setting.Value == 0.0))
    {
      vtkErrorMacro(<< setting.Name << " is " << setting.Value << "; it must be a positive number"
                    << (setting.MayBeZero ? ", or 0." : "."));
      return false;
    }
  }
  if (this->MaximumStretch > 0.0 && this->MaximumStretch <= 1.0)
  {
    vtkErrorMacro("MaximumStretch is " << this->MaximumStretch
                                       << "; it must be greater than 1, or 0 for none.");
    return false;
  }
  if (this->PressureArrayName.empty() != this->OmegaArrayName.empty())
  {
    vtkErrorMacro("PressureArrayName and OmegaArrayName go together: set both, or neither.");
    return false;
  }
  if (this->KnowsPeriod() && this->GetPeriodUsed() / this->GetTimeStepUsed() > maximumNumberOfSteps)
  {
    vtkErrorMacro("A Period of " << this->GetPeriodUsed() << " s in time steps of "
                                 << this->GetTimeStepUsed()
                                 << " s is more than a million steps. Choose a longer TimeStep.");
    return false;
  }
  return true;
}

bool vtkTextureCoordinateAdvection::CheckSeries()
{
  const auto& times = this->State->Times;
  if (this->State->HasSeries && times.empty())
  {
    vtkErrorMacro("The input's time series has no time steps. Check the reader's files.");
    return false;
  }
  const std::size_t i = this->State->FirstOutOfOrder();
  if (i < times.size())
  {
    vtkErrorMacro("Times must increase, but time step "
      << i << " is at " << times[i] << (i > 0 ? " after " : "")
      << (i > 0 ? std::to_string(times[i - 1]) : std::string()) << ". Sort the time steps.");
    return false;
  }
  return true;
}

bool vtkTextureCoordinateAdvection::ReadTimeStep(vtkDataSet* input, vtkInformation* inInfo)
{
  auto& state = *this->State;
  const auto known = state.Steps.find(state.Next);
  const bool needsData = state.Next >= state.Needed.Whole;
  if (known != state.Steps.end() && (known->second.Data || !needsData))
  {
    return true;
  }
  if (!this->CheckExtent(input, inInfo) || (!state.Flow && !this->MakeFlow(input)))
  {
    return false;
  }
  nephoscope::ReadStep& step = state.Steps[state.Next];
  if (!step.Wind)
  {
    std::string problem;
    step.Wind = state.Flow->MakeField(input, state.Arrays, problem);
    if (!step.Wind)
    {
      vtkErrorMacro(<< problem << " (time step " << state.Next << ")");
      return false;
    }
    if (step.Wind->Missing > 0 && !state.HasToldOfMissing)
    {
      state.HasToldOfMissing = true;
      vtkWarningMacro("The wind array '"
        << state.Arrays.Velocity.Name << "' is not a finite number at " << step.Wind->Missing
        << " of " << input->GetNumberOfPoints()
        << " points. They take the wind of the nearest level of their column; a "
           "column without any is calm.");
    }
  }
  if (needsData)
  {
    auto copy = vtkSmartPointer<vtkDataSet>::Take(input->NewInstance());
    copy->ShallowCopy(input);
    step.Data = copy;
  }
  return true;
}

bool vtkTextureCoordinateAdvection::CheckExtent(vtkDataSet* input, vtkInformation* inInfo)
{
  if (input->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("The input is empty. Connect a grid with winds.");
    return false;
  }
  int whole[6];
  if (nephoscope::IsStructured(input) && inInfo->Has(SDDP::WHOLE_EXTENT()))
  {
    inInfo->Get(SDDP::WHOLE_EXTENT(), whole);
    vtkIdType points = 1;
    for (int a = 0; a < 3; ++a)
    {
      points *= whole[2 * a + 1] - whole[2 * a] + 1;
    }
    if (points != input->GetNumberOfPoints())
    {
      vtkErrorMacro("Only "
        << input->GetNumberOfPoints() << " of the " << points
        << " points of the grid have been delivered. Paths need all the winds: use a reader or Globe Grid as input, which "
           "deliver the whole grid on request.");
      return false;
    }
  }
  return true;
}

bool vtkTextureCoordinateAdvection::MakeFlow(vtkDataSet* input)
{
  auto& state = *this->State;
  std::string problem;
  state.Arrays.Pressure = this->PressureArrayName;
  state.Arrays.Omega = this->OmegaArrayName;
  if (!nephoscope::ChooseVelocity(
        input, this->GetInputArrayInformation(0), state.Arrays.Velocity, problem))
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  nephoscope::PathSettings settings;
  settings.Method = static_cast<nephoscope::PathMethod>(this->Integrator);
  settings.TimeStep = this->GetTimeStepUsed();
  settings.Tolerance = this->Tolerance;
  const double radius = this->PlanetRadius > 0.0 ? this->PlanetRadius
    : this->Grid == MAP                          ? 6371000.0
                                                 : 0.0;
  nephoscope::GlobeShape shape;
  if (this->Grid != CARTESIAN &&
    shape.Recognize(input, static_cast<nephoscope::GridKind>(this->Grid), radius, problem))
  {
    if (state.Arrays.Velocity.OnCells)
    {
      vtkErrorMacro("The velocity '"
        << state.Arrays.Velocity.Name
        << "' is on cells; on a globe it is needed on points. Apply Cell Data to Point Data first.");
      return false;
    }
    int extent[6] = { 0, -1, 0, -1, 0, -1 };
    vtkStructuredGrid::SafeDownCast(input)->GetExtent(extent);
    state.Flow = std::make_unique<nephoscope::GlobeFlow>(
      std::move(shape), extent[0], settings, this->CartesianCoordinates);
    return true;
  }
  if (this->Grid == GLOBE || this->Grid == MAP)
  {
    vtkErrorMacro("Grid is " << (this->Grid == GLOBE ? "Globe" : "Map")
                             << ", but the input is not. " << problem);
    return false;
  }
  state.Flow = std::make_unique<nephoscope::CartesianFlow>(input, settings, this->TextureLength);
  return true;
}
