// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureCoordinateAdvection.h"

#include "ArrayBlend.h"
#include "TextureOutput.h"
#include "TextureState.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkTextureCoordinateAdvection);

vtkTextureCoordinateAdvection::vtkTextureCoordinateAdvection()
  : State(std::make_unique<nephoscope::TextureState>())
{
  this->SetNumberOfInputPorts(2);
}

vtkTextureCoordinateAdvection::~vtkTextureCoordinateAdvection() = default;

void vtkTextureCoordinateAdvection::SetPointsConnection(vtkAlgorithmOutput* points)
{
  this->SetInputConnection(1, points);
}

void vtkTextureCoordinateAdvection::SetName(std::string& member, const std::string& name)
{
  const std::string given = name == "None" ? std::string() : name;
  if (given != member)
  {
    member = given;
    this->Modified();
  }
}

void vtkTextureCoordinateAdvection::SetPressureArrayName(const std::string& name)
{
  this->SetName(this->PressureArrayName, name);
}

void vtkTextureCoordinateAdvection::SetOmegaArrayName(const std::string& name)
{
  this->SetName(this->OmegaArrayName, name);
}

void vtkTextureCoordinateAdvection::SetPressureArrayNames(
  const std::string& pressure, const std::string& omega)
{
  this->SetPressureArrayName(pressure);
  this->SetOmegaArrayName(omega);
}

// The data at a time, between two steps of the series if need be.
vtkSmartPointer<vtkDataSet> vtkTextureCoordinateAdvection::DataAt(double time) const
{
  const nephoscope::SeriesInterval interval = this->Series().Find(time);
  vtkDataSet* first = this->State->Steps.at(interval.Earlier).Data;
  auto data = vtkSmartPointer<vtkDataSet>::Take(first->NewInstance());
  if (interval.Fraction == 0.0)
  {
    data->ShallowCopy(first);
    return data;
  }
  data->DeepCopy(this->State->Steps.at(interval.Later).Data);
  nephoscope::BlendArrays(first->GetPointData(), interval.Fraction, data->GetPointData());
  nephoscope::BlendArrays(first->GetCellData(), interval.Fraction, data->GetCellData());
  auto* points = vtkPointSet::SafeDownCast(data);
  if (points && points->GetPoints())
  {
    vtkNew<vtkPointData> before;
    vtkNew<vtkPointData> after;
    const auto add = [](vtkPointSet* set, vtkPointData* to) {
      vtkSmartPointer<vtkDataArray> positions = set->GetPoints()->GetData();
      auto named = vtkSmartPointer<vtkDataArray>::Take(positions->NewInstance());
      named->ShallowCopy(positions);
      named->SetName("Positions");
      to->AddArray(named);
    };
    add(vtkPointSet::SafeDownCast(first), before);
    add(points, after);
    nephoscope::BlendArrays(before, interval.Fraction, after);
    points->GetPoints()->Modified();
  }
  return data;
}

nephoscope::SetPlan vtkTextureCoordinateAdvection::PlanSet(int set, double time)
{
  const nephoscope::TextureSets sets = this->Sets();
  const bool hasKeys = this->KeyFrameInterval > 0.0 && this->GetNumberOfInputConnections(1) == 0;
  nephoscope::SetPlan plan;
  plan.Birth = sets.Origin(set, time);
  const double life = this->GetPeriodUsed() - (plan.Birth - sets.Birth(set, time));
  const auto ages =
    nephoscope::KeyAgesAround(time - plan.Birth, hasKeys ? this->KeyFrameInterval : 0.0, life);
  plan.Times[0] = plan.Birth + ages.First;
  plan.Times[1] = plan.Birth + ages.Second;
  plan.Weight = ages.Weight;
  if (!hasKeys)
  {
    plan.Times[0] = plan.Times[1] = time;
    return plan;
  }
  // There may be no wind to follow after the last time step, so the last key is there.
  const double last = this->Series().Last();
  if (this->HasSeries() && time <= last && plan.Times[1] > last)
  {
    const double span = last - plan.Times[0];
    plan.Times[1] = span > 0.0 ? last : plan.Times[0];
    plan.Weight = span > 0.0 ? (time - plan.Times[0]) / span : 0.0;
  }
  return plan;
}

nephoscope::FlowStep vtkTextureCoordinateAdvection::PresentStep(
  const nephoscope::SeriesInterval& interval) const
{
  const auto wind = [&](int i) { return this->State->Steps.at(i).Wind.get(); };
  return { wind(interval.Earlier), wind(interval.Later), interval.Fraction, interval.Fraction,
    0.0 };
}

