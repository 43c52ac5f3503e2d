// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSunlight.h"

#include "ArrayNames.h"
#include "CloudShadow.h"
#include "DiffuseLight.h"
#include "DirectionalLight.h"
#include "LitData.h"
#include "PhaseFunction.h"
#include "SharedSun.h"
#include "SmokeOptics.h"
#include "SolarPosition.h"
#include "Vector3.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkSunlight);

using nephoscope::dot;
using nephoscope::quotedArrayNames;
using nephoscope::Vector;

namespace
{
// Up on a globe: away from the centre; elsewhere z.
std::array<double, 3> upAt(const nephoscope::Planet& planet, const std::array<double, 3>& place)
{
  const double length = std::sqrt(dot(place, place));
  return planet.Radius > 0 && length > 0
    ? std::array<double, 3>{ { place[0] / length, place[1] / length, place[2] / length } }
    : std::array<double, 3>{ { 0, 0, 1 } };
}

// Behind the planet there is no sun.
bool isInShadow(const nephoscope::Planet& planet, const std::array<double, 3>& place,
  const std::array<double, 3>& sun)
{
  if (planet.Radius <= 0)
  {
    return sun[2] < 0; // of flat ground
  }
  const double along = dot(place, sun);
  return along < 0 && dot(place, place) - along * along < planet.Radius * planet.Radius;
}

// Residues of a model's arithmetic are no cloud: divided by such an extinction, rounding errors of the light would count as light.
void cutResidues(std::vector<float>& extinction)
{
  constexpr float faintest = 1e-7f; // of the greatest
  const auto greatest = std::max_element(extinction.begin(), extinction.end());
  const float limit = greatest == extinction.end() ? 0.0f : faintest * *greatest;
  std::replace_if(
    extinction.begin(), extinction.end(), [limit](float one) { return one < limit; }, 0.0f);
}

vtkFloatArray* addArray(vtkDataSet* data, const char* name)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}
}

struct vtkSunlight::Work
{
  nephoscope::Planet Planet;
  std::array<double, 3> Sun;
  std::vector<nephoscope::Place> Places;
  std::vector<float> Extinction, Scaled, Albedo, Asymmetry; // the last two scaled
  std::vector<float> Transmittance, ScaledDepth;
  std::vector<float> Shadow; // of clouds of the second input, if there are any
  std::vector<float> Fluence, Up, Down, Absorbed;

  void StartDiffuse()
  {
    for (std::vector<float>* one : { &this->Fluence, &this->Up, &this->Down, &this->Absorbed })
    {
      one->assign(this->Places.size(), 0.0f);
    }
    this->Flux.assign(this->Places.size(), Vector{ { 0, 0, 0 } });
  }
  std::vector<Vector> Flux;
  vtkIdType Wrong = 0;
};

vtkSunlight::vtkSunlight()
{
  this->SetNumberOfInputPorts(3);
}

vtkSunlight::~vtkSunlight() = default;

int vtkSunlight::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkPolyData" : "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  return 1;
}

bool vtkSunlight::GoOn(double fraction)
{
  this->UpdateProgress(fraction);
  return !this->GetAbortExecute();
}

bool vtkSunlight::FindSun(vtkDataSet* data, std::array<double, 3>& sun)
{
  const bool onGlobe = nephoscope::planetOf(data).Radius > 0;
  if (vtkDataObject* source = this->GetInputDataObject(2, 0))
  {
    nephoscope::SharedSun shared;
    if (!nephoscope::readSun(source, shared))
    {
      vtkErrorMacro(
        << "The third input has no sun: it has no field array 'SunDirection'. It must be the output of vtkSunSource.");
      return false;
    }
    sun = onGlobe ? shared.DirectionOnGlobe : shared.Direction;
    return true;
  }
  std::copy(this->SunDirection, this->SunDirection + 3, sun.begin());
  if (!this->DateTime.empty())
  {
    double days = 0;
    if (!nephoscope::daysOf(this->DateTime, days))
    {
      vtkErrorMacro(<< "DateTime is '" << this->DateTime
                    << "'; it must be a date and time in UTC, such as '2011-10-11 18:30'.");
      return false;
    }
    const nephoscope::SubsolarPoint place = nephoscope::subsolarPoint(days);
    sun = onGlobe ? nephoscope::towardsSunOnGlobe(place)
                  : nephoscope::towardsSunAt(place, this->Longitude, this->Latitude);
  }
  const double length = std::sqrt(dot(sun, sun));
  if (!(length > 0) || !std::isfinite(length))
  {
    vtkErrorMacro(<< "SunDirection is " << sun[0] << ", " << sun[1] << ", " << sun[2]
                  << "; it must be finite and longer than 0.");
    return false;
  }
  std::transform(sun.begin(), sun.end(), sun.begin(), [length](double x) { return x / length; });
  return true;
}

