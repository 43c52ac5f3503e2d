// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSunlight.h"

#include "ArrayNames.h"
#include "BlocksWithArray.h"
#include "CloudShadow.h"
#include "DataSets.h"
#include "EmptyInput.h"
#include "InputBlocks.h"
#include "LitData.h"
#include "OwnThreads.h"
#include "PhaseFunction.h"
#include "RequiredInput.h"
#include "SmokeData.h"
#include "SmokeOptics.h"
#include "Vector3.h"
#include "vtkSunlightInternals.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkSunlight);

using nephoscope::AddPointArray;
using nephoscope::Dot;
using nephoscope::QuotedArrayNames;

namespace
{
const char* const noExtinctionName = "NephoscopeNoExtinction"; // removed afterwards

// Behind the planet there is no sun.
bool IsInShadow(const nephoscope::Planet& planet, const std::array<double, 3>& place,
  const std::array<double, 3>& sun)
{
  if (planet.Radius <= 0)
  {
    return Dot(planet.Up, sun) < 0; // of flat ground
  }
  const double along = Dot(place, sun);
  return along < 0 && Dot(place, place) - along * along < planet.Radius * planet.Radius;
}

}

vtkSunlight::vtkSunlight()
  : Blocks(std::make_unique<nephoscope::BlocksWithArray>(
      this, [this](vtkDataSet* block) { return this->HasExtinction(block); },
      [this] { this->JoinClouds(); }))
{
  this->SetNumberOfInputPorts(3);
}

vtkSunlight::~vtkSunlight() = default;

int vtkSunlight::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkPolyData" : "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  if (port == 0)
  {
    nephoscope::TakeAnyData(info);
  }
  if (port == 1) // first, so that the pipeline does not iterate over its blocks
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  }
  return 1;
}

bool vtkSunlight::GoOn(double fraction)
{
  this->UpdateProgress(fraction);
  return !this->GetAbortExecute();
}

bool vtkSunlight::Check(vtkDataSet* data)
{
  vtkDataArray* array = data->GetPointData()->GetArray(this->UsedExtinction.c_str());
  if (!array)
  {
    vtkErrorMacro(
      << nephoscope::InBlock(this, data) << "There is no array '" << this->ExtinctionArrayName
      << "' of the extinction. Make one by Cloud Optics, or set ExtinctionArrayName. Point arrays: "
      << QuotedArrayNames(data->GetPointData()) << "; cell arrays: "
      << QuotedArrayNames(data->GetCellData()) << "." << this->Blocks->NorInOthers());
    return false;
  }
  if (array->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro(<< nephoscope::InBlock(this, data) << "The array '" << this->ExtinctionArrayName
                  << "' has " << array->GetNumberOfComponents()
                  << " components; an extinction has one.");
    return false;
  }
  return true;
}

bool vtkSunlight::CheckUp()
{
  const double length = vtkMath::Norm(this->Up);
  if (!(length > 0) || !std::isfinite(length))
  {
    vtkErrorMacro(<< "Up is " << this->Up[0] << ", " << this->Up[1] << ", " << this->Up[2]
                  << "; it must be finite and longer than 0.");
    return false;
  }
  return true;
}

// Smoke needs none.
bool vtkSunlight::HasExtinction(vtkDataSet* data) const
{
  const char* name = this->ExtinctionArrayName.c_str();
  return data->GetPointData()->HasArray(name) || data->GetCellData()->HasArray(name) ||
    (this->ExtinctionArrayName == "Extinction" && nephoscope::SmokeDensity(data));
}

// Such as the ground: light reaches it, and goes no further.
bool vtkSunlight::IsSurfaceBelowClouds(vtkDataSet* data)
{
  return this->ShadingClouds() && !this->HasExtinction(data) && !nephoscope::HasCellsInSpace(data);
}

// Irradiance from the sky, which fades with twilight.
float vtkSunlight::SkyAt(const std::array<double, 3>& place, const Work& work) const
{
  const double elevation = Dot(work.Planet.UpAt(place), work.Sun);
  return static_cast<float>(this->SkyLight * std::max(0.0, std::min(1.0, (elevation + 0.1) / 1.1)));
}

