// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellScene.h"

#include "ContourSettings.h"
#include "HexahedronNeighbors.h"
#include "OrderIndependence.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
vtkMTimeType PropertyMTime(vtkVolumeProperty* property)
{
  vtkMTimeType time = std::max(property->GetMTime(), property->GetScalarOpacity()->GetMTime());
  return property->GetColorChannels() == 3
    ? std::max(time, property->GetRGBTransferFunction()->GetMTime())
    : std::max(time, property->GetGrayTransferFunction()->GetMTime());
}

}

void CellScene::Clear()
{
  this->Geometry.Clear();
  this->Faces = FaceNeighbors();
  this->Neighbors.Clear();
  this->Order = ProjectionOrder();
  this->Drawn.clear();
  this->NumberOfVisible = 0;
  this->Mesh.Forget();
  this->Change(this->Current.Geometry);
  this->Change(this->Current.Drawn);
}

bool CellScene::UpdateGeometry(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, CellGeometry::Form form, std::string& error, vtkDataArray* layers,
  const Progress& progress)
{
  // All are asked, since each remembers what it was asked about.
  const bool mesh = this->Mesh.Changes(data);
  const bool layered = this->LayerValues.Changes(data, { layers, true, 0 });
  const bool formed = !this->Geometry.IsOf(form);
  const bool ofColor = this->ColorValues.Changes(data, scalars);
  const bool ofOpacity = this->OpacityValues.Changes(data, opacity);
  if (!mesh && !layered && !formed && this->Geometry.Tetrahedra.Follow(data) &&
    ((!ofColor && !ofOpacity) || this->UpdateValues(data, scalars, opacity, ofColor, ofOpacity)))
  {
    return false;
  }
  error = this->Geometry.Build(data, scalars, opacity, layers, progress, form);
  this->Faces = FaceNeighbors();
  this->Neighbors.Clear();
  if (this->Geometry.Stopped)
  {
    this->Clear();
    return false;
  }
  this->Change(this->Current.Geometry);
  return true;
}

// False where the geometry has to be built again.
bool CellScene::UpdateValues(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, bool ofColor, bool ofOpacity)
{
  if (!this->Geometry.UpdateValues(data, scalars, opacity, ofColor, ofOpacity))
  {
    return false;
  }
  if (ofColor)
  {
    this->Change(this->Current.Colors);
  }
  if (ofOpacity)
  {
    this->Change(this->Current.Opacities);
  }
  const bool ofPoints = (ofColor && !scalars.OnCells) || (ofOpacity && !opacity.OnCells);
  if (ofPoints && this->Neighbors.DependOnValues)
  {
    this->Current.Topology = 0;
  }
  return true;
}

bool CellScene::UpdateMethod(Method method, const Progress& progress)
{
  const bool ofOther = this->Contours.IsUsed() && !this->Contours.OfColor;
  const std::int64_t field = ofOther ? this->Contours.FieldVersion : 0;
  const std::vector<float> none;
  const std::vector<float>& contoured = ofOther ? this->Contours.Scalars : none;
  if (this->Polygons.IsUsed())
  {
    this->RenewUploaded(); // polygons are found through them
  }
  if (this->Current.Topology > this->Current.Geometry && method == this->CurrentMethod &&
    field == this->FieldOfTopology)
  {
    return true;
  }
  this->CurrentMethod = method;
  this->FieldOfTopology = field;
  this->Current.Topology = 0;
  this->Released = false;
  this->Neighbors.Clear();
  this->Drawn.clear();
  this->Order = ProjectionOrder();
  this->Current.Order = 0;
  if (method == Method::Rays && !this->Geometry.Hexahedra.empty())
  {
    if (!FindHexahedronNeighbors(this->Geometry, this->Neighbors, contoured, progress))
    {
      return false;
    }
  }
  else if (method == Method::Rays && this->Geometry.Grid.IsEmpty())
  {
    if (!this->Faces.IsConnected() && !this->Faces.Connect(this->Geometry, progress))
    {
      return false;
    }
    this->Neighbors.Build(this->Geometry, this->Faces, contoured);
    this->Faces = FaceNeighbors();
  }
  this->Change(this->Current.Topology);
  return true;
}

void CellScene::ReleaseUploaded()
{
  if (this->CurrentMethod == Method::Rays && !this->Polygons.IsUsed())
  {
    this->Neighbors.ReleaseNeighbors();
    std::vector<std::uint8_t>().swap(this->Visible);
    this->Released = true;
  }
}

void CellScene::UpdateTransferFunction(vtkVolumeProperty* property)
{
  this->UpdateTransferFunction(property, ContourSettings(), nullptr, {});
}

