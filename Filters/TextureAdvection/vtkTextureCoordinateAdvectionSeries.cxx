// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTextureCoordinateAdvection that reads a time series.
//
//   RequestInformation    the times of the series
//   RequestUpdateExtent   PlanReading: which time steps the request needs, which of them are in memory, which is read next
//   RequestData           ReadTimeStep; again (CONTINUE_EXECUTING) until all are there; MakeTexture
#include "vtkTextureCoordinateAdvection.h"

#include "CartesianFlow.h"
#include "DataSets.h"
#include "GlobeFlow.h"
#include "TextureState.h"
#include "VelocityChoice.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
constexpr double maximumNumberOfSteps = 1e6; // of a path

// What CONTINUE_EXECUTING has set, and only a successful REQUEST_DATA would clear.
struct StopExecuting : SDDP
{
  static void Of(vtkExecutive* executive)
  {
    if (auto* pipeline = SDDP::SafeDownCast(executive))
    {
      pipeline->*(&StopExecuting::ContinueExecuting) = 0;
    }
  }
};

bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

bool IsStructured(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
    vtkStructuredGrid::SafeDownCast(data);
}
}

int vtkTextureCoordinateAdvection::FillInputPortInformation(int port, vtkInformation* info)
{
  // A composite dataset is refused by RequestData, with a sentence, rather than followed block by block.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataObject" : "vtkDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkTextureCoordinateAdvection::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const bool hasPoints = this->GetNumberOfInputConnections(1) > 0;
  auto* like = vtkDataSet::SafeDownCast(vtkDataObject::GetData(inputs[hasPoints ? 1 : 0], 0));
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* present = info->Get(vtkDataObject::DATA_OBJECT());
  vtkSmartPointer<vtkDataObject> made;
  if (like && (!present || !present->IsA(like->GetClassName())))
  {
    made = vtkSmartPointer<vtkDataObject>::Take(like->NewInstance());
  }
  else if (!like && !vtkDataSet::SafeDownCast(present))
  {
    made = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  if (made)
  {
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

vtkTypeBool vtkTextureCoordinateAdvection::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // An executive that is told to go on asks for ever, should the input fail in the meantime: an update begins anew, though the
  // last one has not come to RequestData.
  if (request->Has(SDDP::REQUEST_UPDATE_TIME()) && this->State->AwaitsData)
  {
    this->State->AwaitsData = false;
    if (this->State->Continuing)
    {
      vtkErrorMacro("The input has not delivered the time step at "
        << this->State->PipelineTimes[static_cast<std::size_t>(this->State->Next)]
        << ", so there are no texture coordinates.");
      this->State->Continuing = false;
      StopExecuting::Of(this->GetExecutive());
    }
    this->State->Forget();
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkTextureCoordinateAdvection::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  auto& state = *this->State;
  std::vector<double> times;
  state.HasSeries = input->Has(SDDP::TIME_STEPS()) != 0;
  if (state.HasSeries)
  {
    const double* first = input->Get(SDDP::TIME_STEPS());
    times.assign(first, first + input->Length(SDDP::TIME_STEPS()));
  }
  if (times != state.PipelineTimes)
  {
    state.PipelineTimes = times;
    state.Forget();
  }
  if (input->Has(SDDP::WHOLE_EXTENT()))
  {
    output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  }
  if (times.size() < 2 && IsPositive(this->TimeScale))
  {
    // A steady wind moves a texture all the same: something to animate.
    const double first = times.empty() ? 0.0 : times.front();
    const double range[2] = { first, first + this->Period / this->TimeScale };
    output->Set(SDDP::TIME_RANGE(), range, 2);
    output->Remove(SDDP::TIME_STEPS()); // of one step ParaView would make no animation
  }
  return 1;
}

bool vtkTextureCoordinateAdvection::CheckSettings()
{
  struct Setting
  {
    const char* Name;
    double Value;
    bool MayBeZero;
  };
  const Setting settings[] = { { "Period", this->Period, false },
    { "TimeStep", this->TimeStep, false }, { "Tolerance", this->Tolerance, false },
    { "TimeScale", this->TimeScale, false }, { "KeyFrameInterval", this->KeyFrameInterval, true },
    { "PlanetRadius", this->PlanetRadius, true }, { "TextureLength", this->TextureLength, true },
    { "MaximumStretch", this->MaximumStretch, true } };
  for (const Setting& setting : settings)
  {
    if (!IsPositive(setting.Value) && !(setting.MayBeZero && setting.Value == 0.0))
    {
      vtkErrorMacro(<< setting.Name << " is " << setting.Value << "; it must be a positive number"
                    << (setting.MayBeZero ? ", or 0." : "."));
      return false;
    }
  }
  if (this->MaximumStretch > 0.0 && this->MaximumStretch <= 1.0)
  {
    vtkErrorMacro("MaximumStretch is " << this->MaximumStretch << "; it must be greater than 1, or 0 for none.");
    return false;
  }
  if (this->PressureArrayName.empty() != this->OmegaArrayName.empty())
  {
    vtkErrorMacro("PressureArrayName and OmegaArrayName go together: set both, or neither.");
    return false;
  }
  if (this->Period / this->TimeStep > maximumNumberOfSteps)
  {
    vtkErrorMacro("A Period of " << this->Period << " s in time steps of " << this->TimeStep
                                 << " s is more than a million steps. Choose a longer TimeStep.");
    return false;
  }
  return true;
}

bool vtkTextureCoordinateAdvection::CheckSeries()
{
  const auto& times = this->State->PipelineTimes;
  if (this->State->HasSeries && times.empty())
  {
    vtkErrorMacro("The input's time series has no time steps. Check the reader's files.");
    return false;
  }
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
    {
      vtkErrorMacro("Times must rise, but time step " << i << " is at " << times[i] << (i > 0 ? " after " : "")
        << (i > 0 ? std::to_string(times[i - 1]) : std::string()) << ". Sort the time steps.");
      return false;
    }
  }
  return true;
}

bool vtkTextureCoordinateAdvection::HasSeries() const
{
  return this->State->PipelineTimes.size() > 1;
}

nephoscope::TimeSeries vtkTextureCoordinateAdvection::Series() const
{
  const auto& times = this->State->PipelineTimes;
  std::vector<double> seconds(std::max<std::size_t>(times.size(), 1), 0.0);
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    seconds[i] = (times[i] - times[0]) * this->TimeScale;
  }
  return nephoscope::TimeSeries(std::move(seconds));
}

nephoscope::TextureSets vtkTextureCoordinateAdvection::Sets() const
{
  nephoscope::TextureSets sets;
  sets.Period = this->Period;
  return sets;
}

double vtkTextureCoordinateAdvection::RequestedSeconds() const
{
  const auto& times = this->State->PipelineTimes;
  const double seconds =
    (this->State->Requested - (times.empty() ? 0.0 : times.front())) * this->TimeScale;
  // Times of a series in days or hours are not exact in seconds.
  const double nearest = std::round(seconds);
  return std::abs(seconds - nearest) < 1e-6 ? nearest : seconds;
}

int vtkTextureCoordinateAdvection::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto& state = *this->State;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  const auto& times = state.PipelineTimes;
  const bool readable = !times.empty() &&
    std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(b > a); }) ==
      times.end();
  const double first = times.empty() ? 0.0 : times.front();
  if (!state.Continuing)
  {
    state.Requested =
      output->Has(SDDP::UPDATE_TIME_STEP()) ? output->Get(SDDP::UPDATE_TIME_STEP()) : first;
  }
  state.AwaitsData = true;
  if ((readable || times.empty()) && IsPositive(this->TimeScale) && IsPositive(this->Period))
  {
    this->PlanReading();
  }
  if (readable)
  {
    input->Set(SDDP::UPDATE_TIME_STEP(), times[static_cast<std::size_t>(state.Next)]);
  }
  else
  {
    input->Remove(SDDP::UPDATE_TIME_STEP());
  }
  // Everywhere the whole of the winds: a path may come from anywhere.
  if (input->Has(SDDP::WHOLE_EXTENT()))
  {
    int whole[6];
    input->Get(SDDP::WHOLE_EXTENT(), whole);
    input->Set(SDDP::UPDATE_EXTENT(), whole, 6);
  }
  input->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
  input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  // While time steps are being read, points that come of the same source are asked for at the same time, lest it makes each
  // of them twice.
  vtkInformation* points = inputs[1]->GetInformationObject(0);
  if (points && readable)
  {
    const bool isLast = state.Steps.count(state.Needed.Last) > 0 || state.Next == state.Needed.Last;
    points->Set(SDDP::UPDATE_TIME_STEP(),
      isLast ? state.Requested : times[static_cast<std::size_t>(state.Next)]);
  }
  return 1;
}