// A block without extinction beside others that have it, such as the ground below clouds.
void vtkSunlight::TakeForClearAir(vtkDataSet* data)
{
  const std::string& name = this->UsedExtinction;
  if (data->GetPointData()->HasArray(name.c_str()) || !this->Blocks->HasAny())
  {
    return;
  }
  vtkWarningMacro(
    << nephoscope::InBlock(this, data) << "It has no array '" << name
    << "' of the extinction and is treated as clear air. Make the array by Cloud Optics, if there are clouds.");
  AddPointArray(data, name.c_str())->FillValue(0.0f);
}

void vtkSunlight::ReadOptics(vtkDataSet* data, Work& work)
{
  vtkIdType ignored = 0, wrong = 0;
  work.Extinction =
    nephoscope::ValuesOf(data, this->UsedExtinction, 0, this->ExtinctionScale, wrong);
  work.Albedo = nephoscope::ValuesOf(data, this->AlbedoArrayName, this->Albedo, 1, ignored);
  work.Asymmetry =
    nephoscope::ValuesOf(data, this->AsymmetryArrayName, this->Asymmetry, 1, ignored);
  this->WarnOfValues(wrong);
}

void vtkSunlight::ScaleOptics(Work& work) const
{
  nephoscope::CutResidues(work.Extinction);
  work.Scaled = work.Extinction;
  double sum = 0, whole = 1e-30;
  for (std::size_t p = 0; p < work.Scaled.size(); ++p)
  {
    sum += work.Extinction[p] * double(work.Asymmetry[p]);
    whole += work.Extinction[p];
  }
  work.Taken = std::max(0.0, std::min(sum / whole, 1.0));
  for (std::size_t p = 0; p < work.Scaled.size() && this->MultipleScattering; ++p)
  {
    const nephoscope::ScaledMedium medium =
      nephoscope::Scaled(work.Extinction[p], std::min(work.Albedo[p], 1.0f), work.Asymmetry[p]);
    work.Scaled[p] = static_cast<float>(medium.Extinction);
    work.Albedo[p] = static_cast<float>(medium.Albedo);
    work.Asymmetry[p] = static_cast<float>(medium.Asymmetry);
  }
}

void vtkSunlight::WarnOfValues(vtkIdType wrong)
{
  if (wrong > 0)
  {
    vtkWarningMacro(<< wrong << (wrong == 1 ? " value" : " values") << " of '"
                    << this->UsedExtinction
                    << "' negative or missing (NaN or a fill value), used as 0.");
  }
}

bool vtkSunlight::TraceSun(vtkDataSet* data, Work& work)
{
  std::vector<nephoscope::Fields> fields(work.Places.size());
  for (std::size_t p = 0; p < fields.size(); ++p)
  {
    fields[p] = { { work.Extinction[p], work.Scaled[p] } };
  }
  const std::unique_ptr<nephoscope::SunPaths> paths =
    nephoscope::SunPathsOf(data, work.Places, fields, work.Sun, work.Repeats);
  work.Transmittance.assign(fields.size(), 0.0f);
  constexpr double mostByDay = 0.99 * nephoscope::LightGrid::Night;
  work.ScaledDepth.assign(fields.size(), nephoscope::LightGrid::Night);
  work.DiffuseDepth = work.ScaledDepth;
  const auto isLit = [&](
                       vtkIdType p) { return !IsInShadow(work.Planet, work.Places[p], work.Sun); };
  const auto trace = [&](vtkIdType begin, vtkIdType end) {
    std::vector<std::array<double, 2>> depths;
    for (vtkIdType p = begin, next = begin; p < end; p = next + 1)
    {
      for (next = p; next < end && isLit(next); ++next)
      {
      }
      depths.resize(next - p);
      paths->FindDepths(
        static_cast<std::int32_t>(p), static_cast<std::int32_t>(next), depths.data());
      for (const auto& [extinction, scaled] : depths)
      {
        work.Transmittance[p] = static_cast<float>(std::exp(-extinction));
        work.ScaledDepth[p] = static_cast<float>(std::min(scaled, mostByDay));
        const double mixed = extinction + work.Taken * (scaled - extinction);
        work.DiffuseDepth[p++] = static_cast<float>(std::min(mixed, mostByDay));
      }
    }
  };
  const vtkIdType count = data->GetNumberOfPoints(),
                  stretch = std::max<vtkIdType>(count / 20, 1000);
  for (vtkIdType first = 0; first < count; first += stretch)
  {
    if (!this->GoOn(0.2 + 0.3 * first / count))
    {
      return false;
    }
    nephoscope::InParallel(std::min(count - first, stretch),
      [&](vtkIdType begin, vtkIdType end) { trace(first + begin, first + end); });
  }
  return true;
}