bool vtkSunlight::Check(vtkDataSet* data)
{
  vtkDataArray* array = data->GetPointData()->GetArray(this->UsedExtinction.c_str());
  if (!array)
  {
    vtkErrorMacro(
      << "There is no array '" << this->ExtinctionArrayName
      << "' of the extinction. Make one by Cloud Optics, or set ExtinctionArrayName. Point arrays: "
      << quotedArrayNames(data->GetPointData())
      << "; cell arrays: " << quotedArrayNames(data->GetCellData()) << ".");
    return false;
  }
  if (array->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro(<< "The array '" << this->ExtinctionArrayName << "' has "
                  << array->GetNumberOfComponents() << " components; an extinction has one.");
    return false;
  }
  return true;
}

bool vtkSunlight::ReadOptics(vtkDataSet* data, Work& work)
{
  vtkIdType ignored = 0;
  work.Planet = nephoscope::planetOf(data);
  work.Places = nephoscope::placesOf(data);
  work.Extinction =
    nephoscope::valuesOf(data, this->UsedExtinction, 0, this->ExtinctionScale, work.Wrong);
  cutResidues(work.Extinction);
  work.Albedo = nephoscope::valuesOf(data, this->AlbedoArrayName, this->Albedo, 1, ignored);
  work.Asymmetry =
    nephoscope::valuesOf(data, this->AsymmetryArrayName, this->Asymmetry, 1, ignored);
  work.Scaled = work.Extinction;
  for (std::size_t p = 0; p < work.Scaled.size() && this->MultipleScattering; ++p)
  {
    const nephoscope::ScaledMedium medium =
      nephoscope::scaled(work.Extinction[p], std::min(work.Albedo[p], 1.0f), work.Asymmetry[p]);
    work.Scaled[p] = static_cast<float>(medium.Extinction);
    work.Albedo[p] = static_cast<float>(medium.Albedo);
    work.Asymmetry[p] = static_cast<float>(medium.Asymmetry);
  }
  if (work.Wrong > 0)
  {
    vtkWarningMacro(<< work.Wrong << (work.Wrong == 1 ? " value" : " values") << " of '"
                    << this->UsedExtinction
                    << "' negative or missing (NaN or a fill value), used as 0.");
  }
  return true;
}

bool vtkSunlight::TraceSun(vtkDataSet* data, Work& work)
{
  std::vector<nephoscope::Fields> fields(work.Places.size());
  for (std::size_t p = 0; p < fields.size(); ++p)
  {
    fields[p] = { { work.Extinction[p], work.Scaled[p] } };
  }
  const std::unique_ptr<nephoscope::SunPaths> paths =
    nephoscope::sunPathsOf(data, work.Places, fields, work.Sun);
  work.Transmittance.assign(fields.size(), 0.0f);
  work.ScaledDepth.assign(fields.size(), nephoscope::LightGrid::Night);
  const auto trace = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType p = begin; p < end; ++p)
    {
      if (!isInShadow(work.Planet, work.Places[p], work.Sun))
      {
        const std::array<double, 2> depths = paths->DepthsFrom(static_cast<std::int32_t>(p));
        work.Transmittance[p] = static_cast<float>(std::exp(-depths[0]));
        work.ScaledDepth[p] =
          static_cast<float>(std::min(depths[1], 0.99 * nephoscope::LightGrid::Night));
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
    vtkSMPTools::For(first, std::min(count, first + stretch), trace);
  }
  return true;
}

