// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSmokePuffs.h"

#include "BlocksWithArray.h"
#include "ChangeOfInput.h"
#include "EmptyInput.h"
#include "OwnThreads.h"
#include "PointDensity.h"
#include "PuffPulse.h"
#include "Ranks.h"
#include "RequiredInput.h"
#include "SmokeData.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkSmokePuffs);

namespace
{
// The time information of the input.
struct InputTime
{
  explicit InputTime(vtkInformation* info)
  {
    const int steps = info->Has(SDDP::TIME_STEPS()) ? info->Length(SDDP::TIME_STEPS()) : 0;
    const double* range = info->Has(SDDP::TIME_RANGE()) ? info->Get(SDDP::TIME_RANGE()) : nullptr;
    this->Varies = steps > 1 || (steps == 0 && range && range[0] < range[1]);
    this->HasStep = steps == 1;
    this->Start = this->HasStep ? info->Get(SDDP::TIME_STEPS())[0] : range ? range[0] : 0.0;
    this->Length = range ? range[1] - range[0] : 0.0;
  }

  bool Varies = false;
  bool HasStep = false; // exactly one
  double Start = 0.0;
  double Length = 0.0; // from the first time to the last
};

std::string ArrayNames(vtkDataSetAttributes* attributes)
{
  std::string names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const char* name = attributes->GetArrayName(i);
    names += (i ? ", '" : "'") + std::string(name ? name : "") + "'";
  }
  return names.empty() ? "none" : names;
}

// An array of one number for each of `count` elements; otherwise null, and the problem described.
vtkDataArray* FindArray(vtkDataSetAttributes* attributes, const char* elements, const char* name,
  vtkIdType count, std::string& problem)
{
  vtkDataArray* array = attributes->GetArray(name);
  std::ostringstream text;
  if (!array)
  {
    text << "There is no numeric array '" << name << "' on " << elements << ". Arrays on "
         << elements << ": " << ArrayNames(attributes) << ". Connect a flow volume.";
  }
  else if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
  {
    text << "Array '" << name << "' has " << array->GetNumberOfTuples() << " values of "
         << array->GetNumberOfComponents() << " components where the input has " << count << " "
         << elements << ": one number is needed for each.";
  }
  problem = text.str();
  return problem.empty() ? array : nullptr;
}

// Reads doubles, which vtkFlowVolume writes, without a virtual call for each.
struct Numbers
{
  explicit Numbers(vtkDataArray* array)
    : Array(array)
    , Direct(vtkArrayDownCast<vtkDoubleArray>(array))
    , Values(this->Direct ? this->Direct->GetPointer(0) : nullptr)
  {
  }
  double operator[](vtkIdType i) const
  {
    return this->Values ? this->Values[i] : this->Array->GetComponent(i, 0);
  }

  vtkDataArray* Array;
  vtkDoubleArray* Direct;
  const double* Values;
};

// out[i] = min(density[i], maximum) pulse(age[i]); returns how many are not finite, which get 0.
template <typename Densities>
vtkIdType Fill(vtkDoubleArray* out, const Numbers& ages, const Densities& densities,
  const nephoscope::PuffPulse& pulse, double time, double maximum)
{
  double* values = out->GetPointer(0);
  std::atomic<vtkIdType> bad{ 0 };
  nephoscope::InParallel(out->GetNumberOfTuples(), [&](vtkIdType first, vtkIdType last) {
    vtkIdType badHere = 0;
    for (vtkIdType i = first; i < last; ++i)
    {
      const bool good = std::isfinite(densities[i]) && std::isfinite(ages[i]);
      values[i] = good ? std::min(densities[i], maximum) * pulse(ages[i], time) : 0.0;
      badHere += good ? 0 : 1;
    }
    bad += badHere;
  });
  return bad;
}

// The oldest age of the cells; 0 without any.
double OldestAge(vtkUnstructuredGrid* grid)
{
  vtkDataArray* ages = grid ? grid->GetCellData()->GetArray("Age") : nullptr;
  if (!ages)
  {
    return 0.0;
  }
  double oldest = 0.0;
  const Numbers numbers(ages);
  for (vtkIdType i = 0; i < ages->GetNumberOfTuples(); ++i)
  {
    oldest = std::isfinite(numbers[i]) ? std::max(oldest, numbers[i]) : oldest;
  }
  return oldest;
}

// About four puffs at a time, but none shorter than two time steps.
double AutomaticPeriod(double oldestAge, double timeStep, double width)
{
  return std::max(oldestAge > 0.0 ? 0.25 * oldestAge : 1.0, 2.0 * timeStep / width);
}

