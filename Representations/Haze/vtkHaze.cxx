// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHaze.h"

#include "HazeLink.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHaze);

namespace
{
constexpr double visibilityTimesExtinction = 3.912; // -ln 0.02, Koschmieder1924

bool IsFinite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}
}

void vtkHaze::SetHaze(vtkRenderer* renderer, vtkHaze* haze)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("vtkHaze::SetHaze needs a renderer.");
    return;
  }
  if (vtkHaze::GetHaze(renderer) == haze)
  {
    return;
  }
  if (nephoscope::HazeLink* old = nephoscope::HazeLink::Of(renderer))
  {
    old->Untie();
    renderer->GetInformation()->Remove(nephoscope::HazeLink::KEY());
  }
  if (haze)
  {
    if (!renderer->GetInformation())
    {
      vtkNew<vtkInformation> information;
      renderer->SetInformation(information);
    }
    vtkNew<nephoscope::HazeLink> link;
    link->Tie(renderer, haze);
    renderer->GetInformation()->Set(nephoscope::HazeLink::KEY(), link);
  }
}

vtkHaze* vtkHaze::GetHaze(vtkRenderer* renderer)
{
  nephoscope::HazeLink* link = nephoscope::HazeLink::Of(renderer);
  return link ? link->GetHaze() : nullptr;
}

void vtkHaze::SetPositive(double& member, const char* name, double value)
{
  if (!(value >= 0) || !std::isfinite(value))
  {
    vtkErrorMacro(<< name << " must be finite and not negative (0: from the scene), not " << value
                  << ": it stays " << member << ".");
  }
  else if (value != member)
  {
    member = value;
    this->Modified();
  }
}

void vtkHaze::SetVector(
  double member[3], const char* name, const char* need, const double value[3], bool valid)
{
  if (!valid)
  {
    vtkErrorMacro(<< name << " must be " << need << ", not (" << value[0] << ", " << value[1]
                  << ", " << value[2] << "): it stays as it is.");
  }
  else if (!std::equal(value, value + 3, member))
  {
    std::copy(value, value + 3, member);
    this->Modified();
  }
}

void vtkHaze::SetVisibility(double visibility)
{
  this->SetPositive(this->Visibility, "Visibility", visibility);
  if (visibility == this->Visibility)
  {
    this->Extinction = visibility > 0 ? visibilityTimesExtinction / visibility : -1;
  }
}

void vtkHaze::SetExtinction(double extinction)
{
  if (extinction == 0)
  {
    this->Extinction = 0;
    this->Visibility = VTK_DOUBLE_MAX;
    this->Modified();
    return;
  }
  this->SetPositive(this->Extinction, "Extinction", extinction);
  this->Visibility = extinction > 0 && extinction == this->Extinction
    ? visibilityTimesExtinction / extinction
    : this->Visibility;
}

void vtkHaze::SetScaleHeight(double height)
{
  this->SetPositive(this->ScaleHeight, "ScaleHeight", height);
}

void vtkHaze::SetVerticalExaggeration(double factor)
{
  this->SetPositive(this->VerticalExaggeration, "VerticalExaggeration", factor);
}

void vtkHaze::SetPlanetRadius(double radius)
{
  this->SetPositive(this->PlanetRadius, "PlanetRadius", radius);
}

void vtkHaze::SetColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  const bool valid = std::all_of(color, color + 3, [](double c) { return c >= 0 && c <= 1; });
  this->SetVector(this->Color, "Color", "from 0 to 1", color, valid);
}

void vtkHaze::SetSunDirection(double x, double y, double z)
{
  const double sun[3] = { x, y, z };
  this->SetVector(this->SunDirection, "SunDirection", "finite", sun, IsFinite(sun));
}

void vtkHaze::SetCenter(double x, double y, double z)
{
  const double center[3] = { x, y, z };
  this->SetVector(this->Center, "Center", "finite", center, IsFinite(center));
}

void vtkHaze::SetUpDirection(double x, double y, double z)
{
  const double up[3] = { x, y, z };
  const double squares = x * x + y * y + z * z;
  this->SetVector(this->UpDirection, "UpDirection", "finite and longer than 0", up,
    IsFinite(up) && squares > 0 && std::isfinite(squares));
}

void vtkHaze::SetBaseLevel(double level)
{
  if (!std::isfinite(level))
  {
    vtkErrorMacro(
      "BaseLevel must be finite, not " << level << ": it stays " << this->BaseLevel << ".");
  }
  else if (level != this->BaseLevel)
  {
    this->BaseLevel = level;
    this->Modified();
  }
}

void vtkHaze::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << this->Enabled << "\n"
     << indent << "Projection: "
     << (this->Projection == GLOBE    ? "Globe"
            : this->Projection == MAP ? "Map"
                                      : "Automatic")
     << "\n"
     << indent << "Visibility: " << this->Visibility << "\n"
     << indent << "Extinction: " << this->Extinction << "\n"
     << indent << "ScaleHeight: " << this->ScaleHeight << "\n"
     << indent << "VerticalExaggeration: " << this->VerticalExaggeration << "\n"
     << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n"
     << indent << "SunDirection: " << this->SunDirection[0] << " " << this->SunDirection[1] << " "
     << this->SunDirection[2] << "\n"
     << indent << "Asymmetry: " << this->Asymmetry << "\n"
     << indent << "CloudShadows: " << this->CloudShadows << "\n"
     << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n"
     << indent << "PlanetRadius: " << this->PlanetRadius << "\n"
     << indent << "UpDirection: " << this->UpDirection[0] << " " << this->UpDirection[1] << " "
     << this->UpDirection[2] << "\n"
     << indent << "BaseLevel: " << this->BaseLevel << "\n"
     << indent << "Background: " << this->Background << "\n";
}