bool vtkSunlight::Shade(Work& work)
{
  vtkDataSet* clouds = vtkDataSet::SafeDownCast(this->GetInputDataObject(1, 0));
  if (!clouds)
  {
    return true;
  }
  work.Shadow = nephoscope::cloudShadow(clouds, work.Places);
  vtkDataArray* sun = clouds->GetFieldData()->GetArray("SunDirection");
  if (work.Shadow.empty() && !work.Places.empty())
  {
    vtkErrorMacro(
      << "The clouds have no array 'SunTransmittance': give them light by Sunlight first.");
    return false;
  }
  if (&work == this->Last.get() && sun && vtkMath::Dot(sun->GetTuple3(0), work.Sun.data()) < 0.9998)
  {
    vtkWarningMacro(
      << "The clouds are lit from another direction than these data: their shadows do not fit.");
  }
  return true;
}

// On structured data; otherwise Sample has made some of it.
bool vtkSunlight::Diffuse(vtkDataSet* data, Work& work)
{
  nephoscope::LightGrid grid;
  nephoscope::GridAxes axes;
  if (!nephoscope::makeGrid(data, work.Places, grid, axes))
  {
    return this->Sample(data, work);
  }
  grid.Extinction = work.Scaled;
  grid.Albedo = work.Albedo;
  grid.Asymmetry = work.Asymmetry;
  grid.Depth = work.ScaledDepth;
  grid.Shadow = work.Shadow;
  grid.GroundAlbedo = this->GroundAlbedo;
  grid.Sun.resize(grid.Points());
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector& e = axes.Axes[p][axis];
      grid.Sun[p][axis] =
        -static_cast<float>(e[0] * work.Sun[0] + e[1] * work.Sun[1] + e[2] * work.Sun[2]);
    }
  }
  grid.Sky.resize(grid.Columns());
  for (std::size_t c = 0; c < grid.Columns(); ++c)
  {
    const double elevation = dot(upAt(work.Planet, work.Places[c]), work.Sun);
    grid.Sky[c] =
      static_cast<float>(this->SkyLight * std::max(0.0, std::min(1.0, (elevation + 0.1) / 1.1)));
  }
  nephoscope::LightSettings settings;
  settings.Zenith = this->ZenithAngles;
  settings.Azimuth = this->AzimuthAngles;
  const auto parallel = [](int n, const std::function<void(int)>& body) {
    vtkSMPTools::For(0, n, 1, [&body](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        body(static_cast<int>(k));
      }
    });
  };
  const nephoscope::DiffuseLight light = nephoscope::diffuseLight(
    grid, settings, parallel, [this](double fraction) { return this->GoOn(0.5 + 0.5 * fraction); });
  this->NumberOfIterations = light.Iterations;
  this->LastChange = light.Change;
  work.Absorbed = light.Absorption;
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    work.Fluence[p] = std::max(light.Field.Fluence[p], 0.0f);
    work.Up[p] = std::max(light.Field.Up(p), 0.0f);
    work.Down[p] = std::max(light.Field.Down(p), 0.0f);
    const Vector& flux = light.Field.Flux[p];
    for (int c = 0; c < 3; ++c)
    {
      work.Flux[p][c] =
        flux[0] * axes.Axes[p][0][c] + flux[1] * axes.Axes[p][1][c] + flux[2] * axes.Axes[p][2][c];
    }
  }
  return !this->GetAbortExecute();
}