bool vtkSunlight::Shade(Work& work)
{
  vtkDataSet* clouds = this->ShadingClouds();
  if (!clouds)
  {
    return true;
  }
  nephoscope::CloudShadow shadow = nephoscope::FindCloudShadow(clouds, work.Places, work.Sun);
  work.Shadow = std::move(shadow.Fraction);
  work.BelowClouds = std::move(shadow.Irradiance);
  if (work.Shadow.empty() && !work.Places.empty())
  {
    vtkErrorMacro(
      << "The clouds have no array 'SunTransmittance': give them light by Sunlight first.");
    return false;
  }
  return true;
}

// All that the light depends on, except the data and the eye.
std::vector<double> vtkSunlight::State() const
{
  const auto number = [](const std::string& text) {
    return static_cast<double>(std::hash<std::string>{}(text));
  };
  const auto timeOf = [this](int port) {
    return double(
      nephoscope::NewestMTime(const_cast<vtkSunlight*>(this)->GetInputDataObject(port, 0)));
  };
  return { timeOf(1), timeOf(2), this->SunDirection[0], this->SunDirection[1],
    this->SunDirection[2], this->Up[0], this->Up[1], this->Up[2], this->Longitude, this->Latitude,
    this->ExtinctionScale, this->Albedo, this->Asymmetry, this->GroundAlbedo, this->SkyLight,
    double(this->PeriodicSides), double(this->OpenSides), double(this->MultipleScattering),
    double(this->ZenithAngles), double(this->AzimuthAngles), number(this->DateTime),
    number(this->ExtinctionArrayName), number(this->AlbedoArrayName),
    number(this->AsymmetryArrayName) };
}

bool vtkSunlight::Compute(vtkDataSet* data, Work& work)
{
  if (!this->Check(data) || !this->CheckUp() || !this->FindSun(data, work.Sun))
  {
    return false;
  }
  this->ReadOptics(data, work);
  return this->ComputeLight(data, work);
}

// Needs the optics in `work`.
bool vtkSunlight::ComputeLight(vtkDataSet* data, Work& work)
{
  work.Planet = this->PlanetOf(data);
  work.Places = nephoscope::PlacesOf(data);
  this->ScaleOptics(work);
  if (!this->GoOn(0.1))
  {
    return false;
  }
  return this->PeriodicSides && !this->OnSurface ? this->LightRepeated(data, work)
                                                 : this->Light(data, work);
}

bool vtkSunlight::Light(vtkDataSet* data, Work& work)
{
  if (!this->TraceSun(data, work))
  {
    return false;
  }
  work.StartDiffuse();
  if (this->OnSurface)
  {
    std::transform(work.Places.begin(), work.Places.end(), work.Down.begin(),
      [&](const nephoscope::Place& place) { return this->SkyAt(place, work); });
  }
  const bool isScattered = this->MultipleScattering && !this->OnSurface;
  if (!this->Shade(work))
  {
    return false;
  }
  this->WarnOfOtherSun(work);
  return !isScattered || this->Diffuse(data, work);
}

bool vtkSunlight::AddLight(vtkDataSet* data, vtkDataSet* input)
{
  std::vector<double> state = this->State();
  state.push_back(static_cast<double>(input->GetMTime()));
  if (!this->Last || state != this->LastState)
  {
    this->Last = std::make_unique<Work>();
    if (!this->Compute(data, *this->Last))
    {
      this->Last.reset();
      return false;
    }
    this->LastState = std::move(state);
  }
  this->WarnOfLight(data, *this->Last);
  this->Write(data, *this->Last);
  return true;
}

