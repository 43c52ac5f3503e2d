// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of the sun, and warnings about it.
#include "vtkSunlight.h"

#include "EmptyInput.h"
#include "InputBlocks.h"
#include "LitData.h"
#include "SharedSun.h"
#include "SolarPosition.h"
#include "Vector3.h"
#include "vtkSunlightInternals.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using nephoscope::Dot;

// A surface below clouds has their Up.
nephoscope::Planet vtkSunlight::PlanetOf(vtkDataSet* data)
{
  nephoscope::Vector3 up{ { this->Up[0], this->Up[1], this->Up[2] } };
  vtkDataSet* clouds = this->OnSurface ? this->ShadingClouds() : nullptr;
  vtkDataArray* upOfClouds = clouds ? clouds->GetFieldData()->GetArray("Up") : nullptr;
  if (upOfClouds && upOfClouds->GetNumberOfComponents() == 3 && upOfClouds->GetNumberOfTuples() > 0)
  {
    upOfClouds->GetTuple(0, up.data());
  }
  return nephoscope::FindPlanet(data, nephoscope::Normalized(up));
}

// A map that is told no place has the sun of longitude and latitude 0, perhaps at night.
void vtkSunlight::WarnOfPlace(
  vtkDataSet* data, const std::array<double, 3>& sun, const std::array<double, 3>& sunOnGlobe)
{
  const double radius = nephoscope::RadiusOfMap(data);
  const nephoscope::Vector3 seenFromZero{ { sunOnGlobe[1], sunOnGlobe[2], sunOnGlobe[0] } };
  bool isElsewhere = false;
  if (radius > 0 && sun != sunOnGlobe && nephoscope::Distance(sun, seenFromZero) < 1e-9)
  {
    double middle[3];
    data->GetCenter(middle);
    const double longitude = vtkMath::DegreesFromRadians(middle[0] / radius),
                 latitude = vtkMath::DegreesFromRadians(middle[1] / radius);
    isElsewhere = std::hypot(longitude, latitude) > 15;
    if (isElsewhere && !this->ToldOfPlace)
    {
      vtkWarningMacro(
        << nephoscope::InBlock(this, data) << "The middle of the map is at longitude "
        << std::round(longitude) << " and latitude " << std::round(latitude)
        << ", but the sun is that of longitude 0 and latitude 0: set Longitude and Latitude as well as the date.");
    }
  }
  this->ToldOfPlace = isElsewhere;
}

bool vtkSunlight::FindSun(vtkDataSet* data, std::array<double, 3>& sun)
{
  const nephoscope::Planet planet = this->PlanetOf(data);
  const bool onGlobe = planet.Radius > 0;
  if (vtkDataObject* source = this->GetInputDataObject(2, 0))
  {
    nephoscope::SharedSun shared;
    if (!nephoscope::ReadSun(source, shared))
    {
      vtkAlgorithm* maker = nephoscope::ProducerOfInput(this, 2);
      if (maker && maker->GetErrorCode() != vtkErrorCode::NoError)
      {
        return false; // it has told why
      }
      vtkErrorMacro(
        << "The third input has no sun: it has no field array 'SunDirection'. It must be the output of vtkSunSource.");
      return false;
    }
    sun = onGlobe ? shared.DirectionOnGlobe : shared.Direction;
    this->WarnOfPlace(data, sun, shared.DirectionOnGlobe);
    return true;
  }
  std::copy(this->SunDirection, this->SunDirection + 3, sun.begin());
  if (!this->DateTime.empty())
  {
    double days = 0;
    if (!nephoscope::DaysOf(this->DateTime, days))
    {
      vtkErrorMacro(<< "DateTime is '" << this->DateTime
                    << "'; it must be a date and time in UTC, such as '2011-10-11 18:30'.");
      return false;
    }
    const nephoscope::SubsolarPoint place = nephoscope::FindSubsolarPoint(days);
    const auto sunOnGlobe = nephoscope::TowardsSunOnGlobe(place);
    const auto seen = nephoscope::TowardsSunAt(place, this->Longitude, this->Latitude);
    sun = onGlobe ? sunOnGlobe : planet.FromHorizon(seen);
    this->WarnOfPlace(data, onGlobe ? sunOnGlobe : seen, sunOnGlobe);
  }
  const double length = std::sqrt(Dot(sun, sun));
  if (!(length > 0) || !std::isfinite(length))
  {
    vtkErrorMacro(<< "SunDirection is " << sun[0] << ", " << sun[1] << ", " << sun[2]
                  << "; it must be finite and longer than 0.");
    return false;
  }
  std::transform(sun.begin(), sun.end(), sun.begin(), [length](double x) { return x / length; });
  return true;
}

void vtkSunlight::WarnOfOtherSun(const Work& work)
{
  vtkDataSet* clouds = this->ShadingClouds();
  vtkDataArray* sun = clouds ? clouds->GetFieldData()->GetArray("SunDirection") : nullptr;
  if (sun && vtkMath::Dot(sun->GetTuple3(0), work.Sun.data()) < 0.9998)
  {
    vtkWarningMacro(
      << "The clouds are lit from another direction than these data: their shadows do not fit.");
  }
}

void vtkSunlight::WarnOfLight(vtkDataSet* data, const Work& work)
{
  if (work.Planet.Radius <= 0 && Dot(work.Planet.Up, work.Sun) < 0)
  {
    vtkWarningMacro(
      << "The sun is below the horizon: it is night, and the only light is that of the twilight sky. Up is ("
      << work.Planet.Up[0] << ", " << work.Planet.Up[1] << ", " << work.Planet.Up[2]
      << "): set Up if the data have another vertical axis.");
  }
  this->WarnOfDepth(data, work);
}
