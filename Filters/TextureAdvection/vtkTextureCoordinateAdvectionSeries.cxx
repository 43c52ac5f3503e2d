// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTextureCoordinateAdvection that reads a time series.
//
//   RequestInformation    the times of the series
//   RequestUpdateExtent   PlanReading: which time steps the request needs, which of them are in
//                         memory, which is read next
//   RequestData           ReadTimeStep; again (CONTINUE_EXECUTING) until all are there; MakeTexture
//
// Points (port 1) that come of the same source as the winds are asked for when all winds are in
// memory, in a pass of their own: a source can be asked for one time and one piece at once.
#include "vtkTextureCoordinateAdvection.h"

#include "MessageSuppression.h"
#include "RequiredInput.h"
#include "SharedSource.h"
#include "TextureState.h"

#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
void AskForSamePiece(vtkInformation* output, vtkInformation* input)
{
  input->CopyEntry(output, SDDP::UPDATE_PIECE_NUMBER());
  input->CopyEntry(output, SDDP::UPDATE_NUMBER_OF_PIECES());
  input->CopyEntry(output, SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  // The output may be on points of other extents, or of none.
  const bool sameGrid = input->Has(SDDP::WHOLE_EXTENT()) && output->Has(SDDP::WHOLE_EXTENT()) &&
    std::equal(input->Get(SDDP::WHOLE_EXTENT()), input->Get(SDDP::WHOLE_EXTENT()) + 6,
      output->Get(SDDP::WHOLE_EXTENT()));
  if (sameGrid && output->Has(SDDP::UPDATE_EXTENT()))
  {
    input->CopyEntry(output, SDDP::UPDATE_EXTENT());
  }
}

// Readers may fail when they are asked for a time after their last.
double TimeWithin(vtkInformation* info, double time)
{
  const auto within = [&](vtkInformationDoubleVectorKey* key) {
    const double* times = info->Get(key);
    const int count = info->Length(key);
    return count > 0 ? std::min(std::max(time, times[0]), times[count - 1]) : time;
  };
  return within(info->Has(SDDP::TIME_STEPS()) ? SDDP::TIME_STEPS() : SDDP::TIME_RANGE());
}
}