// Time between two layers of a flow volume, from the ages of its cells; 0 if it has one layer, or
// no numbers of layers.
double TimeStepOf(vtkUnstructuredGrid* smoke)
{
  vtkDataArray* ages = smoke ? smoke->GetCellData()->GetArray("Age") : nullptr;
  vtkDataArray* layers = smoke ? smoke->GetCellData()->GetArray("EmissionStep") : nullptr;
  if (!ages || !layers)
  {
    return 0.0;
  }
  double age[2], layer[2];
  ages->GetFiniteRange(age);
  layers->GetFiniteRange(layer);
  return layer[1] > layer[0] && age[1] > age[0] ? (age[1] - age[0]) / (layer[1] - layer[0]) : 0.0;
}

bool IsFirstRank()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}
}

vtkSmokePuffs::vtkSmokePuffs()
  : Blocks(std::make_unique<nephoscope::BlocksWithArray>(
      this, [](vtkDataSet* block) { return block->GetCellData()->HasArray("Density"); }))
  , Averages(new nephoscope::PointDensity)
{
}

vtkSmokePuffs::~vtkSmokePuffs() = default;

int vtkSmokePuffs::FillInputPortInformation(int, vtkInformation* info)
{
  nephoscope::TakeAnyData(info);
  return 1;
}

