// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces and layers of vtkCellCompositingRepresentation, which hands them on to the
// mapper.
#include "vtkCellCompositingRepresentation.h"

#include "vtkCellCompositingMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
std::string ArrayName(const char* name)
{
  const std::string chosen = name ? name : "";
  return chosen == "None" ? std::string() : chosen;
}

template <typename List, typename Value>
void SetItem(List& list, int i, const Value& value)
{
  if (i >= 0)
  {
    list.resize(std::max(list.size(), static_cast<std::size_t>(i) + 1));
    list[static_cast<std::size_t>(i)] = value;
  }
}

std::size_t SizeOf(int number)
{
  return static_cast<std::size_t>(std::max(number, 0));
}

/**
 * A property with the functions of another, but for the colours where there are some, and a factor
 * on its extinction.
 */
void Imitate(vtkVolumeProperty* layer, vtkVolumeProperty* volume, double scale,
  vtkColorTransferFunction* colors)
{
  layer->SetScalarOpacity(volume->GetScalarOpacity());
  if (colors)
  {
    layer->SetColor(colors);
  }
  else if (volume->GetColorChannels() == 3)
  {
    layer->SetColor(volume->GetRGBTransferFunction());
  }
  else
  {
    layer->SetColor(volume->GetGrayTransferFunction());
  }
  const double distance =
    scale > 0.0 ? volume->GetScalarOpacityUnitDistance() / scale : VTK_DOUBLE_MAX;
  // To the mapper, exactly 1 means that of the volume.
  layer->SetScalarOpacityUnitDistance(distance == 1.0 ? std::nextafter(1.0, 2.0) : distance);
}
}

void vtkCellCompositingRepresentation::SetContourValue(int i, double value)
{
  this->Mapper->SetContourValue(i, value);
}

void vtkCellCompositingRepresentation::SetNumberOfContourValues(int number)
{
  this->Mapper->SetNumberOfContourValues(number);
  this->FollowContours();
}

void vtkCellCompositingRepresentation::SetContourOpacities(int i, double opacity)
{
  SetItem(this->ContourOpacities, i, opacity);
}

void vtkCellCompositingRepresentation::SetNumberOfContourOpacities(int number)
{
  this->ContourOpacities.resize(SizeOf(number));
}

void vtkCellCompositingRepresentation::SetContourColors(
  int i, double red, double green, double blue)
{
  SetItem(this->ContourColors, i, std::array<double, 3>{ { red, green, blue } });
}

void vtkCellCompositingRepresentation::SetNumberOfContourColors(int number)
{
  this->ContourColors.resize(SizeOf(number));
}

void vtkCellCompositingRepresentation::SetContourArray(const char* name)
{
  if (ArrayName(name) != this->Mapper->GetContourArrayName())
  {
    this->Mapper->SetContourArrayName(ArrayName(name));
    this->HasGradients = false; // they are those of another array
    this->FollowContours();
  }
}

void vtkCellCompositingRepresentation::SetContourLighting(bool lighting)
{
  this->Mapper->SetContourLighting(lighting);
  this->FollowContours();
}

void vtkCellCompositingRepresentation::SetSmoothContourNormals(bool smooth)
{
  this->Mapper->SetSmoothContourNormals(smooth);
  this->FollowContours();
}

void vtkCellCompositingRepresentation::SetLayerArray(const char* name)
{
  this->Mapper->SetLayerArrayName(ArrayName(name));
}

void vtkCellCompositingRepresentation::SetLayerOpacityScale(int layer, double scale)
{
  SetItem(this->LayerOpacityScales, layer, scale);
}

void vtkCellCompositingRepresentation::SetNumberOfLayerOpacityScales(int number)
{
  this->LayerOpacityScales.resize(SizeOf(number), 1.0);
}

void vtkCellCompositingRepresentation::SetLayerColor(
  int layer, double red, double green, double blue)
{
  SetItem(this->LayerColors, layer, std::array<double, 3>{ { red, green, blue } });
}

void vtkCellCompositingRepresentation::SetNumberOfLayerColors(int number)
{
  this->LayerColors.resize(SizeOf(number), { { -1.0, -1.0, -1.0 } });
}

void vtkCellCompositingRepresentation::AddLayerColorFunction(vtkScalarsToColors* function)
{
  this->LayerColorFunctions.emplace_back(vtkColorTransferFunction::SafeDownCast(function));
}

// On one rank the mapper finds the normals. On several it lacks the cells of the others.
bool vtkCellCompositingRepresentation::NeedsGradients() const
{
  return GetNumberOfRanks() > 1 && this->Mapper->GetNumberOfContourValues() > 0 &&
    this->Mapper->GetContourLighting() && this->Mapper->GetSmoothContourNormals();
}