// The light of an image that has the optics of the data, back at the points of the data.
bool vtkSunlight::Sample(vtkDataSet* data, Work& work)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->CopyStructure(data);
  const std::pair<const char*, const std::vector<float>*> arrays[] = { { "Scaled", &work.Scaled },
    { "Albedo", &work.Albedo }, { "Asymmetry", &work.Asymmetry } };
  for (const auto& [name, values] : arrays)
  {
    std::copy(values->begin(), values->end(), addArray(copy, name)->GetPointer(0));
  }
  const nephoscope::SampleFrame frame(work.Planet, work.Places);
  const vtkSmartPointer<vtkImageData> image = frame.MakeImage(work.Places, 100000);
  const vtkSmartPointer<vtkDataSet> grid = frame.Sampled(copy, image);
  Work coarse;
  coarse.Planet = work.Planet;
  coarse.Sun = work.Sun;
  vtkIdType ignored = 0;
  coarse.Places = nephoscope::placesOf(grid);
  coarse.Scaled = nephoscope::valuesOf(grid, "Scaled", 0, 1, ignored);
  coarse.Albedo = nephoscope::valuesOf(grid, "Albedo", 0, 1, ignored);
  coarse.Asymmetry = nephoscope::valuesOf(grid, "Asymmetry", 0, 1, ignored);
  cutResidues(coarse.Scaled); // of interpolation
  coarse.Extinction = coarse.Scaled;
  coarse.StartDiffuse();
  if (!this->TraceSun(grid, coarse) || !this->Shade(coarse) || !this->Diffuse(grid, coarse))
  {
    return false;
  }
  vtkNew<vtkIdList> ids;
  double weights[8], parametric[3];
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    int sub = 0;
    const vtkIdType cell = image->FindCell(
      frame.FromPlace(work.Places[p]).data(), nullptr, -1, 1e-3, sub, parametric, weights);
    if (cell < 0)
    {
      continue;
    }
    image->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType q = ids->GetId(k);
      const float weight = static_cast<float>(weights[k]);
      work.Fluence[p] += weight * coarse.Fluence[q];
      work.Up[p] += weight * coarse.Up[q];
      work.Down[p] += weight * coarse.Down[q];
      work.Absorbed[p] += weight * coarse.Absorbed[q];
      for (int c = 0; c < 3; ++c)
      {
        work.Flux[p][c] += weight * coarse.Flux[q][c];
      }
    }
  }
  return true;
}

void vtkSunlight::Write(vtkDataSet* data, const Work& work)
{
  vtkFloatArray* light = addArray(data, "Sunlight");
  vtkFloatArray* extinction = addArray(data, "ScaledExtinction");
  vtkFloatArray* transmittance = addArray(data, "SunTransmittance");
  vtkFloatArray* irradiance = addArray(data, "Irradiance");
  vtkFloatArray* upward = addArray(data, "UpwardIrradiance");
  vtkFloatArray* absorbed = addArray(data, "AbsorbedLight");
  vtkSMPTools::For(0, data->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType p = begin; p < end; ++p)
    {
      double beam = 1, flux = 0;
      const double shadow = work.Shadow.empty() ? 1.0 : work.Shadow[p];
      const double sunlight = shadow * std::exp(-work.ScaledDepth[p]);
      if (this->UseViewPosition && !this->FollowCamera)
      {
        std::array<double, 3> toEye = { { this->ViewPosition[0], this->ViewPosition[1],
          this->ViewPosition[2] } };
        for (int c = 0; c < 3 && !this->ParallelView; ++c)
        {
          toEye[c] -= work.Places[p][c];
        }
        const double length = std::max(std::sqrt(dot(toEye, toEye)), 1e-300);
        beam =
          nephoscope::henyeyGreenstein(double(work.Asymmetry[p]), -dot(toEye, work.Sun) / length);
        flux = 3 * work.Asymmetry[p] *
          (toEye[0] * work.Flux[p][0] + toEye[1] * work.Flux[p][1] + toEye[2] * work.Flux[p][2]) /
          length;
      }
      const double source =
        0.25 * work.Albedo[p] * (std::max(work.Fluence[p] + flux, 0.0) + beam * sunlight);
      light->SetValue(p, static_cast<float>(source));
      extinction->SetValue(p, work.Scaled[p]);
      transmittance->SetValue(p, static_cast<float>(shadow * work.Transmittance[p]));
      const std::array<double, 3> up = upAt(work.Planet, work.Places[p]);
      irradiance->SetValue(
        p, static_cast<float>(std::max(dot(up, work.Sun), 0.0) * sunlight + work.Down[p]));
      upward->SetValue(p, work.Up[p]);
      absorbed->SetValue(p, work.Absorbed[p]);
    }
  });
  if (this->FollowCamera)
  {
    nephoscope::addDirectionalLight(data,
      { work.Extinction, work.Albedo, work.Asymmetry, work.Transmittance, work.ScaledDepth,
        work.Shadow, work.Flux, this->MultipleScattering },
      static_cast<nephoscope::PhaseKind>(this->PhaseFunction));
  }
  data->GetPointData()->SetActiveScalars("Sunlight");
  vtkNew<vtkDoubleArray> sun;
  sun->SetName("SunDirection");
  sun->SetNumberOfComponents(3);
  sun->InsertNextTuple(work.Sun.data());
  data->GetFieldData()->AddArray(sun);
}

