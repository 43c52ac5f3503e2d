// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells that can be seen: those that the transfer function and the surfaces in them do not
// leave clear.
#include "CellScene.h"

#include "ClearDistances.h"
#include "VisibleGridCells.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace nephoscope
{

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
    this->ClearDistances.clear();
    grid                                 ? this->FindVisibleOfGrid()
      : this->Geometry.Hexahedra.empty() ? this->FindVisible()
                                         : this->FindVisibleHexahedra();
    this->Change(this->VisibleVersion);
  }
  const std::int64_t sources = std::max({ now.Topology, now.Transfer, projected ? now.Order : 0,
    projected || !this->ClearDistances.empty() ? this->VisibleVersion : 0 });
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

// The cell is a hexahedron with a field of its own.
bool CellScene::IsClearHexahedron(std::size_t cell) const
{
  const CellGeometry& geometry = this->Geometry;
  const bool separate = geometry.HasOpacityScalars;
  const bool onCells = separate ? geometry.OpacityOnCells : !geometry.CellScalars.empty();
  const std::vector<float>& values = separate ? geometry.OpacityScalars : geometry.CellScalars;
  const auto rangeOf = [&](const auto& valueAt) {
    std::array<float, 8> s;
    const Hexahedron& vertices = geometry.Hexahedra[cell];
    std::transform(vertices.begin(), vertices.end(), s.begin(),
      [&](std::int32_t p) { return valueAt(static_cast<std::size_t>(p)); });
    const auto range = std::minmax_element(s.begin(), s.end());
    return std::make_pair(*range.first, *range.second);
  };
  const auto seen = rangeOf([&](std::size_t point) {
    return onCells ? values[cell] : separate ? values[point] : geometry.Points[point].Scalar;
  });
  if (!this->Opacities[0].IsTransparent(seen.first, seen.second))
  {
    return false;
  }
  if (!this->Contours.IsUsed())
  {
    return true;
  }
  const auto contoured = rangeOf([&](std::size_t point) {
    return !this->Contours.OfColor   ? this->Contours.Scalars[point]
      : geometry.CellScalars.empty() ? geometry.Points[point].Scalar
                                     : geometry.CellScalars[cell];
  });
  return !this->Contours.DrawsBetween(contoured.first, contoured.second);
}

void CellScene::FindVisibleHexahedra()
{
  const CellGeometry& geometry = this->Geometry;
  const std::size_t n = geometry.Hexahedra.size();
  this->ClearDistances.assign(geometry.DividesHexahedra ? 0 : n, 0);
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
      const bool clear = this->IsClearHexahedron(i);
      this->ClearDistances[i] = clear;
      count += !clear;
    }
    visible += count;
  });
  // A hexahedron with a field of its own counts as many tetrahedra as hexahedra are divided into on
  // average.
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
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(this->Geometry.Grid.NumberOfCells()), 0);
  const auto visible =
    VisibleGridCells<decltype(isTransparent)>(this->Geometry, isTransparent).Find(marks);
  if (this->Geometry.Lattice.Found)
  {
    marks = FindClearDistances(this->Geometry.Grid, marks);
  }
  else
  {
    std::transform(marks.begin(), marks.end(), marks.begin(),
      [](std::uint8_t mark) { return std::uint8_t(1 - mark); });
  }
  this->ClearDistances = std::move(marks);
  this->NumberOfVisible = visible.Tetrahedra;
  this->VisibleBox = visible.Tetrahedra > 0 ? visible.Box : CellBox();
  this->GridBoundary = ChessboardBoundary(this->Geometry, this->VisibleBox);
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

// No surface, within or in a face, and for the scalars from low to high no opacity in any of the
// layers that the tetrahedron may touch.
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
