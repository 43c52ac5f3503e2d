// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellScene.h"

#include "ClearDistances.h"
#include "ContourSettings.h"
#include "HexahedronNeighbors.h"
#include "OrderIndependence.h"
#include "VisibleGridCells.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <atomic>
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
  const bool formed = this->Form != form;
  this->Form = form;
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
    if (!findHexahedronNeighbors(this->Geometry, this->Neighbors, contoured, progress))
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
  std::vector<TableSource> sources = { { 0, property, propertyMTime(property) } };
  std::vector<vtkVolumeProperty*> properties = { property };
  std::vector<int> layers; // with a table of their own: the first has table 1
  for (const auto& layer : settings.LayerProperties)
  {
    if (settings.LayersAreUsed())
    {
      sources.push_back({ layer.first, layer.second, propertyMTime(layer.second) });
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
  this->ColorIsOne = hasOneColor(this->Transfers[0], 0.0f, geometry.SingleScalar ? 0.0f : 1.0f);
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
    this->Eye = findEyeTetrahedron(this->Geometry, this->Neighbors, eye);
    this->Change(this->EyeVersion);
  }
}

void CellScene::UpdateDrawn()
{
  const Versions& now = this->Current;
  const bool grid = !this->Geometry.Grid.IsEmpty();
  const bool projected = this->CurrentMethod == Method::Projection;
  const bool isMissing = projected && this->Visible.size() < this->Geometry.Tetrahedra.size();
  if (isMissing ||
    this->VisibleVersion < std::max({ now.Geometry, now.Colors, now.Opacities, now.Transfer,
                             now.Contours, now.Polygons }))
  {
    grid                                 ? this->FindVisibleOfGrid()
      : this->Geometry.Hexahedra.empty() ? this->FindVisible()
                                         : this->FindVisibleHexahedra();
    this->Change(this->VisibleVersion);
  }
  const std::int64_t sources = std::max({ now.Topology, now.Transfer, projected ? now.Order : 0,
    projected || grid ? this->VisibleVersion : 0 });
  if (now.Drawn < sources) // for rays: where they enter, and what they pass unseen
  {
    if (projected)
    {
      this->ListDrawn();
    }
    this->Change(this->Current.Drawn);
  }
}

void CellScene::ListDrawn()
{
  this->Drawn.clear();
  std::copy_if(this->Order.Tetrahedra.begin(), this->Order.Tetrahedra.end(),
    std::back_inserter(this->Drawn),
    [this](std::int32_t number) { return this->Visible[static_cast<std::size_t>(number)] != 0; });
}

bool CellScene::IsVisible(std::size_t tetrahedron) const
{
  const CellGeometry& geometry = this->Geometry;
  const bool separate = geometry.HasOpacityScalars;
  const bool onCells = separate ? geometry.OpacityOnCells : !geometry.CellScalars.empty();
  const std::vector<float>& values = separate ? geometry.OpacityScalars : geometry.CellScalars;
  const Tetrahedron t = geometry.Tetrahedra[tetrahedron];
  std::array<float, 4> s;
  std::transform(t.begin(), t.end(), s.begin(), [&](std::int32_t p) {
    const std::size_t point = static_cast<std::size_t>(p);
    return onCells ? values[tetrahedron] : separate ? values[point] : geometry.Points[point].Scalar;
  });
  const auto range = std::minmax_element(s.begin(), s.end());
  return !this->IsTransparent(
    tetrahedron, { { t[0], t[1], t[2], t[3] } }, *range.first, *range.second);
}

// Rays need their number only.
void CellScene::FindVisible()
{
  const bool listed = this->CurrentMethod == Method::Projection;
  const std::size_t n = this->Geometry.Tetrahedra.size();
  this->Visible = std::vector<std::uint8_t>(listed ? n : 0);
  std::atomic<std::int64_t> visible(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), [&](vtkIdType begin, vtkIdType end) {
    std::int64_t count = 0;
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      const bool seen = this->IsVisible(i);
      count += seen;
      if (listed)
      {
        this->Visible[i] = seen;
      }
    }
    visible += count;
  });
  this->NumberOfVisible = visible;
}

// Lowest and highest scalar at the vertices, of colour or of a separate opacity.
std::pair<float, float> CellScene::RangeInHexahedron(std::size_t cell, bool ofOpacity) const
{
  const CellGeometry& geometry = this->Geometry;
  const bool onCells = ofOpacity ? geometry.OpacityOnCells : !geometry.CellScalars.empty();
  const std::vector<float>& values = ofOpacity ? geometry.OpacityScalars : geometry.CellScalars;
  const Hexahedron& vertices = geometry.Hexahedra[cell];
  std::array<float, 8> s;
  std::transform(vertices.begin(), vertices.end(), s.begin(), [&](std::int32_t p) {
    const auto point = static_cast<std::size_t>(p);
    return onCells ? values[cell] : ofOpacity ? values[point] : geometry.Points[point].Scalar;
  });
  const auto range = std::minmax_element(s.begin(), s.end());
  return { *range.first, *range.second };
}

