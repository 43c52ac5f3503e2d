// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellScene.h"

#include "VisibleGridCells.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

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
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity, Method method, std::string& error)
{
  if (!changes(this->GeometryKey, { data, data->GetMTime(), MakeKey(scalars), MakeKey(opacity), method }))
  {
    return false;
  }
  this->CurrentMethod = method;
  const bool rays = method == Method::Rays;
  error = this->Geometry.Build(
    data, scalars, opacity, rays ? CellGeometry::Form::Grid : CellGeometry::Form::Tetrahedra);
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
  using Channels = TransferFunctionTable::Channels;
  if (!changes(this->TransferKey, { property, propertyMTime(property), this->Current.Geometry }))
  {
    return;
  }
  const bool separate = this->Geometry.HasOpacityScalars;
  this->Transfer.Build(
    property, this->Geometry.ScalarRange, separate ? Channels::Color : Channels::ColorAndOpacity);
  this->Opacity.Build(
    property, separate ? this->Geometry.OpacityRange : this->Geometry.ScalarRange, Channels::Opacity);
  ++this->Current.Transfer;
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
  if (changes(this->VisibleKey, { this->Current.Geometry, this->Current.Transfer }))
  {
    this->Geometry.Grid.IsEmpty() ? this->FindVisible() : this->FindVisibleOfGrid();
  }
  else if (!changes(this->DrawnKey, { this->Current.Order, this->Current.Transfer }))
  {
    return;
  }
  this->DrawnKey = { this->Current.Order, this->Current.Transfer };
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
      this->Visible[i] = !this->Opacity.IsTransparent(*range.first, *range.second);
    }
  });
  this->NumberOfVisible = std::count(this->Visible.begin(), this->Visible.end(), std::uint8_t(1));
}

void CellScene::FindVisibleOfGrid()
{
  const VisibleGridCells::Result visible = VisibleGridCells(this->Geometry, this->Opacity).Find();
  this->NumberOfVisible = visible.Tetrahedra;
  this->VisibleBox = visible.Tetrahedra > 0 ? visible.Box : CellBox();
  this->GridBoundary = chessboardBoundary(this->Geometry, this->VisibleBox);
}

} // namespace nephoscope
