// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of the sun.
#include "vtkSunlight.h"

#include "EmptyInput.h"
#include "LitData.h"
#include "SharedSun.h"
#include "SolarPosition.h"
#include "Vector3.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"

#include <algorithm>
#include <cmath>

using nephoscope::dot;

nephoscope::Planet vtkSunlight::PlanetOf(vtkDataSet* data) const
{
  const double length = std::hypot(std::hypot(this->Up[0], this->Up[1]), this->Up[2]);
  return nephoscope::planetOf(
    data, { { this->Up[0] / length, this->Up[1] / length, this->Up[2] / length } });
}

bool vtkSunlight::FindSun(vtkDataSet* data, std::array<double, 3>& sun)
{
  const nephoscope::Planet planet = this->PlanetOf(data);
  const bool onGlobe = planet.Radius > 0;
  if (vtkDataObject* source = this->GetInputDataObject(2, 0))
  {
    nephoscope::SharedSun shared;
    if (!nephoscope::readSun(source, shared))
    {
      vtkAlgorithm* maker = nephoscope::producerOfInput(this, 2);
      if (maker && maker->GetErrorCode() != vtkErrorCode::NoError)
      {
        return false; // it has told why
      }
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
    sun = onGlobe
      ? nephoscope::towardsSunOnGlobe(place)
      : planet.FromHorizon(nephoscope::towardsSunAt(place, this->Longitude, this->Latitude));
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