void vtkTextureCoordinateAdvection::PlanReading()
{
  auto& state = *this->State;
  if (state.Continuing)
  {
    return; // the next one has been chosen
  }
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetExecutive());
  vtkMTimeType newest = pipeline ? pipeline->GetPipelineMTime() : this->GetMTime();
  if (state.MTime != newest)
  {
    state.Forget();
    state.MTime = newest;
  }
  const nephoscope::TimeSeries series = this->Series();
  const double time = this->RequestedSeconds();
  double begin = time;
  double whole = time;
  double end = time;
  for (int set = 0; set < nephoscope::TEXTURE_SETS; ++set)
  {
    const nephoscope::SetPlan plan = this->PlanSet(set, time);
    begin = std::min(begin, plan.Birth);
    whole = std::min(whole, plan.Times[0]);
    end = std::max(end, plan.Weight > 0.0 ? plan.Times[1] : plan.Times[0]);
  }
  state.Needed = { series.Find(begin).Earlier, series.Find(end).Later, series.Find(whole).Earlier };
  for (auto step = state.Steps.begin(); step != state.Steps.end();)
  {
    const bool isNeeded = step->first >= state.Needed.First && step->first <= state.Needed.Last;
    if (isNeeded && step->first < state.Needed.Whole)
    {
      step->second.Data = nullptr;
    }
    step = isNeeded ? std::next(step) : state.Steps.erase(step);
  }
  this->ChooseNext();
}