bool vtkTextureCoordinateAdvection::MakeTexture(
  vtkDataSet* points, vtkInformation* outInfo, vtkDataSet* output)
{
  const double time = this->RequestedSeconds();
  const nephoscope::SetPlan plans[2] = { this->PlanSet(0, time), this->PlanSet(1, time) };
  nephoscope::OutputPiece piece(
    outInfo, points ? nullptr : this->DataAt(time).Get(), this->NeedsStretch());
  if (piece.Differs(this->State->KeyExtent))
  {
    this->State->Keys.clear();
  }
  output->ShallowCopy(points ? points : piece.Of(this->DataAt(time)).Get());
  this->NumberOfSteps = 0;
  const bool keep = !points && this->KeyFrameInterval > 0.0;
  if (!keep)
  {
    this->State->Keys.clear();
  }
  if (!this->FollowPaths(plans, points, piece))
  {
    return false;
  }
  std::vector<float> displacements[2];
  for (int set = 0; set < nephoscope::TEXTURE_SETS; ++set)
  {
    displacements[set] =
      this->DisplacementsOf(set, plans[set], static_cast<std::size_t>(output->GetNumberOfPoints()));
  }
  this->WriteSets(displacements, output);
  if (this->NeedsStretch())
  {
    this->WriteStretch(displacements, output);
  }
  piece.Crop(output);
  return this->Report(1.0);
}

// Displacements that are not there yet, along one path for all sets that are needed at the same
// time.
bool vtkTextureCoordinateAdvection::FollowPaths(
  const nephoscope::SetPlan plans[2], vtkDataSet* points, const nephoscope::OutputPiece& piece)
{
  auto& keys = this->State->Keys;
  std::map<double, std::vector<int>> wanted;
  std::map<nephoscope::DisplacementKey, nephoscope::Displacements> kept;
  double length = 0.0;
  for (int set = 0; set < nephoscope::TEXTURE_SETS; ++set)
  {
    for (int i = 0; i < (plans[set].Weight > 0.0 ? 2 : 1); ++i)
    {
      const double time = plans[set].Times[i];
      const nephoscope::DisplacementKey key(set, plans[set].Birth, time);
      const auto known = keys.find(key);
      if (known != keys.end())
      {
        kept[key] = std::move(known->second);
      }
      else if (time > plans[set].Birth)
      {
        wanted[time].push_back(set);
      }
    }
  }
  keys = std::move(kept);
  const auto oldest = [&](const std::vector<int>& sets) {
    double birth = std::numeric_limits<double>::max();
    for (const int set : sets)
    {
      birth = std::min(birth, plans[set].Birth);
    }
    return birth;
  };
  for (const auto& path : wanted)
  {
    length += path.first - oldest(path.second);
  }
  double done = 0.0;
  for (const auto& path : wanted)
  {
    std::vector<int> sets = path.second;
    std::sort(
      sets.begin(), sets.end(), [&](int a, int b) { return plans[a].Birth > plans[b].Birth; });
    const vtkSmartPointer<vtkDataSet> starts =
      points ? vtkSmartPointer<vtkDataSet>(points) : piece.Of(this->DataAt(path.first));
    const auto report = [&](
                          double now) { return this->Report((done + path.first - now) / length); };
    if (!this->FollowFrom(path.first, sets, plans, starts, report))
    {
      keys.clear();
      return false;
    }
    done += path.first - oldest(sets);
  }
  return true;
}

bool vtkTextureCoordinateAdvection::FollowFrom(double start, const std::vector<int>& sets,
  const nephoscope::SetPlan plans[2], vtkDataSet* points, const std::function<bool(double)>& report)
{
  const nephoscope::TimeSeries series = this->Series();
  nephoscope::TextureFlow& flow = *this->State->Flow;
  std::vector<double> births;
  for (const int set : sets)
  {
    births.push_back(plans[set].Birth);
  }
  const auto take = [&](const nephoscope::PathStep& path) {
    nephoscope::FlowStep step = this->PresentStep(path.Interval);
    step.FromFraction = path.FromFraction;
    step.ToFraction = path.ToFraction;
    step.Seconds = path.To - path.From;
    flow.Advance(step);
    this->NumberOfSteps += static_cast<vtkIdType>(flow.Count());
    return report(path.To);
  };
  const auto arrive = [&](std::size_t s) {
    flow.Displacements(this->PresentStep(series.Find(births[s])),
      this->State->Keys[nephoscope::DisplacementKey(sets[s], births[s], start)]);
  };
  flow.Begin(points, this->PresentStep(series.Find(start)));
  return nephoscope::FollowBack(series, start, births, this->GetTimeStepUsed(), take, arrive);
}