void CellScene::UpdateTransferFunction(vtkVolumeProperty* property, const ContourSettings& settings,
  vtkDataSet* data, const ScalarSelection& contoured)
{
  const bool layersOfContours = settings.ContoursMakeLayers();
  const CellGeometry& geometry = this->Geometry;
  const std::array<double, 5> ranges = { { geometry.ScalarRange[0], geometry.ScalarRange[1],
    geometry.OpacityRange[0], geometry.OpacityRange[1], double(geometry.HasOpacityScalars) } };
  std::vector<TableSource> sources = { { 0, property, PropertyMTime(property) } };
  std::vector<vtkVolumeProperty*> properties = { property };
  std::vector<int> layers; // with a table of their own: the first has table 1
  for (const auto& layer : settings.LayerProperties)
  {
    if (settings.LayersAreUsed())
    {
      sources.push_back({ layer.first, layer.second, PropertyMTime(layer.second) });
      properties.push_back(layer.second);
      layers.push_back(layer.first);
    }
  }
  if (this->Current.Transfer < this->Current.Geometry ||
    this->LayersOfContours != layersOfContours || this->TableRanges != ranges ||
    !(this->TableSources == sources))
  {
    this->LayersOfContours = layersOfContours;
    this->TableRanges = ranges;
    this->TableSources = sources;
    this->BuildTables(properties);
    this->FindTablesOfTetrahedra(layers);
    this->Change(this->Current.Transfer);
  }
  this->ColorIsOne = IsOfOneColor(this->Transfers[0], 0.0f, geometry.SingleScalar ? 0.0f : 1.0f);
  std::vector<int> tables(this->LayersOfContours ? settings.Surfaces.size() + 1 : 0, 0);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    if (layers[i] >= 0 && static_cast<std::size_t>(layers[i]) < tables.size())
    {
      tables[static_cast<std::size_t>(layers[i])] = static_cast<int>(i) + 1;
    }
  }
  if (data && this->ContouredValues.Changes(data, contoured))
  {
    this->Change(this->ContouredVersion);
  }
  const std::int64_t before = this->Contours.Version;
  this->Contours.Update(geometry,
    std::max({ this->Current.Geometry, this->Current.Colors, this->ContouredVersion }), data,
    contoured, settings, property, tables);
  if (this->Contours.Version != before)
  {
    this->Change(this->Current.Contours);
  }
  if (!this->Contours.ClosesWith(geometry)) // a boundary as any other
  {
    this->Geometry.Grid.WrapCells = 0;
    this->Change(this->Current.Topology);
    this->VisibleVersion = 0;
  }
}

void CellScene::BuildTables(const std::vector<vtkVolumeProperty*>& properties)
{
  using Channels = TransferFunctionTable::Channels;
  const bool separate = this->Geometry.HasOpacityScalars;
  this->Transfers.assign(properties.size(), TransferFunctionTable());
  this->Opacities.assign(properties.size(), TransferFunctionTable());
  for (std::size_t i = 0; i < properties.size(); ++i)
  {
    this->Transfers[i].Build(properties[i], this->Geometry.ScalarRange,
      separate ? Channels::Color : Channels::ColorAndOpacity);
    this->Opacities[i].Build(properties[i],
      separate ? this->Geometry.OpacityRange : this->Geometry.ScalarRange, Channels::Opacity);
    if (i > 0)
    {
      const double distance = properties[i]->GetScalarOpacityUnitDistance(),
                   ofVolume = properties[0]->GetScalarOpacityUnitDistance();
      const double factor =
        distance == ContourSettings::DefaultUnitDistance ? 1.0 : ofVolume / distance;
      this->Transfers[i].ScaleOpacity(factor);
      this->Opacities[i].ScaleOpacity(factor);
    }
  }
}

double CellScene::GetOpaqueExtinctionScale() const
{
  constexpr double thick = 1e12;
  double greatest = 0;
  for (const TransferFunctionTable& table : this->Opacities)
  {
    greatest = std::max(greatest, double(table.GreatestOpacity()));
  }
  const double depth = greatest * 2 * this->Geometry.Radius();
  return depth > 0 ? thick / depth : thick;
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
    this->TablesOfTetrahedra.push_back(
      known ? static_cast<std::int32_t>(found - layers.begin()) + 1 : 0);
  }
}

bool CellScene::UpdateOrder(
  ProjectionOrder::Kind kind, const Vector4& eye, const Progress& progress)
{
  using Kind = ProjectionOrder::Kind;
  const bool connect = kind == Kind::Topological && !this->Faces.IsConnected();
  if (connect && !this->Faces.Connect(this->Geometry, progress.Part(0, 0.5)))
  {
    return false;
  }
  if (this->Current.Order > this->Current.Geometry && kind == this->OrderKind &&
    (kind == Kind::None || eye == this->EyeOfOrder))
  {
    return true;
  }
  this->OrderKind = kind;
  this->EyeOfOrder = eye;
  this->Current.Order = 0;
  const bool done =
    this->Order.Sort(kind, this->Geometry, this->Faces, eye, progress.Part(connect ? 0.5 : 0, 1));
  if (done)
  {
    this->Change(this->Current.Order);
  }
  return done;
}

void CellScene::UpdateEye(const Vector4& eye)
{
  const Versions& now = this->Current;
  if (eye != this->EyeOfRays ||
    this->EyeVersion < std::max({ now.Geometry, now.Colors, now.Opacities, now.Topology }))
  {
    this->EyeOfRays = eye;
    this->Eye = FindEyeTetrahedron(this->Geometry, this->Neighbors, eye);
    this->Change(this->EyeVersion);
  }
}

} // namespace nephoscope
