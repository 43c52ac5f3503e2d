// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of CellGeometry that keeps structured data as a grid.
#include "CellGeometry.h"

#include "CellWalker.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <cmath>

namespace nephoscope
{
namespace
{
bool IsFinitePlace(const CellGeometry::Point& p)
{
  return std::isfinite(p.X) && std::isfinite(p.Y) && std::isfinite(p.Z);
}

/** Whether any of the values is not finite. */
bool HasInvalid(const std::vector<float>& values)
{
  return !std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}
}

std::int64_t CellGeometry::NumberOfTetrahedra() const
{
  if (!this->Hexahedra.empty())
  {
    return this->TetrahedraOfHexahedra;
  }
  if (this->Grid.IsEmpty())
  {
    return static_cast<std::int64_t>(this->Tetrahedra.size());
  }
  const std::int64_t hidden = std::count_if(
    this->HiddenCells.begin(), this->HiddenCells.end(), [](std::uint8_t h) { return h != 0; });
  return ChessboardGrid::TetrahedraPerCell * (this->Grid.NumberOfCells() - hidden);
}

std::int64_t CellGeometry::CountTetrahedra() const
{
  if (!this->Hexahedra.empty())
  {
    return this->TetrahedraPerHexahedron() * static_cast<std::int64_t>(this->Hexahedra.size());
  }
  return this->Grid.IsEmpty() ? static_cast<std::int64_t>(this->Tetrahedra.size())
                              : ChessboardGrid::TetrahedraPerCell * this->Grid.NumberOfCells();
}

std::array<std::int64_t, 4> CellGeometry::PointNumbers(std::int64_t tetrahedron) const
{
  if (!this->Hexahedra.empty())
  {
    const int perCell = this->TetrahedraPerHexahedron();
    const Hexahedron& h = this->Hexahedra[static_cast<std::size_t>(tetrahedron / perCell)];
    const auto part = this->PartCorners(static_cast<int>(tetrahedron % perCell));
    return { { h[part[0]], h[part[1]], h[part[2]], h[part[3]] } };
  }
  if (this->Grid.IsEmpty())
  {
    const Tetrahedron& t = this->Tetrahedra[static_cast<std::size_t>(tetrahedron)];
    return { { t[0], t[1], t[2], t[3] } };
  }
  constexpr int perCell = ChessboardGrid::TetrahedraPerCell;
  return this->Grid.Tetrahedra(
    tetrahedron / perCell)[static_cast<std::size_t>(tetrahedron % perCell)];
}

bool CellGeometry::IsHidden(std::int64_t tetrahedron) const
{
  return !this->HiddenCells.empty() &&
    this->HiddenCells[static_cast<std::size_t>(tetrahedron / ChessboardGrid::TetrahedraPerCell)] !=
    0;
}

double CellGeometry::Radius() const
{
  double largest = 0;
  for (const Point& p : this->Points)
  {
    const double squared = double(p.X) * p.X + double(p.Y) * p.Y + double(p.Z) * p.Z;
    largest = std::isfinite(squared) ? std::max(largest, squared) : largest;
  }
  return std::sqrt(largest);
}

// A walk needs to know where every point is; values may be missing.
bool CellGeometry::UseGrid(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  this->Grid = FindChessboardGrid(data);
  if (this->Grid.IsEmpty() || !std::all_of(this->Points.begin(), this->Points.end(), IsFinitePlace))
  {
    this->Grid = ChessboardGrid();
    return false;
  }
  this->CopyGridCells(scalars, opacity);
  this->FindHiddenCells(data, scalars, opacity);
  this->Lattice.Found = this->FindLattice();
  if (this->FindSeam())
  {
    this->Grid.WrapCells = this->Grid.Size[0] - 1;
  }
  return true;
}

// True when the first axis closes on itself, as longitudes do: with equal values, and an even
// number of cells, so that even vertices meet even ones.
bool CellGeometry::FindSeam()
{
  const ChessboardGrid& grid = this->Grid;
  const int last = grid.Size[0] - 1;
  if (last % 2 != 0)
  {
    return false;
  }
  const double tolerance = 1e-6 * this->Radius();
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      const std::size_t a = static_cast<std::size_t>(grid.PointNumber(0, j, k));
      const std::size_t b = static_cast<std::size_t>(grid.PointNumber(last, j, k));
      const Point& p = this->Points[a];
      const Point& q = this->Points[b];
      const bool opacityDiffers = this->HasOpacityScalars && !this->OpacityOnCells &&
        this->OpacityScalars[a] != this->OpacityScalars[b];
      if (std::abs(p.X - q.X) > tolerance || std::abs(p.Y - q.Y) > tolerance ||
        std::abs(p.Z - q.Z) > tolerance || p.Scalar != q.Scalar || opacityDiffers)
      {
        return false;
      }
    }
  }
  return true;
}

