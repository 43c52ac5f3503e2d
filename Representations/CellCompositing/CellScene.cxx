// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellScene.h"

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

bool CellScene::UpdateGeometry(vtkDataSet* data, const ScalarSelection& scalars, std::string& error)
{
  if (!changes(this->GeometryKey,
        { data, data->GetMTime(), scalars.Array, scalars.Array->GetMTime(), scalars.OnCells,
          scalars.Component }))
  {
    return false;
  }
  error = this->Geometry.Build(data, scalars);
  this->Order.Clear();
  ++this->Current.Geometry;
  return true;
}

void CellScene::UpdateTransferFunction(vtkVolumeProperty* property)
{
  if (changes(this->TransferKey, { property, propertyMTime(property), this->Current.Geometry }))
  {
    this->Transfer.Build(property, this->Geometry.ScalarRange);
    ++this->Current.Transfer;
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

void CellScene::UpdateDrawn()
{
  if (changes(this->VisibleKey, { this->Current.Geometry, this->Current.Transfer }))
  {
    this->FindVisible();
  }
  else if (!changes(this->DrawnKey, { this->Current.Order, this->Current.Transfer }))
  {
    return;
  }
  this->DrawnKey = { this->Current.Order, this->Current.Transfer };
  this->Drawn.clear();
  std::copy_if(this->Sorted.begin(), this->Sorted.end(), std::back_inserter(this->Drawn),
    [this](std::int32_t i) { return this->Visible[static_cast<std::size_t>(i)] != 0; });
  ++this->Current.Drawn;
}

void CellScene::FindVisible()
{
  const CellGeometry& geometry = this->Geometry;
  this->Visible.resize(geometry.Tetrahedra.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Visible.size()), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      float low, high;
      if (geometry.CellScalars.empty())
      {
        std::array<float, 4> s;
        std::transform(geometry.Tetrahedra[i].begin(), geometry.Tetrahedra[i].end(), s.begin(),
          [&](std::int32_t p) { return geometry.Points[static_cast<std::size_t>(p)].Scalar; });
        low = *std::min_element(s.begin(), s.end());
        high = *std::max_element(s.begin(), s.end());
      }
      else
      {
        low = high = geometry.CellScalars[i];
      }
      this->Visible[i] = !this->Transfer.IsTransparent(low, high);
    }
  });
}

} // namespace nephoscope
