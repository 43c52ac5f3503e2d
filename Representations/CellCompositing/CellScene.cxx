// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellScene.h"

#include "ContourSettings.h"
#include "VisibleGridCells.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
vtkMTimeType propertyMTime(vtkVolumeProperty* property)
{
  vtkMTimeType time = std::max(property->GetMTime(), property->GetScalarOpacity()->GetMTime());
  return property->GetColorChannels() == 3
    ? std::max(time, property->GetRGBTransferFunction()->GetMTime())
    : std::max(time, property->GetGrayTransferFunction()->GetMTime());
}

/** Replaces `key`; true when it was different. */
template <typename Key>
bool changes(Key& key, const Key& now)
{
  const bool changed = key != now;
  key = now;
  return changed;
}
}

void CellScene::Clear()
{
  this->Geometry.Clear();
  this->Sorted.clear();
  this->Drawn.clear();
  this->NumberOfCycles = 0;
  this->GeometryKey = {};
  ++this->Current.Geometry;
  ++this->Current.Drawn;
}

CellScene::SelectionKey CellScene::MakeKey(const ScalarSelection& selection)
{
  return { selection.Array, selection.Array ? selection.Array->GetMTime() : 0, selection.OnCells,
    selection.Component };
}

bool CellScene::UpdateGeometry(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity, Method method, std::string& error,
  vtkDataArray* layers)
{
  if (!changes(this->GeometryKey,
        { data, data->GetMTime(), MakeKey(scalars), MakeKey(opacity), MakeKey({ layers, true, 0 }), method }))
  {
    return false;
  }
  this->CurrentMethod = method;
  const bool rays = method == Method::Rays;
  error = this->Geometry.Build(
    data, scalars, opacity, layers, rays ? CellGeometry::Form::Grid : CellGeometry::Form::Tetrahedra);
  this->Order.Clear();
  this->Neighbors.Clear();
  if (rays && this->Geometry.Grid.IsEmpty())
  {
    this->Order.Connect(this->Geometry);
    this->Neighbors.Build(this->Geometry, this->Order);
    this->Order.Clear();
  }
  ++this->Current.Geometry;
  return true;
}

void CellScene::UpdateTransferFunction(vtkVolumeProperty* property)
{
  this->UpdateTransferFunction(property, ContourSettings(), nullptr, {});
}

void CellScene::UpdateTransferFunction(vtkVolumeProperty* property, const ContourSettings& settings, vtkDataSet* data,
  const ScalarSelection& contoured)
{
  std::vector<PropertyKey> key = { { 0, property, propertyMTime(property) } };
  std::vector<vtkVolumeProperty*> properties = { property };
  std::vector<int> layers; // with a table of their own: the first has table 1
  this->LayersOfContours = settings.ContoursMakeLayers();
  for (const auto& layer : settings.LayerProperties)
  {
    if (settings.LayersAreUsed())
    {
      key.emplace_back(layer.first, layer.second, propertyMTime(layer.second));
      properties.push_back(layer.second);
      layers.push_back(layer.first);
    }
  }
  if (changes(this->TransferKey, { this->Current.Geometry, this->LayersOfContours, key }))
  {
    this->BuildTables(properties);
    this->FindTablesOfTetrahedra(layers);
    ++this->Current.Transfer;
  }
  std::vector<int> tables(this->LayersOfContours ? settings.Surfaces.size() + 1 : 0, 0);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    if (layers[i] >= 0 && static_cast<std::size_t>(layers[i]) < tables.size())
    {
      tables[static_cast<std::size_t>(layers[i])] = static_cast<int>(i) + 1;
    }
  }
  this->Contours.Update(this->Geometry, this->Current.Geometry, data, contoured, settings, property, tables);
}

void CellScene::BuildTables(const std::vector<vtkVolumeProperty*>& properties)
{
  using Channels = TransferFunctionTable::Channels;
  const bool separate = this->Geometry.HasOpacityScalars;
  this->Transfers.assign(properties.size(), TransferFunctionTable());
  this->Opacities.assign(properties.size(), TransferFunctionTable());
  for (std::size_t i = 0; i < properties.size(); ++i)
  {
    this->Transfers[i].Build(
      properties[i], this->Geometry.ScalarRange, separate ? Channels::Color : Channels::ColorAndOpacity);
    this->Opacities[i].Build(
      properties[i], separate ? this->Geometry.OpacityRange : this->Geometry.ScalarRange, Channels::Opacity);
    if (i > 0)
    {
      const double factor = properties[0]->GetScalarOpacityUnitDistance() / properties[i]->GetScalarOpacityUnitDistance();
      this->Transfers[i].ScaleOpacity(factor);
      this->Opacities[i].ScaleOpacity(factor);
    }
  }
}

void CellScene::FindTablesOfTetrahedra(const std::vector<int>& layers)
{
  this->TablesOfTetrahedra.clear();
  if (layers.empty() || this->LayersOfContours)
  {
    return;
  }
  for (const std::int32_t layer : this->Geometry.Layers)
  {
    const auto found = std::lower_bound(layers.begin(), layers.end(), layer);
    const bool known = found != layers.end() && *found == layer;
    this->TablesOfTetrahedra.push_back(known ? static_cast<std::int32_t>(found - layers.begin()) + 1 : 0);
  }
}