void vtkCellCompositingRepresentation::FollowContours()
{
  if (this->NeedsGradients() && !this->HasGradients)
  {
    this->MarkModified();
  }
}

double vtkCellCompositingRepresentation::FindContourOpacity(std::size_t i) const
{
  return (i < this->ContourOpacities.size() ? this->ContourOpacities[i] : this->ContourOpacity) *
    this->Opacity;
}

void vtkCellCompositingRepresentation::PrepareContours()
{
  for (int i = 0; i < this->Mapper->GetNumberOfContourValues(); ++i)
  {
    const std::size_t k = static_cast<std::size_t>(i);
    this->Mapper->SetContourOpacity(i, this->FindContourOpacity(k));
    if (k < this->ContourColors.size())
    {
      const std::array<double, 3>& rgb = this->ContourColors[k];
      this->Mapper->SetContourColor(i, rgb[0], rgb[1], rgb[2]);
    }
    else
    {
      this->Mapper->SetContourColorToFunction(i);
    }
  }
}

// Goes to the property that was chosen for this picture, which may be that of a uniform medium.
void vtkCellCompositingRepresentation::PrepareMaterial()
{
  vtkVolumeProperty* property = this->Actor->GetProperty();
  property->SetAmbient(this->Ambient);
  property->SetDiffuse(this->Diffuse);
  property->SetSpecular(this->Specular);
  property->SetSpecularPower(this->SpecularPower);
}

void vtkCellCompositingRepresentation::SetPolygons(int polygons)
{
  this->Mapper->SetPolygons(polygons);
}

void vtkCellCompositingRepresentation::PreparePolygons()
{
  this->Mapper->SetPolygonOpacity(-1, this->ContourOpacity * this->Opacity);
  // What the lists had before is as what they never had.
  this->NumberOfPolygonLooks = std::max(
    { this->NumberOfPolygonLooks, this->ContourOpacities.size(), this->ContourColors.size() });
  for (std::size_t i = 0; i < this->NumberOfPolygonLooks; ++i)
  {
    const int contour = static_cast<int>(i);
    this->Mapper->SetPolygonOpacity(contour, this->FindContourOpacity(i));
    if (i < this->ContourColors.size())
    {
      this->Mapper->SetPolygonColor(
        contour, this->ContourColors[i][0], this->ContourColors[i][1], this->ContourColors[i][2]);
    }
    else
    {
      this->Mapper->SetPolygonColorToFunction(contour);
    }
  }
}

std::size_t vtkCellCompositingRepresentation::CountLayers() const
{
  return std::max({ this->LayerOpacityScales.size(), this->LayerColors.size(),
    this->LayerColorFunctions.size() });
}

// Null: those of the volume.
vtkColorTransferFunction* vtkCellCompositingRepresentation::FindLayerColors(std::size_t layer)
{
  if (layer >= this->LayerColors.size() || this->LayerColors[layer][0] < 0.0)
  {
    return layer < this->LayerColorFunctions.size() ? this->LayerColorFunctions[layer].Get()
                                                    : nullptr;
  }
  this->LayerConstants.resize(std::max(this->LayerConstants.size(), layer + 1));
  vtkSmartPointer<vtkColorTransferFunction>& constant = this->LayerConstants[layer];
  const std::array<double, 3>& rgb = this->LayerColors[layer];
  double known[3] = { -1.0, -1.0, -1.0 };
  if (constant)
  {
    constant->GetColor(0.0, known);
  }
  if (!std::equal(rgb.begin(), rgb.end(), known)) // else nothing is made again for it
  {
    constant = vtkSmartPointer<vtkColorTransferFunction>::New();
    constant->AddRGBPoint(0.0, rgb[0], rgb[1], rgb[2]);
  }
  return constant;
}

void vtkCellCompositingRepresentation::PrepareLayers()
{
  this->Mapper->SetLayersFromContours(this->Mapper->GetLayerArrayName().empty());
  const std::size_t count = this->CountLayers();
  for (std::size_t i = count; i < this->LayerProperties.size(); ++i)
  {
    this->Mapper->SetLayerProperty(static_cast<int>(i), nullptr);
  }
  this->LayerProperties.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!this->LayerProperties[i])
    {
      this->LayerProperties[i] = vtkSmartPointer<vtkVolumeProperty>::New();
      this->Mapper->SetLayerProperty(static_cast<int>(i), this->LayerProperties[i]);
    }
    const double scale = i < this->LayerOpacityScales.size() ? this->LayerOpacityScales[i] : 1.0;
    Imitate(this->LayerProperties[i], this->Actor->GetProperty(), scale, this->FindLayerColors(i));
  }
}
