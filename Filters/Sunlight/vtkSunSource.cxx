// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSunSource.h"

#include "MessageSuppression.h"
#include "SharedSun.h"
#include "SolarPosition.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSunSource);

vtkSunSource::vtkSunSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkSunSource::~vtkSunSource() = default;

// Every rank has the sun: without pieces VTK asks the first rank only.
int vtkSunSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkSunSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  nephoscope::SharedSun sun;
  if (!this->DateTime.empty())
  {
    double days = 0;
    if (!nephoscope::DaysOf(this->DateTime, days) || !std::isfinite(this->HoursLater))
    {
      vtkErrorMacro(
        << "DateTime is '" << this->DateTime << "' and HoursLater " << this->HoursLater
        << "; they must be a date and time in UTC, such as '2011-10-11 18:30', and a number of hours.");
      nephoscope::FailureCode::Set(this, true);
      return 1; // without a sun
    }
    const nephoscope::SubsolarPoint place =
      nephoscope::FindSubsolarPoint(days + this->HoursLater / 24);
    sun.Direction = nephoscope::TowardsSunAt(place, this->Longitude, this->Latitude);
    sun.DirectionOnGlobe = nephoscope::TowardsSunOnGlobe(place);
  }
  else
  {
    const double* d = this->SunDirection;
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (!(length > 0) || !std::isfinite(length))
    {
      vtkErrorMacro(<< "SunDirection is " << d[0] << ", " << d[1] << ", " << d[2]
                    << "; it must be finite and longer than 0.");
      nephoscope::FailureCode::Set(this, true);
      return 1; // without a sun
    }
    std::transform(d, d + 3, sun.Direction.begin(), [length](double x) { return x / length; });
    sun.DirectionOnGlobe = sun.Direction;
  }
  nephoscope::FailureCode::Set(this, false);
  nephoscope::WriteSun(sun, vtkPolyData::GetData(outputs));
  return 1;
}

void vtkSunSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SunDirection: " << this->SunDirection[0] << ", " << this->SunDirection[1] << ", "
     << this->SunDirection[2] << "\n";
  os << indent << "DateTime: " << this->DateTime << "\n"
     << indent << "HoursLater: " << this->HoursLater << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n"
     << indent << "Latitude: " << this->Latitude << "\n";
}