// True when all points are evenly spaced.
bool CellGeometry::FindLattice()
{
  const ChessboardGrid& grid = this->Grid;
  const std::array<int, 3> last = { { grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1 } };
  const auto at = [&](int i, int j, int k) {
    return this->Position(static_cast<std::int32_t>(grid.PointNumber(i, j, k)));
  };
  if (!this->Lattice.Span(
        grid, at(0, 0, 0), { { at(last[0], 0, 0), at(0, last[1], 0), at(0, 0, last[2]) } }))
  {
    return false;
  }
  std::atomic<bool> all(true);
  vtkSMPTools::For(0, grid.Size[2], [&](vtkIdType begin, vtkIdType end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end) && all; ++k)
    {
      for (int j = 0; j < grid.Size[1]; ++j)
      {
        for (int i = 0; i < grid.Size[0]; ++i)
        {
          if (!this->Lattice.Has({ { i, j, k } }, at(i, j, k)))
          {
            all = false;
            return;
          }
        }
      }
    }
  });
  return all;
}

void CellGeometry::CopyGridCells(const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  const vtkIdType cells = this->Grid.NumberOfCells();
  this->CellScalars.resize(scalars.OnCells ? static_cast<std::size_t>(cells) : 0);
  if (opacity.OnCells)
  {
    this->OpacityScalars.resize(static_cast<std::size_t>(cells));
  }
  this->Layers.resize(this->LayerArray ? static_cast<std::size_t>(cells) : 0);
  vtkSMPTools::For(0, cells, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const std::size_t cell = static_cast<std::size_t>(i);
      if (this->LayerArray)
      {
        this->Layers[cell] = static_cast<std::int32_t>(this->LayerArray->GetComponent(i, 0));
      }
      if (scalars.OnCells)
      {
        this->CellScalars[cell] = Normalized(scalars, i, this->ScalarRange);
      }
      if (opacity.OnCells)
      {
        this->OpacityScalars[cell] = Normalized(opacity, i, this->OpacityRange);
      }
    }
  });
}

// Cells that ghost arrays hide, and those with a value that is not finite; such values become 0.
void CellGeometry::FindHiddenCells(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  const bool invalidPoints = std::any_of(this->Points.begin(), this->Points.end(),
    [](const Point& p) { return !std::isfinite(p.Scalar); });
  if (!data->GetCellGhostArray() && !data->GetPointGhostArray() && !invalidPoints &&
    !HasInvalid(this->CellScalars) && !HasInvalid(this->OpacityScalars))
  {
    return;
  }
  this->HiddenCells.assign(static_cast<std::size_t>(this->Grid.NumberOfCells()), 0);
  std::atomic<std::int64_t> invalid(0);
  vtkSMPTools::For(0, this->Grid.NumberOfCells(), [&](vtkIdType begin, vtkIdType end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const CellOutcome outcome = walker.Look(cell);
      invalid += outcome == CellOutcome::Invalid;
      this->HiddenCells[static_cast<std::size_t>(cell)] =
        outcome == CellOutcome::Decomposed ? 0 : 255;
    }
  });
  this->NumberOfInvalidCells = invalid;
  for (Point& p : this->Points)
  {
    p.Scalar = std::isfinite(p.Scalar) ? p.Scalar : 0.0f;
  }
  for (std::vector<float>* values : { &this->CellScalars, &this->OpacityScalars })
  {
    std::replace_if(
      values->begin(), values->end(), [](float v) { return !std::isfinite(v); }, 0.0f);
  }
}

} // namespace nephoscope
