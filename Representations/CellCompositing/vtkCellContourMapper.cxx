// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellContourMapper.h"

#include "ContourSettings.h"

#include <algorithm>
#include <cmath>
#include <iterator>

using nephoscope::ContourSettings;

namespace
{
double ClampToUnit(double x)
{
  return x > 0.0 ? std::min(x, 1.0) : 0.0; // NaN becomes 0
}

/** Replaces `value`; true when it was different. */
template <typename Value>
bool Replace(Value& value, const Value& now)
{
  const bool changed = value != now;
  value = now;
  return changed;
}
}

vtkCellContourMapper::vtkCellContourMapper()
  : Contours(new ContourSettings)
{
}

vtkCellContourMapper::~vtkCellContourMapper() = default;

bool vtkCellContourMapper::CheckContour(int i)
{
  if (i >= 0 && i < this->GetNumberOfContourValues())
  {
    return true;
  }
  vtkErrorMacro("There is no contour value "
    << i << ": there are " << this->GetNumberOfContourValues()
    << ". Call SetNumberOfContourValues or SetContourValue first.");
  return false;
}

void vtkCellContourMapper::SetContourValue(int i, double value)
{
  if (i < 0 || !std::isfinite(value))
  {
    vtkErrorMacro("Contour value " << i << " is " << value
                                   << ": numbers count from 0, and values must be finite.");
    return;
  }
  if (i >= this->GetNumberOfContourValues())
  {
    this->SetNumberOfContourValues(i + 1);
  }
  if (Replace(this->Contours->Surfaces[static_cast<std::size_t>(i)].Value, value))
  {
    this->Modified();
  }
}

double vtkCellContourMapper::GetContourValue(int i)
{
  return this->CheckContour(i) ? this->Contours->Surfaces[static_cast<std::size_t>(i)].Value : 0.0;
}

void vtkCellContourMapper::SetNumberOfContourValues(int number)
{
  const std::size_t size = static_cast<std::size_t>(std::max(number, 0));
  if (size != this->Contours->Surfaces.size())
  {
    this->Contours->Surfaces.resize(size);
    this->Modified();
  }
}

int vtkCellContourMapper::GetNumberOfContourValues() const
{
  return static_cast<int>(this->Contours->Surfaces.size());
}

void vtkCellContourMapper::GenerateContourValues(int number, double low, double high)
{
  this->SetNumberOfContourValues(number);
  for (int i = 0; i < number; ++i)
  {
    this->SetContourValue(i, number > 1 ? low + (high - low) * i / (number - 1) : low);
  }
}

void vtkCellContourMapper::SetContourOpacity(int i, double opacity)
{
  if (this->CheckContour(i) &&
    Replace(this->Contours->Surfaces[static_cast<std::size_t>(i)].Opacity, ClampToUnit(opacity)))
  {
    this->Modified();
  }
}

void vtkCellContourMapper::SetContourOpacity(double opacity)
{
  for (int i = 0; i < this->GetNumberOfContourValues(); ++i)
  {
    this->SetContourOpacity(i, opacity);
  }
}

double vtkCellContourMapper::GetContourOpacity(int i)
{
  return this->CheckContour(i) ? this->Contours->Surfaces[static_cast<std::size_t>(i)].Opacity
                               : 0.0;
}

void vtkCellContourMapper::SetContourColor(int i, double red, double green, double blue)
{
  const std::array<double, 3> color = { { ClampToUnit(red), ClampToUnit(green),
    ClampToUnit(blue) } };
  if (this->CheckContour(i) &&
    Replace(this->Contours->Surfaces[static_cast<std::size_t>(i)].Color, color))
  {
    this->Modified();
  }
}

void vtkCellContourMapper::SetContourColorToFunction(int i)
{
  if (this->CheckContour(i) &&
    Replace(this->Contours->Surfaces[static_cast<std::size_t>(i)].Color,
      ContourSettings::Surface().Color))
  {
    this->Modified();
  }
}

void vtkCellContourMapper::GetContourColor(int i, double rgb[3])
{
  const ContourSettings::Surface surface = this->CheckContour(i)
    ? this->Contours->Surfaces[static_cast<std::size_t>(i)]
    : ContourSettings::Surface();
  std::copy(surface.Color.begin(), surface.Color.end(), rgb);
}

void vtkCellContourMapper::SetContourArrayName(const std::string& name)
{
  if (Replace(this->Contours->ArrayName, name))
  {
    this->Modified();
  }
}

std::string vtkCellContourMapper::GetContourArrayName()
{
  return this->Contours->ArrayName;
}

void vtkCellContourMapper::SetContourLighting(bool lighting)
{
  if (Replace(this->Contours->Lighting, lighting))
  {
    this->Modified();
  }
}

bool vtkCellContourMapper::GetContourLighting()
{
  return this->Contours->Lighting;
}

void vtkCellContourMapper::SetSmoothContourNormals(bool smooth)
{
  if (Replace(this->Contours->SmoothNormals, smooth))
  {
    this->Modified();
  }
}

bool vtkCellContourMapper::GetSmoothContourNormals()
{
  return this->Contours->SmoothNormals;
}