int vtkTextureCoordinateAdvection::FillInputPortInformation(int port, vtkInformation* info)
{
  // RequestData rejects a composite dataset with a sentence; it is not processed block by block.
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
  auto& state = *this->State;
  if (state.RestartsUpdate(request))
  {
    if (state.Continuing)
    {
      vtkErrorMacro("The input has not delivered the time step at "
        << state.NextTime() << ", so there are no texture coordinates.");
      state.Stop(this->GetExecutive());
    }
    state.Forget();
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkTextureCoordinateAdvection::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  auto& state = *this->State;
  if (state.TakeTimes(input))
  {
    state.Forget();
  }
  const auto& times = state.Times;
  vtkInformation* points = inputs[1]->GetInformationObject(0);
  state.SharesSource = points && nephoscope::HaveSharedSource(this, 0, 1);
  output->Remove(SDDP::WHOLE_EXTENT());
  if ((points ? points : input)->Has(SDDP::WHOLE_EXTENT()))
  {
    output->CopyEntry(points ? points : input, SDDP::WHOLE_EXTENT());
    output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  }
  vtkDataSet* winds = vtkDataSet::GetData(input);
  if (times.size() < 2 && winds && winds->GetNumberOfPoints() > 0)
  {
    this->TakePeriodOf(winds);
  }
  if (times.size() < 2 && nephoscope::IsPositive(this->TimeScale))
  {
    // A steady wind moves a texture all the same: something to animate.
    const double first = times.empty() ? 0.0 : times.front();
    const double range[2] = { first, first + this->GetPeriodUsed() / this->TimeScale };
    output->Set(SDDP::TIME_RANGE(), range, 2);
    output->Remove(SDDP::TIME_STEPS()); // of one step ParaView would make no animation
  }
  return 1;
}

bool vtkTextureCoordinateAdvection::HasSeries() const
{
  return this->State->Times.size() > 1;
}

nephoscope::TimeSeries vtkTextureCoordinateAdvection::Series() const
{
  const auto& times = this->State->Times;
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
  sets.Period = this->GetPeriodUsed();
  sets.FromGrid = this->StartFromGrid;
  return sets;
}

double vtkTextureCoordinateAdvection::RequestedSeconds() const
{
  const auto& times = this->State->Times;
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
  const auto& times = state.Times;
  const bool readable = !times.empty() && state.FirstOutOfOrder() == times.size();
  const double first = times.empty() ? 0.0 : times.front();
  if (!state.Continuing)
  {
    state.Requested =
      output->Has(SDDP::UPDATE_TIME_STEP()) ? output->Get(SDDP::UPDATE_TIME_STEP()) : first;
  }
  state.AwaitsData = true;
  if ((readable || times.empty()) && nephoscope::IsPositive(this->TimeScale) &&
    nephoscope::IsPositive(this->GetPeriodUsed()) && this->KnowsPeriod())
  {
    this->PlanReading();
  }
  else if (!state.Continuing && !this->KnowsPeriod())
  {
    state.Needed = { 0, 0, 0 }; // RequestData finds the period in the first time step
    state.Next = 0;
  }
  if (readable)
  {
    input->Set(SDDP::UPDATE_TIME_STEP(), state.NextTime());
  }
  else
  {
    input->Remove(SDDP::UPDATE_TIME_STEP());
  }
  nephoscope::AskForWholeExtent(
    input); // everywhere the whole of the winds: a path may come from anywhere
  if (vtkInformation* points = inputs[1]->GetInformationObject(0))
  {
    this->AskForPoints(input, points, output);
  }
  return 1;
}

void vtkTextureCoordinateAdvection::AskForPoints(
  vtkInformation* input, vtkInformation* points, vtkInformation* output)
{
  auto& state = *this->State;
  const auto askFor = [&](vtkInformation* info) {
    info->Set(SDDP::UPDATE_TIME_STEP(), TimeWithin(info, state.Requested));
    AskForSamePiece(output, info);
  };
  if (!state.SharesSource)
  {
    askFor(points);
  }
  else if (state.ReadsPoints)
  {
    askFor(points);
    // The winds, which are in memory, would ask the source for something else.
    askFor(input);
  }
  else
  {
    nephoscope::AskForWholeExtent(points);
    if (input->Has(SDDP::UPDATE_TIME_STEP()))
    {
      points->Set(SDDP::UPDATE_TIME_STEP(), input->Get(SDDP::UPDATE_TIME_STEP()));
    }
  }
}

void vtkTextureCoordinateAdvection::PlanReading()
{
  auto& state = *this->State;
  if (state.Continuing)
  {
    return; // the next one has been chosen
  }
  const vtkMTimeType newest = this->PipelineMTime();
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
  state.ReadsPoints = !this->ChooseNext() && state.SharesSource;
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
  const int last = static_cast<int>(state.Times.size()) - 1;
  state.Next = std::clamp(
    state.Next, 0, std::max(last, 0)); // what has been read last, so that nothing is read
  return false;
}

void vtkTextureCoordinateAdvection::ReportOtherInput(vtkDataObject* input)
{
  const std::string remedy = nephoscope::RemedyFor(input);
  vtkErrorMacro("The input is " << (input ? input->GetClassName() : "missing")
                                << "; one grid is needed."
                                << (remedy.empty() ? " Merge or extract blocks first." : remedy));
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
  nephoscope::ReportOnce report(this, state.Failed);
  if (!data)
  {
    this->ReportOtherInput(input);
    report.End(false);
    this->Stop(request);
    return 1;
  }
  const bool checked = this->CheckSettings() && this->CheckSeries();
  if (checked && !this->KnowsPeriod())
  {
    this->TakePeriodOf(data);
    this->PlanReading();
    if (state.Next != 0)
    {
      state.GoOn(request);
      return 1;
    }
  }
  if (!checked ||
    (!state.ReadsPoints && !this->ReadTimeStep(data, inputs[0]->GetInformationObject(0))))
  {
    report.End(false);
    this->Stop(request);
    return 1;
  }
  report.End(true);
  if (!this->Report(0.0))
  {
    this->Stop(request);
    return 1;
  }
  const bool needsPoints = state.SharesSource && !state.ReadsPoints;
  if (this->ChooseNext() || needsPoints)
  {
    state.ReadsPoints = needsPoints && !this->ChooseNext();
    state.GoOn(request);
    return 1;
  }
  state.End(request);
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
  this->State->ReadsPoints = false;
  this->NumberOfSteps = 0;
  this->NumberOfTimeStepsHeld = 0;
  this->State->End(request);
}
