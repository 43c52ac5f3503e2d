// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourScene.h"

#include "ContourSettings.h"
#include "PointGradients.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
std::vector<float> ColorScalars(const CellGeometry& geometry)
{
  std::vector<float> scalars;
  scalars.reserve(geometry.Points.size());
  for (const CellGeometry::Point& p : geometry.Points)
  {
    scalars.push_back(p.Scalar);
  }
  return scalars;
}

// Where other ranks have some of the cells.
std::vector<std::array<float, 4>> StoredGradients(vtkDataArray* array)
{
  std::vector<std::array<float, 4>> gradients(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < gradients.size(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      gradients[i][c] =
        static_cast<float>(array->GetComponent(static_cast<vtkIdType>(i), static_cast<int>(c)));
    }
  }
  return gradients;
}
}

vtkMTimeType ColorMTime(vtkVolumeProperty* property)
{
  return property->GetColorChannels() == 3 ? property->GetRGBTransferFunction()->GetMTime()
                                           : property->GetGrayTransferFunction()->GetMTime();
}

std::array<float, 3> FunctionColor(vtkVolumeProperty* property, double value)
{
  double rgb[3];
  if (property->GetColorChannels() == 3)
  {
    property->GetRGBTransferFunction()->GetColor(value, rgb);
  }
  else
  {
    rgb[0] = rgb[1] = rgb[2] = property->GetGrayTransferFunction()->GetValue(value);
  }
  return { { static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]) } };
}

bool ContourScene::Sources::operator==(const Sources& other) const
{
  return this->Field == other.Field && this->Surfaces == other.Surfaces &&
    this->Tables == other.Tables && this->Property == other.Property &&
    this->Changed == other.Changed;
}

bool ContourScene::FieldSources::operator==(const FieldSources& other) const
{
  return this->Geometry == other.Geometry && this->OfColor == other.OfColor &&
    this->Smooth == other.Smooth && this->Array == other.Array && this->Changed == other.Changed;
}

void ContourScene::Update(const CellGeometry& geometry, std::int64_t geometryVersion,
  vtkDataSet* data, const ScalarSelection& selection, const ContourSettings& settings,
  vtkVolumeProperty* property, const std::vector<int>& tables)
{
  std::vector<ContourSettings::Surface> surfaces;
  std::copy_if(settings.Surfaces.begin(), settings.Surfaces.end(), std::back_inserter(surfaces),
    [](const ContourSettings::Surface& s) { return std::isfinite(s.Value); });
  std::stable_sort(surfaces.begin(), surfaces.end(),
    [](const auto& a, const auto& b) { return a.Value < b.Value; });
  const bool drawn =
    std::any_of(surfaces.begin(), surfaces.end(), [](const auto& s) { return s.Opacity > 0; });
  if (!surfaces.empty())
  {
    const bool onPoints = selection.Array || geometry.CellScalars.empty();
    this->UpdateField(geometry, geometryVersion, data, selection,
      settings.SmoothNormals && settings.Lighting && drawn && onPoints);
  }

  Sources sources = { this->FieldVersion, {}, tables, property,
    std::max(property->GetMTime(), ColorMTime(property)) };
  for (const auto& s : surfaces)
  {
    sources.Surfaces.insert(
      sources.Surfaces.end(), { s.Value, s.Opacity, s.Color[0], s.Color[1], s.Color[2] });
  }
  if (sources == this->Made)
  {
    return;
  }
  this->Made = sources;
  ++this->Version;
  this->Contours.clear();
  this->Drawn.clear();
  for (std::size_t k = 0; k < surfaces.size(); ++k)
  {
    const auto& s = surfaces[k];
    Contour contour = {};
    contour.Value = static_cast<float>(NormalizedValue(s.Value, this->Range));
    contour.LayerBelow = tables.empty() ? 0.0f : static_cast<float>(tables[k]);
    contour.LayerAbove = tables.empty() ? 0.0f : static_cast<float>(tables[k + 1]);
    std::array<float, 3> rgb = { { -1, -1, -1 } };
    if (s.Color[0] >= 0)
    {
      std::copy(s.Color.begin(), s.Color.end(), rgb.begin());
    }
    else if (this->OfColor)
    {
      rgb = FunctionColor(property, s.Value);
    }
    contour.Color = { { rgb[0], rgb[1], rgb[2], static_cast<float>(s.Opacity) } };
    this->Contours.push_back(contour);
    if (s.Opacity > 0)
    {
      this->Drawn.push_back(contour.Value);
    }
  }
}

void ContourScene::UpdateField(const CellGeometry& geometry, std::int64_t geometryVersion,
  vtkDataSet* data, const ScalarSelection& selection, bool smooth)
{
  const bool ofColor = selection.Array == nullptr;
  const FieldSources sources = { geometryVersion, ofColor, smooth, selection.Array,
    ofColor ? 0 : selection.Array->GetMTime() };
  if (sources == this->MadeField)
  {
    return;
  }
  this->MadeField = sources;
  ++this->FieldVersion;
  this->OfColor = ofColor;
  this->Smooth = smooth;
  std::copy(geometry.ScalarRange, geometry.ScalarRange + 2, this->Range);
  bool single = geometry.SingleScalar;
  this->Scalars.clear();
  if (!ofColor)
  {
    FindRange(data, selection, this->Range, {}, &single);
    this->Scalars = NormalizedScalars(selection, this->Range);
  }
  this->Greatest = single ? this->Range[0] : this->Range[1];
  this->Gradients.clear();
  if (smooth)
  {
    vtkDataArray* stored = data->GetPointData()->GetArray(storedGradientsName);
    this->Gradients = stored
      ? StoredGradients(stored)
      : PointGradients(data, geometry, ofColor ? ColorScalars(geometry) : this->Scalars);
  }
}

bool ContourScene::DrawsBetween(float low, float high) const
{
  const auto above =
    std::upper_bound(this->Drawn.begin(), this->Drawn.end(), low); // the first value > low
  return above != this->Drawn.end() && *above <= high;
}

bool ContourScene::ClosesWith(const CellGeometry& geometry) const
{
  const ChessboardGrid& grid = geometry.Grid;
  if (grid.WrapCells == 0 || this->OfColor || this->Contours.empty())
  {
    return true;
  }
  for (std::size_t first = 0; first < this->Scalars.size();
       first += static_cast<std::size_t>(grid.Size[0]))
  {
    const float a = this->Scalars[first],
                b = this->Scalars[first + static_cast<std::size_t>(grid.WrapCells)];
    if (a != b && !(std::isnan(a) && std::isnan(b)))
    {
      return false;
    }
  }
  return true;
}

std::size_t ContourScene::FindLayer(float s) const
{
  const auto above = std::upper_bound(this->Contours.begin(), this->Contours.end(), s,
    [](float v, const Contour& c) { return v < c.Value; });
  return static_cast<std::size_t>(above - this->Contours.begin());
}

} // namespace nephoscope