void vtkCellContourMapper::SetPolygons(int polygons)
{
  const int which = std::min(std::max(polygons, int(NO_POLYGONS)), int(ALL_POLYGONS));
  if (Replace(this->Contours->Polygons, static_cast<nephoscope::CellPolygons::Which>(which)))
  {
    this->Modified();
  }
}

int vtkCellContourMapper::GetPolygons()
{
  return static_cast<int>(this->Contours->Polygons);
}

void vtkCellContourMapper::SetPolygonOpacity(int contour, double opacity)
{
  if (Replace(this->Contours->ChangePolygon(contour).Opacity, ClampToUnit(opacity)))
  {
    this->Modified();
  }
}

void vtkCellContourMapper::SetPolygonOpacity(double opacity)
{
  bool changed = Replace(this->Contours->Polygon.Opacity, ClampToUnit(opacity));
  for (auto& polygon : this->Contours->PolygonsOfContour)
  {
    changed = Replace(polygon.second.Opacity, ClampToUnit(opacity)) || changed;
  }
  if (changed)
  {
    this->Modified();
  }
}

double vtkCellContourMapper::GetPolygonOpacity(int contour)
{
  return this->Contours->FindPolygon(contour).Opacity;
}

void vtkCellContourMapper::SetPolygonColor(int contour, double red, double green, double blue)
{
  const std::array<double, 3> color = { { ClampToUnit(red), ClampToUnit(green),
    ClampToUnit(blue) } };
  if (Replace(this->Contours->ChangePolygon(contour).Color, color))
  {
    this->Modified();
  }
}

void vtkCellContourMapper::SetPolygonColorToFunction(int contour)
{
  if (Replace(this->Contours->ChangePolygon(contour).Color, ContourSettings::Surface().Color))
  {
    this->Modified();
  }
}

void vtkCellContourMapper::GetPolygonColor(int contour, double rgb[3])
{
  const ContourSettings::Surface& polygon = this->Contours->FindPolygon(contour);
  std::copy(polygon.Color.begin(), polygon.Color.end(), rgb);
}

void vtkCellContourMapper::SetLayerProperty(int layer, vtkVolumeProperty* property)
{
  if (property)
  {
    this->Contours->LayerProperties[layer] = property;
  }
  else
  {
    this->Contours->LayerProperties.erase(layer);
  }
  this->Modified();
}

vtkVolumeProperty* vtkCellContourMapper::GetLayerProperty(int layer)
{
  const auto found = this->Contours->LayerProperties.find(layer);
  return found == this->Contours->LayerProperties.end() ? nullptr : found->second.Get();
}

void vtkCellContourMapper::RemoveAllLayerProperties()
{
  this->Contours->LayerProperties.clear();
  this->Modified();
}

int vtkCellContourMapper::GetNumberOfLayerProperties() const
{
  return static_cast<int>(this->Contours->LayerProperties.size());
}

int vtkCellContourMapper::GetLayerWithProperty(int i) const
{
  return i >= 0 && i < this->GetNumberOfLayerProperties()
    ? std::next(this->Contours->LayerProperties.begin(), i)->first
    : 0;
}

void vtkCellContourMapper::SetLayerArrayName(const std::string& name)
{
  if (Replace(this->Contours->LayerArrayName, name))
  {
    this->Modified();
  }
}

std::string vtkCellContourMapper::GetLayerArrayName()
{
  return this->Contours->LayerArrayName;
}

void vtkCellContourMapper::SetLayersFromContours(bool layers)
{
  if (Replace(this->Contours->LayersFromContours, layers))
  {
    this->Modified();
  }
}

bool vtkCellContourMapper::GetLayersFromContours()
{
  return this->Contours->LayersFromContours;
}

void vtkCellContourMapper::ShallowCopy(vtkAbstractMapper* other)
{
  this->Superclass::ShallowCopy(other);
  if (auto* mapper = vtkCellContourMapper::SafeDownCast(other))
  {
    *this->Contours = *mapper->Contours;
    this->Modified();
  }
}

void vtkCellContourMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Contours:";
  for (const ContourSettings::Surface& surface : this->Contours->Surfaces)
  {
    os << " " << surface.Value << " (opacity " << surface.Opacity << ")";
  }
  os << "\n" << indent << "ContourArrayName: " << this->Contours->ArrayName << "\n";
  os << indent << "ContourLighting: " << this->Contours->Lighting << "\n";
  os << indent << "SmoothContourNormals: " << this->Contours->SmoothNormals << "\n";
  const char* const polygons[] = { "None", "Contours", "All" };
  os << indent << "Polygons: " << polygons[this->GetPolygons()] << " (opacity "
     << this->Contours->Polygon.Opacity;
  for (const auto& polygon : this->Contours->PolygonsOfContour)
  {
    os << ", " << polygon.first << ": " << polygon.second.Opacity;
  }
  os << ")\n" << indent << "LayerArrayName: " << this->Contours->LayerArrayName << "\n";
  os << indent << "LayersFromContours: " << this->Contours->LayersFromContours << "\n";
  os << indent << "Layers with a property: " << this->Contours->LayerProperties.size() << "\n";
}