// All that light depends on but the eye.
std::vector<double> vtkSunlight::State(vtkDataSet* input) const
{
  const auto number = [](const std::string& text) {
    return static_cast<double>(std::hash<std::string>{}(text));
  };
  const auto timeOf = [this](int port) {
    vtkDataObject* data = const_cast<vtkSunlight*>(this)->GetInputDataObject(port, 0);
    return data ? double(data->GetMTime()) : 0.0;
  };
  return { double(input->GetMTime()), timeOf(1), timeOf(2), this->SunDirection[0],
    this->SunDirection[1], this->SunDirection[2], this->Longitude, this->Latitude,
    this->ExtinctionScale, this->Albedo, this->Asymmetry, this->GroundAlbedo, this->SkyLight,
    double(this->MultipleScattering), double(this->ZenithAngles), double(this->AzimuthAngles),
    number(this->DateTime), number(this->ExtinctionArrayName), number(this->AlbedoArrayName),
    number(this->AsymmetryArrayName) };
}

bool vtkSunlight::Compute(vtkDataSet* data, Work& work)
{
  if (!this->Check(data) || !this->FindSun(data, work.Sun) || !this->ReadOptics(data, work) ||
    !this->GoOn(0.1) || !this->TraceSun(data, work))
  {
    return false;
  }
  work.StartDiffuse();
  return this->Shade(work) && (!this->MultipleScattering || this->Diffuse(data, work));
}

bool vtkSunlight::AddLight(vtkDataSet* data, vtkDataSet* input)
{
  std::vector<double> state = this->State(input);
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
  const Work& work = *this->Last;
  if (work.Planet.Radius <= 0 && work.Sun[2] < 0)
  {
    vtkWarningMacro(
      << "The sun is below the horizon: it is night, and the only light is that of the twilight sky.");
  }
  this->Write(data, work);
  return true;
}

int vtkSunlight::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0], 0);
  vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
  output->ShallowCopy(input);
  const bool isSmoke = this->ExtinctionArrayName == "Extinction" &&
    nephoscope::addSmokeOptics(output, this->AlbedoArrayName, this->AsymmetryArrayName);
  this->UsedExtinction = isSmoke ? nephoscope::smokeExtinctionName : this->ExtinctionArrayName;
  const char* name = this->UsedExtinction.c_str();
  if (!output->GetPointData()->HasArray(name) && output->GetCellData()->HasArray(name))
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
  if (output->GetNumberOfPoints() > 0 && !this->AddLight(output, input))
  {
    output->Initialize();
  }
  return 1;
}

void vtkSunlight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SunDirection: " << this->SunDirection[0] << ", " << this->SunDirection[1] << ", "
     << this->SunDirection[2] << "\n";
  os << indent << "DateTime: " << this->DateTime << "\n"
     << indent << "ExtinctionArrayName: " << this->ExtinctionArrayName << "\n";
  os << indent << "MultipleScattering: " << this->MultipleScattering << "\n"
     << indent << "GroundAlbedo: " << this->GroundAlbedo << "\n";
  os << indent << "FollowCamera: " << this->FollowCamera << "\n"
     << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "ZenithAngles: " << this->ZenithAngles << "\n"
     << indent << "AzimuthAngles: " << this->AzimuthAngles << "\n";
}
