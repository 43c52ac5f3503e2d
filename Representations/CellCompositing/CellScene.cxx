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
  this->Order.Clear();
  this->Neighbors.Clear();
  this->Sorted = {};
  this->Drawn.clear();
  this->NumberOfVisible = 0;
  this->Counted = {};
  this->GeometryKey = {};
  ++this->Current.Geometry;
  ++this->Current.Drawn;
}

CellScene::SelectionKey CellScene::MakeKey(const ScalarSelection& selection)
{
  return { selection.Array, selection.Array ? selection.Array->GetMTime() : 0, selection.OnCells,
    selection.Component };
}

bool CellScene::UpdateGeometry(vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity,
  Method method, std::string& error, const Progress& progress)
{
  if (!changes(this->GeometryKey, { data, data->GetMTime(), MakeKey(scalars), MakeKey(opacity), method }))
  {
    return false;
  }
  this->CurrentMethod = method;
  const bool rays = method == Method::Rays;
  error = this->Geometry.Build(
    data, scalars, opacity, progress.Part(0, rays ? 0.5 : 1), rays ? CellGeometry::Form::Grid : CellGeometry::Form::Tetrahedra);
  this->Order.Clear();
  this->Neighbors.Clear();
  const bool connect = rays && this->Geometry.Grid.IsEmpty();
  if (this->Geometry.Stopped || (connect && !this->Order.Connect(this->Geometry, progress.Part(0.5, 1))))
  {
    this->Clear();
    return false;
  }
  if (connect)
  {
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

bool CellScene::UpdateOrder(OrderMethod method, const Progress& progress)
{
  const bool connect = method == OrderMethod::Exact && !this->Order.IsConnected();
  if (connect && !this->Order.Connect(this->Geometry, progress.Part(0, 0.5)))
  {
    return false;
  }
  if (!changes(this->OrderKey, this->KeyOf(method)))
  {
    return true;
  }
  const bool hadPieces = !this->Sorted.Pieces.Tetrahedra.empty();
  const bool done = this->Sort(method, this->Sorted, progress.Part(connect ? 0.5 : 0, 1));
  this->Current.Pieces += hadPieces || !this->Sorted.Pieces.Tetrahedra.empty();
  if (!done)
  {
    this->OrderKey = {};
    return false;
  }
  ++this->Current.Order;
  return true;
}

bool CellScene::Sort(OrderMethod method, VisibilityOrder::Sorted& sorted, const Progress& progress)
{
  if (method == OrderMethod::Exact)
  {
    const bool done = this->Order.SortExact(this->Geometry, this->View, sorted, progress);
    this->Count(sorted);
    this->CountedKey = done ? this->KeyOf(method) : SortKey();
    return done;
  }
  sorted = {};
  if (method == OrderMethod::Centroid)
  {
    return VisibilityOrder::SortCentroids(this->Geometry, this->View.Eye, sorted.Order, progress);
  }
  VisibilityOrder::SortNone(this->Geometry, sorted.Order);
  return true;
}

// Only where a ray can enter the mesh twice does the order depend on the pixels.
CellScene::SortKey CellScene::KeyOf(OrderMethod method) const
{
  OrderView view = this->View;
  if (method != OrderMethod::Exact || this->Order.GetFaces().IsConvex())
  {
    view.ModelToDevice = {};
    view.Width = view.Height = 0;
  }
  return { this->Current.Geometry, method, view };
}

void CellScene::Count(const VisibilityOrder::Sorted& sorted)
{
  this->Counted = { sorted.NumberOfCycles, sorted.NumberOfCyclicTetrahedra, sorted.NumberOfBrokenRelations };
}

CellScene::Cycles CellScene::CountCycles(const std::function<CellGeometry()>& makeTetrahedra)
{
  const bool rays = this->CurrentMethod == Method::Rays;
  if (!rays && !this->Order.IsConnected())
  {
    this->Order.Connect(this->Geometry);
  }
  if (this->CountedKey != this->KeyOf(OrderMethod::Exact))
  {
    const bool grid = !this->Geometry.Grid.IsEmpty();
    const CellGeometry made = grid ? makeTetrahedra() : CellGeometry();
    const CellGeometry& geometry = grid ? made : this->Geometry;
    VisibilityOrder connected;
    if (rays) // which keep no order
    {
      connected.Connect(geometry);
    }
    VisibilityOrder::Sorted sorted;
    (rays ? connected : this->Order).SortExact(geometry, this->View, sorted);
    this->Count(sorted);
    this->CountedKey = this->KeyOf(OrderMethod::Exact);
  }
  return this->Counted;
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
    const std::size_t whole = this->Geometry.Tetrahedra.size();
    std::copy_if(this->Sorted.Order.begin(), this->Sorted.Order.end(), std::back_inserter(this->Drawn),
      [this, whole](std::int32_t number) {
        const std::size_t i = static_cast<std::size_t>(number);
        const std::size_t owner = i < whole ? i : static_cast<std::size_t>(this->Sorted.Pieces.Owners[i - whole]);
        return this->Visible[owner] != 0;
      });
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