std::vector<float> vtkTextureCoordinateAdvection::DisplacementsOf(
  int set, const nephoscope::SetPlan& plan, std::size_t count) const
{
  const auto find = [&](double time) {
    const auto known = this->State->Keys.find(nephoscope::DisplacementKey(set, plan.Birth, time));
    return known == this->State->Keys.end() ? std::vector<float>(3 * count, 0.0f) : known->second;
  };
  std::vector<float> displacements = find(plan.Times[0]);
  if (plan.Weight > 0.0)
  {
    const std::vector<float> second = find(plan.Times[1]);
    for (std::size_t i = 0; i < displacements.size(); ++i)
    {
      displacements[i] =
        static_cast<float>((1.0 - plan.Weight) * displacements[i] + plan.Weight * second[i]);
    }
  }
  return displacements;
}

void vtkTextureCoordinateAdvection::WriteSets(
  const std::vector<float> displacements[2], vtkDataSet* output)
{
  const nephoscope::TextureSets sets = this->Sets();
  const double time = this->RequestedSeconds();
  const auto places = this->State->Flow->GridCoordinates(output);
  double ages[2];
  double weights[2];
  for (int set = 0; set < nephoscope::TEXTURE_SETS; ++set)
  {
    nephoscope::AddCoordinates(
      set == 0 ? "TextureCoordinates1" : "TextureCoordinates2", places, displacements[set], output);
    ages[set] = time - sets.Origin(set, time);
    weights[set] = sets.Weight(set, time);
  }
  nephoscope::AddFieldValues("TextureWeights", weights, 2, output);
  nephoscope::AddFieldValues("TextureAges", ages, 2, output);
  nephoscope::AddUnits(this->State->Flow->Units(), output);
}

void vtkTextureCoordinateAdvection::WriteStretch(
  const std::vector<float> displacements[2], vtkDataSet* output)
{
  const nephoscope::TextureSets sets = this->Sets();
  const double time = this->RequestedSeconds();
  nephoscope::StretchWriter writer(*this->State->Flow, output);
  if (!writer.IsGrid())
  {
    vtkWarningMacro(
      "ComputeLyapunovExponent and MaximumStretch need neighbours on a grid: only an image, rectilinear or "
      "structured grid has them. Leave the points input empty.");
    return;
  }
  if (this->ComputeLyapunovExponent)
  {
    const int older = sets.Older(time);
    writer.AddExponents(writer.Stretches(displacements[older]), time - sets.Origin(older, time));
  }
  if (this->MaximumStretch > 0.0)
  {
    const double weights[2] = { sets.Weight(0, time), sets.Weight(1, time) };
    writer.AddWeights(writer.Stretches(displacements[0]), writer.Stretches(displacements[1]),
      weights, this->MaximumStretch);
  }
}

bool vtkTextureCoordinateAdvection::NeedsStretch() const
{
  return this->ComputeLyapunovExponent || this->MaximumStretch > 0.0;
}

bool vtkTextureCoordinateAdvection::Report(double fraction)
{
  this->UpdateProgress(fraction);
  return !this->CheckAbort();
}

void vtkTextureCoordinateAdvection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& value) {
    os << indent << name << ": " << value << "\n";
  };
  const char* integrators[] = { "Euler", "RungeKutta4", "RungeKutta45" };
  const char* grids[] = { "Automatic", "Globe", "Map", "Cartesian" };
  print("Period", this->Period);
  print("Integrator", integrators[this->Integrator]);
  print("TimeStep", this->TimeStep);
  print("Tolerance", this->Tolerance);
  print("TimeScale", this->TimeScale);
  print("KeyFrameInterval", this->KeyFrameInterval);
  print("Grid", grids[this->Grid]);
  print("PlanetRadius", this->PlanetRadius);
  print("CartesianCoordinates", this->CartesianCoordinates);
  print("StartFromGrid", this->StartFromGrid);
  print("TextureLength", this->TextureLength);
  print("PressureArrayName", this->PressureArrayName);
  print("OmegaArrayName", this->OmegaArrayName);
  print("ComputeLyapunovExponent", this->ComputeLyapunovExponent);
  print("MaximumStretch", this->MaximumStretch);
  print("NumberOfSteps", this->NumberOfSteps);
  print("NumberOfTimeStepsHeld", this->NumberOfTimeStepsHeld);
}