void CellScene::FindVisibleHexahedra()
{
  const CellGeometry& geometry = this->Geometry;
  const std::size_t n = geometry.Hexahedra.size();
  std::atomic<std::int64_t> visible(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), [&](vtkIdType begin, vtkIdType end) {
    std::int64_t count = 0;
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      if (geometry.DividesHexahedra)
      {
        count += this->CountVisibleParts(i);
        continue;
      }
      const std::pair<float, float> seen = this->RangeInHexahedron(i, geometry.HasOpacityScalars),
                                    colored = this->RangeInHexahedron(i, false);
      count += !this->Opacities[0].IsTransparent(seen.first, seen.second) ||
        this->Contours.DrawsBetween(colored.first, colored.second);
    }
    visible += count;
  });
  // A hexahedron with a field of its own counts as many tetrahedra as hexahedra are divided into on average.
  this->NumberOfVisible = geometry.DividesHexahedra || n == 0
    ? visible.load()
    : visible * geometry.TetrahedraOfHexahedra / static_cast<std::int64_t>(n);
}

// Visible tetrahedra of a divided hexahedron.
int CellScene::CountVisibleParts(std::size_t cell) const
{
  const CellGeometry& geometry = this->Geometry;
  const bool separate = geometry.HasOpacityScalars;
  const bool onCells = separate ? geometry.OpacityOnCells : !geometry.CellScalars.empty();
  const std::vector<float>& values = separate ? geometry.OpacityScalars : geometry.CellScalars;
  const auto valueAt = [&](std::int64_t p) {
    const auto point = static_cast<std::size_t>(p);
    return onCells ? values[cell] : separate ? values[point] : geometry.Points[point].Scalar;
  };
  int count = 0;
  for (int part = 0; part < geometry.TetrahedraPerHexahedron(); ++part)
  {
    const auto vertices = geometry.PointNumbers(
      static_cast<std::int64_t>(cell) * geometry.TetrahedraPerHexahedron() + part);
    std::array<float, 4> s;
    std::transform(vertices.begin(), vertices.end(), s.begin(), valueAt);
    const auto range = std::minmax_element(s.begin(), s.end());
    count += !this->IsTransparent(cell, vertices, *range.first, *range.second);
  }
  return count;
}

void CellScene::FindVisibleOfGrid()
{
  const auto isTransparent = [this](std::size_t cell, const VertexNumbersOf& vertices, float low,
                               float high) {
    return this->IsTransparent(cell, vertices, low, high);
  };
  this->ClearDistances.assign(this->Geometry.Lattice.Found
      ? static_cast<std::size_t>(this->Geometry.Grid.NumberOfCells())
      : 0,
    0);
  const auto visible = VisibleGridCells<decltype(isTransparent)>(this->Geometry, isTransparent)
                         .Find(this->ClearDistances);
  if (this->Geometry.Lattice.Found)
  {
    this->ClearDistances = clearDistances(this->Geometry.Grid, this->ClearDistances);
  }
  this->NumberOfVisible = visible.Tetrahedra;
  this->VisibleBox = visible.Tetrahedra > 0 ? visible.Box : CellBox();
  this->GridBoundary = chessboardBoundary(this->Geometry, this->VisibleBox);
}

// `number` is that of a tetrahedron, or of a cell of a grid.
std::pair<float, float> CellScene::ContourRange(
  std::size_t number, const VertexNumbersOf& vertices) const
{
  std::array<float, 4> s;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const std::size_t point = static_cast<std::size_t>(vertices[k]);
    s[k] = !this->Contours.OfColor         ? this->Contours.Scalars[point]
      : this->Geometry.CellScalars.empty() ? this->Geometry.Points[point].Scalar
                                           : this->Geometry.CellScalars[number];
    if (std::isnan(s[k])) // as the shader has it
    {
      return { 0.0f, 0.0f };
    }
  }
  const auto range = std::minmax_element(s.begin(), s.end());
  return { *range.first, *range.second };
}

// No surface, within or in a face, and for the scalars from low to high no opacity in any of the layers that the tetrahedron may touch.
bool CellScene::IsTransparent(
  std::size_t number, const VertexNumbersOf& vertices, float low, float high) const
{
  const bool contoured = this->Contours.IsUsed();
  const std::pair<float, float> range =
    contoured ? this->ContourRange(number, vertices) : std::pair<float, float>();
  if (this->Polygons.HasSurface(number) ||
    (contoured && this->Contours.DrawsBetween(range.first, range.second)))
  {
    return false;
  }
  if (!contoured || !this->LayersOfContours)
  {
    const std::size_t table = this->TablesOfTetrahedra.empty()
      ? 0
      : static_cast<std::size_t>(this->TablesOfTetrahedra[number]);
    return this->Opacities[table].IsTransparent(low, high);
  }
  const auto& contours = this->Contours.Contours;
  for (std::size_t layer = this->Contours.FindLayer(range.first);
       layer <= this->Contours.FindLayer(range.second); ++layer)
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