vtkTypeBool vtkSunlight::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (nephoscope::HasOtherInput(this, this->ToldOfInput, request, inputs, outputs, { "vtkDataSet" },
        "It must be a dataset with points and cells."))
  {
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

// Smoke gets an extinction of its own.
void vtkSunlight::ChooseExtinction(vtkDataSet* data)
{
  const bool isSmoke = this->ExtinctionArrayName == "Extinction" &&
    nephoscope::AddSmokeOptics(data, this->AlbedoArrayName, this->AsymmetryArrayName,
      this->ColumnOfRanks > 0 ? this->ColumnOfRanks : nephoscope::SmokeColumn(data, nullptr));
  this->UsedExtinction = isSmoke ? nephoscope::smokeExtinctionName : this->ExtinctionArrayName;
}

int vtkSunlight::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0], 0);
  vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
  output->ShallowCopy(input);
  if (nephoscope::IsEmptyInput(this, this->ToldOfEmptiness, inputs, outputs))
  {
    return 1;
  }
  if (!this->Blocks->HasAny() && this->Blocks->IsLackedBy(input))
  {
    output->Initialize();
    return 1;
  }
  nephoscope::ReportOnce report(this, this->Failed);
  this->OnSurface = this->IsSurfaceBelowClouds(input);
  this->WarnOfPieces(input, outputs->GetInformationObject(0));
  this->ChooseExtinction(output);
  const char* name = this->UsedExtinction.c_str();
  this->OnCells = !output->GetPointData()->HasArray(name) && output->GetCellData()->HasArray(name);
  if (this->OnCells)
  {
    vtkSmartPointer<vtkDataSet> onCells;
    onCells.TakeReference(output->NewInstance());
    onCells->ShallowCopy(output);
    vtkNew<vtkCellDataToPointData> toPoints;
    toPoints->SetInputData(onCells);
    toPoints->PassCellDataOn();
    toPoints->Update();
    output->ShallowCopy(toPoints->GetOutput());
  }
  this->TakeForClearAir(output);
  if (this->OnSurface)
  {
    this->UsedExtinction = noExtinctionName;
    AddPointArray(output, noExtinctionName)->FillValue(0.0f);
  }
  nephoscope::CloudPart* part = this->FindPart(input);
  const bool success = part ? this->AddJointLight(output, *part) : this->AddLight(output, input);
  output->GetPointData()->RemoveArray(noExtinctionName);
  report.End(success || this->GetAbortExecute());
  if (success)
  {
    this->CropToPiece(output, inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  }
  else
  {
    output->Initialize();
  }
  return 1;
}

void vtkSunlight::SetAzimuthAngles(int count)
{
  const int clamped = count <= 0 ? 0 : std::max(4, std::min(count, 64));
  if (clamped != this->AzimuthAngles)
  {
    this->AzimuthAngles = clamped;
    this->Modified();
  }
}

void vtkSunlight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SunDirection: " << this->SunDirection[0] << ", " << this->SunDirection[1] << ", "
     << this->SunDirection[2] << "\n";
  os << indent << "Up: " << this->Up[0] << ", " << this->Up[1] << ", " << this->Up[2] << "\n";
  os << indent << "DateTime: " << this->DateTime << "\n"
     << indent << "ExtinctionArrayName: " << this->ExtinctionArrayName << "\n";
  os << indent << "MultipleScattering: " << this->MultipleScattering << "\n"
     << indent << "PeriodicSides: " << this->PeriodicSides << "\n"
     << indent << "OpenSides: " << this->OpenSides << "\n"
     << indent << "GroundAlbedo: " << this->GroundAlbedo << "\n";
  os << indent << "FollowCamera: " << this->FollowCamera << "\n"
     << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "ZenithAngles: " << this->ZenithAngles << "\n"
     << indent << "AzimuthAngles: " << this->AzimuthAngles << "\n";
}