// The first needed time step that is not in memory; true if there is one.
bool vtkTextureCoordinateAdvection::ChooseNext()
{
  auto& state = *this->State;
  for (int i = state.Needed.First; i <= state.Needed.Last; ++i)
  {
    const auto step = state.Steps.find(i);
    if (step == state.Steps.end() || (i >= state.Needed.Whole && !step->second.Data))
    {
      state.Next = i;
      return true;
    }
  }
  const int last = static_cast<int>(state.PipelineTimes.size()) - 1;
  state.Next = std::clamp(state.Next, 0, std::max(last, 0)); // what has been read last, so that nothing is read
  return false;
}

int vtkTextureCoordinateAdvection::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto& state = *this->State;
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkDataSet* output = vtkDataSet::GetData(outInfo);
  state.AwaitsData = false;
  output->Initialize();
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkDataSet* data = vtkDataSet::SafeDownCast(input);
  if (!data)
  {
    vtkErrorMacro("The input is " << (input ? input->GetClassName() : "missing")
      << "; one grid is needed. Merge or extract blocks first.");
    this->Stop(request);
    return 1;
  }
  if (!this->CheckSettings() || !this->CheckSeries() ||
    !this->ReadTimeStep(data, inputs[0]->GetInformationObject(0)))
  {
    this->Stop(request);
    return 1;
  }
  if (!this->Report(0.0))
  {
    this->Stop(request);
    return 1;
  }
  if (this->ChooseNext())
  {
    state.Continuing = true;
    request->Set(SDDP::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  state.Continuing = false;
  request->Remove(SDDP::CONTINUE_EXECUTING());
  this->NumberOfTimeStepsHeld = static_cast<int>(state.Steps.size());
  const bool hasPoints = this->GetNumberOfInputConnections(1) > 0;
  if (!this->MakeTexture(hasPoints ? vtkDataSet::GetData(inputs[1], 0) : nullptr, outInfo, output))
  {
    output->Initialize(); // nothing rather than a part
  }
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), state.Requested);
  return 1;
}

void vtkTextureCoordinateAdvection::Stop(vtkInformation* request)
{
  this->State->Forget();
  this->State->Continuing = false;
  this->NumberOfSteps = 0;
  this->NumberOfTimeStepsHeld = 0;
  request->Remove(SDDP::CONTINUE_EXECUTING());
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
      vtkWarningMacro("The wind array '" << state.Arrays.Velocity.Name << "' is not a finite number at "
        << step.Wind->Missing << " of " << input->GetNumberOfPoints()
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
  if (IsStructured(input) && inInfo->Has(SDDP::WHOLE_EXTENT()))
  {
    inInfo->Get(SDDP::WHOLE_EXTENT(), whole);
    vtkIdType points = 1;
    for (int a = 0; a < 3; ++a)
    {
      points *= whole[2 * a + 1] - whole[2 * a] + 1;
    }
    if (points != input->GetNumberOfPoints())
    {
      vtkErrorMacro("Only " << input->GetNumberOfPoints() << " of the " << points
        << " points of the grid have been delivered. Paths need all the winds: let a reader or Globe Grid, which deliver "
           "the whole grid on request, be the input.");
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
  settings.TimeStep = this->TimeStep;
  settings.Tolerance = this->Tolerance;
  const double radius =
    this->PlanetRadius > 0.0 ? this->PlanetRadius : this->Grid == MAP ? 6371000.0 : 0.0;
  nephoscope::GlobeShape shape;
  if (this->Grid != CARTESIAN &&
    shape.Recognize(input, static_cast<nephoscope::GridKind>(this->Grid), radius, problem))
  {
    if (state.Arrays.Velocity.OnCells)
    {
      vtkErrorMacro("The velocity '" << state.Arrays.Velocity.Name
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
    vtkErrorMacro("Grid is " << (this->Grid == GLOBE ? "Globe" : "Map") << ", but the input is not. " << problem);
    return false;
  }
  state.Flow =
    std::make_unique<nephoscope::CartesianFlow>(input, settings, this->TextureLength);
  return true;
}