vtkTypeBool vtkSmokePuffs::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (nephoscope::HasOtherInput(this, this->ToldOfInput, request, inputs, outputs,
        { "vtkUnstructuredGrid" }, "Puffs are made of smoke. Connect a flow volume."))
  {
    return 1;
  }
  if (request->Has(SDDP::REQUEST_UPDATE_TIME()))
  {
    this->AskForTime(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkSmokePuffs::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->AnnounceTime(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  return 1;
}

void vtkSmokePuffs::AnnounceTime(vtkInformation* inInfo, vtkInformation* outInfo) const
{
  const InputTime input(inInfo);
  if (!input.Varies)
  {
    // An automatic period is that of the last update; before the first one, that of the data that
    // the input has, if any.
    double period = this->Period > 0.0 ? this->Period : this->ActualPeriod;
    if (period == 0.0)
    {
      vtkUnstructuredGrid* smoke = vtkUnstructuredGrid::GetData(inInfo);
      period = AutomaticPeriod(OldestAge(smoke), TimeStepOf(smoke), this->Width);
    }
    const double length = period / this->TimeScale;
    const double range[2] = { input.Start, input.Start + length };
    outInfo->Set(SDDP::TIME_RANGE(), range, 2);
    outInfo->Remove(SDDP::TIME_STEPS()); // ParaView takes the range from the steps where there are
                                         // any, were it only one
  }
}

int vtkSmokePuffs::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->AskForTime(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

void vtkSmokePuffs::AskForTime(vtkInformation* inInfo, vtkInformation* outInfo) const
{
  const InputTime input(inInfo);
  if (input.Varies || !outInfo->Has(SDDP::UPDATE_TIME_STEP()))
  {
    return;
  }
  if (input.HasStep)
  {
    inInfo->Set(SDDP::UPDATE_TIME_STEP(), input.Start);
  }
  else
  {
    inInfo->Remove(SDDP::UPDATE_TIME_STEP());
  }
}

int vtkSmokePuffs::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  output->ShallowCopy(input);
  nephoscope::IsEmptyInput(this, this->ToldOfEmptiness, inputs, outputs);
  double time = this->Time;
  if (outInfo->Has(SDDP::UPDATE_TIME_STEP()))
  {
    const double step = outInfo->Get(SDDP::UPDATE_TIME_STEP());
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step);
    time = step * this->TimeScale;
  }

  nephoscope::PuffPulse pulse;
  pulse.Width = this->Width;
  pulse.Period = this->Period;
  if (!(this->Period > 0.0))
  {
    pulse.Period = this->FindPeriod(input, inputs[0]->GetInformationObject(0));
  }
  pulse.Floor = this->Floor;
  pulse.Scale = this->Normalization == MEAN ? 1.0 / pulse.Mean() : 1.0;
  this->ActualPeriod = pulse.Period;
  this->AnnounceTime(inputs[0]->GetInformationObject(0), outInfo); // a period found just now

  // An input may have puffs itself; there are never two arrays of that name.
  output->GetCellData()->RemoveArray("SmokeDensity");
  output->GetPointData()->RemoveArray("SmokeDensity");
  this->WarnOfShortPuffs(output, pulse);
  if (output->GetNumberOfCells() > 0)
  {
    this->AddSmokeDensity(output, pulse, time);
  }
  return 1;
}

// Found once for all time steps of a series: puffs of another period would be elsewhere. Unsteady
// smoke grows until it is as old as the series is long.
double vtkSmokePuffs::FindPeriod(vtkUnstructuredGrid* smoke, vtkInformation* inInfo)
{
  const vtkMTimeType change = nephoscope::ChangeOfInput(this);
  const double oldest = nephoscope::MaximumOverRanks(OldestAge(smoke));
  const double step = nephoscope::MaximumOverRanks(TimeStepOf(smoke));
  if (nephoscope::MaximumOverRanks(change != this->Change || this->FoundAge == 0.0 ? 1.0 : 0.0) >
    0.0)
  {
    this->Change = change;
    this->FoundAge = oldest;
    this->FoundStep = step;
  }
  const bool grows = nephoscope::MaximumOverRanks(nephoscope::InitialSmokeDensity(smoke)) > 0.0;
  const double whole = grows ? InputTime(inInfo).Length * this->TimeScale : 0.0;
  return AutomaticPeriod(std::max(this->FoundAge, whole), this->FoundStep, this->Width);
}

void vtkSmokePuffs::WarnOfShortPuffs(vtkUnstructuredGrid* smoke, const nephoscope::PuffPulse& pulse)
{
  const double step =
    nephoscope::MaximumOverRanks(TimeStepOf(smoke)); // on every rank, also without cells
  const double longEnough = 2.0 * step / pulse.Width;
  const bool isTold =
    this->ToldPeriodAndStep[0] == pulse.Period && this->ToldPeriodAndStep[1] == step;
  if (pulse.Period > 0.999 * longEnough || pulse.Floor >= 1.0 || isTold || !IsFirstRank())
  {
    return;
  }
  this->ToldPeriodAndStep[0] = pulse.Period;
  this->ToldPeriodAndStep[1] = step;
  vtkWarningMacro(
    "Puffs are shorter than two time steps of the flow volume, so that they flicker and their mass changes: Period is "
    << pulse.Period << " s, the time step is " << step << " s. Set Period to " << longEnough
    << " s or more, or make the flow volume with time steps of " << 0.5 * pulse.Width * pulse.Period
    << " s or less.");
}

void vtkSmokePuffs::AddSmokeDensity(
  vtkUnstructuredGrid* output, const nephoscope::PuffPulse& pulse, double time)
{
  const bool onPoints = this->Association == POINTS;
  vtkDataSetAttributes* attributes =
    output->GetAttributes(onPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
  const vtkIdType count =
    output->GetNumberOfElements(onPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
  const char* elements = onPoints ? "points" : "cells";
  std::string problem;
  vtkDataArray* density =
    FindArray(output->GetCellData(), "cells", "Density", output->GetNumberOfCells(), problem);
  vtkDataArray* ages = density ? FindArray(attributes, elements, "Age", count, problem) : nullptr;
  if (!ages)
  {
    if (!this->Blocks->IsLackedBy(output))
    {
      vtkErrorMacro(<< problem << this->Blocks->NorInOthers());
      nephoscope::FailureCode::Set(this, true);
    }
    output->Initialize(); // the input itself would look like smoke
    return;
  }
  vtkNew<vtkDoubleArray> smoke;
  smoke->SetName("SmokeDensity");
  smoke->SetNumberOfTuples(count);
  const double maximum = this->MaximumDensity > 0.0 ? this->MaximumDensity : VTK_DOUBLE_MAX;
  const Numbers age(ages);
  const vtkIdType bad = onPoints
    ? Fill(smoke, age, this->Averages->Of(output, density), pulse, time, maximum)
    : Fill(smoke, age, Numbers(density), pulse, time, maximum);
  attributes->AddArray(smoke);
  if (bad > 0)
  {
    vtkWarningMacro(
      << bad << " " << elements
      << " have no smoke because array 'Age' or 'Density' is not finite there. Look at the "
         "velocity that made the flow volume.");
  }
}

void vtkSmokePuffs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Period: " << this->Period << " s\n";
  os << indent << "ActualPeriod: " << this->ActualPeriod << " s\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Floor: " << this->Floor << "\n";
  os << indent << "Normalization: " << (this->Normalization == MEAN ? "Mean" : "Peak") << "\n";
  os << indent << "MaximumDensity: " << this->MaximumDensity << "\n";
  os << indent << "Association: " << (this->Association == POINTS ? "Points" : "Cells") << "\n";
  os << indent << "Time: " << this->Time << " s\n";
  os << indent << "TimeScale: " << this->TimeScale << "\n";
}