void CellScene::UpdateOrder(const Vector4& eye, OrderMethod method)
{
  if (!changes(this->OrderKey, { this->Current.Geometry, method, eye }))
  {
    return;
  }
  this->NumberOfCycles = 0;
  switch (method)
  {
    case OrderMethod::Exact:
      if (!this->Order.IsConnected())
      {
        this->Order.Connect(this->Geometry);
      }
      this->NumberOfCycles = this->Order.SortExact(this->Geometry, eye, this->Sorted);
      break;
    case OrderMethod::Centroid:
      VisibilityOrder::SortCentroids(this->Geometry, eye, this->Sorted);
      break;
    case OrderMethod::None:
      VisibilityOrder::SortNone(this->Geometry, this->Sorted);
      break;
  }
  ++this->Current.Order;
}

void CellScene::UpdateEye(const Vector4& eye)
{
  if (changes(this->EyeKey, { this->Current.Geometry, eye }))
  {
    this->Eye = findEyeTetrahedron(this->Geometry, this->Neighbors, eye);
  }
}

void CellScene::UpdateDrawn()
{
  if (changes(this->VisibleKey, { this->Current.Geometry, this->Current.Transfer, this->Contours.Version }))
  {
    this->Geometry.Grid.IsEmpty() ? this->FindVisible() : this->FindVisibleOfGrid();
  }
  else if (!changes(this->DrawnKey, { this->Current.Order, this->Current.Transfer, this->Contours.Version }))
  {
    return;
  }
  this->DrawnKey = { this->Current.Order, this->Current.Transfer, this->Contours.Version };
  this->Drawn.clear();
  if (this->CurrentMethod == Method::Projection)
  {
    std::copy_if(this->Sorted.begin(), this->Sorted.end(), std::back_inserter(this->Drawn),
      [this](std::int32_t i) { return this->Visible[static_cast<std::size_t>(i)] != 0; });
  }
  ++this->Current.Drawn;
}

void CellScene::FindVisible()
{
  const CellGeometry& geometry = this->Geometry;
  const bool separate = geometry.HasOpacityScalars;
  const bool onCells = separate ? geometry.OpacityOnCells : !geometry.CellScalars.empty();
  const std::vector<float>& cellValues = separate ? geometry.OpacityScalars : geometry.CellScalars;
  const auto pointValue = [&](std::int32_t point) {
    const std::size_t i = static_cast<std::size_t>(point);
    return separate ? geometry.OpacityScalars[i] : geometry.Points[i].Scalar;
  };
  this->Visible.resize(geometry.Tetrahedra.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Visible.size()), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      std::array<float, 4> s;
      for (std::size_t k = 0; k < 4; ++k)
      {
        s[k] = onCells ? cellValues[i] : pointValue(geometry.Tetrahedra[i][k]);
      }
      const auto range = std::minmax_element(s.begin(), s.end());
      this->Visible[i] = !this->IsTransparent(i, *range.first, *range.second);
    }
  });
  this->NumberOfVisible = std::count(this->Visible.begin(), this->Visible.end(), std::uint8_t(1));
}

void CellScene::FindVisibleOfGrid()
{
  const VisibleGridCells::Result visible = VisibleGridCells(this->Geometry, this->Opacities[0]).Find();
  this->NumberOfVisible = visible.Tetrahedra;
  this->VisibleBox = visible.Tetrahedra > 0 ? visible.Box : CellBox();
  this->GridBoundary = chessboardBoundary(this->Geometry, this->VisibleBox);
}

std::pair<float, float> CellScene::ContourRange(std::size_t tetrahedron) const
{
  std::array<float, 4> s;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const std::size_t point = static_cast<std::size_t>(this->Geometry.Tetrahedra[tetrahedron][k]);
    s[k] = !this->Contours.OfColor          ? this->Contours.Scalars[point]
      : this->Geometry.CellScalars.empty() ? this->Geometry.Points[point].Scalar
                                           : this->Geometry.CellScalars[tetrahedron];
    if (std::isnan(s[k])) // as the shader has it
    {
      return { 0.0f, 0.0f };
    }
  }
  const auto range = std::minmax_element(s.begin(), s.end());
  return { *range.first, *range.second };
}

// No surface, and for the scalars from low to high no opacity in any of the layers that the tetrahedron may touch.
bool CellScene::IsTransparent(std::size_t tetrahedron, float low, float high) const
{
  const bool contoured = this->Contours.IsUsed();
  const std::pair<float, float> range = contoured ? this->ContourRange(tetrahedron) : std::pair<float, float>();
  if (contoured && this->Contours.DrawsBetween(range.first, range.second))
  {
    return false;
  }
  if (!contoured || !this->LayersOfContours)
  {
    const std::size_t table =
      this->TablesOfTetrahedra.empty() ? 0 : static_cast<std::size_t>(this->TablesOfTetrahedra[tetrahedron]);
    return this->Opacities[table].IsTransparent(low, high);
  }
  const auto& contours = this->Contours.Contours;
  for (std::size_t layer = this->Contours.FindLayer(range.first); layer <= this->Contours.FindLayer(range.second); ++layer)
  {
    const float table = layer == 0 ? contours[0].LayerBelow : contours[layer - 1].LayerAbove;
    if (!this->Opacities[static_cast<std::size_t>(table)].IsTransparent(low, high))
    {
      return false;
    }
  }
  return true;
}

} // namespace nephoscope
