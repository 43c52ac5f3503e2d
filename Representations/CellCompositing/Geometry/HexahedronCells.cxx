// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of CellGeometry that keeps the cells of unstructured data as hexahedra.
#include "CellGeometry.h"

#include "CellWalker.h"
#include "ChessboardDivision.h"
#include "HexahedronNeighbors.h"
#include "TetrahedraAmongCells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"

#include <atomic>
#include <numeric>

namespace nephoscope
{
namespace
{
bool AreHexahedra(vtkDataSet* data)
{
  bool other = false, tetrahedra = true;
  const vtkIdType n = data->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < n && !other; ++cell)
  {
    const int type = data->GetCellType(cell);
    const bool isSolid = HexahedronFormOf(type).Tetrahedra > 0;
    other = !isSolid && IsOtherSolid(type);
    tetrahedra = tetrahedra && (type == VTK_TETRA || !isSolid);
  }
  return !other && !tetrahedra;
}
}

// False where there are cells of other kinds, or nothing but tetrahedra, or when stopped.
bool CellGeometry::UseHexahedra(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, const Progress& progress)
{
  if (this->LayerArray || !FindChessboardGrid(data).IsEmpty() ||
    data->GetNumberOfCells() > mostLinkedHexahedra || !AreHexahedra(data))
  {
    return false;
  }
  const std::size_t n = static_cast<std::size_t>(data->GetNumberOfCells());
  std::vector<std::int32_t> first(n + 1, 0); // first[cell]: where the cell goes
  std::atomic<std::int64_t> invalid(0), tetrahedra(0), unsupported(0);
  std::atomic<int> unsupportedType(0);
  ShapeCounts shapes;
  const auto look = [&](std::size_t begin, std::size_t end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const CellOutcome outcome = walker.Look(static_cast<vtkIdType>(cell));
      invalid += outcome == CellOutcome::Invalid;
      const int type = data->GetCellType(static_cast<vtkIdType>(cell));
      const bool isSolid = HexahedronFormOf(type).Tetrahedra > 0;
      first[cell + 1] = isSolid && outcome == CellOutcome::Decomposed;
      if (first[cell + 1])
      {
        shapes.Add(walker.FindShape(static_cast<vtkIdType>(cell)), static_cast<vtkIdType>(cell));
      }
      tetrahedra += first[cell + 1] * HexahedronFormOf(type).Tetrahedra;
      if (!isSolid && outcome == CellOutcome::Decomposed && type != VTK_EMPTY_CELL)
      {
        ++unsupported;
        RaiseTo(unsupportedType, type);
      }
    }
  };
  if (!ForRanges(n, progress.Part(0, 0.5), look))
  {
    return false;
  }
  this->NumberOfInvalidCells = invalid;
  this->NumberOfUnsupportedCells = unsupported;
  this->UnsupportedCellType = unsupportedType;
  this->CountShapes(shapes);
  this->TetrahedraOfHexahedra = tetrahedra;
  return this->ListHexahedra(data, first, nullptr, scalars, opacity, progress.Part(0.5, 1));
}

// first[cell + 1]: 1 for a cell that is drawn.
bool CellGeometry::ListHexahedra(vtkDataSet* data, std::vector<std::int32_t>& first,
  vtkUnsignedCharArray* divisions, const ScalarSelection& scalars, const ScalarSelection& opacity,
  const Progress& progress)
{
  std::partial_sum(first.begin(), first.end(), first.begin());
  this->Hexahedra.resize(static_cast<std::size_t>(first.back()));
  this->Cells.resize(this->Hexahedra.size() + 1 == first.size() ? 0 : this->Hexahedra.size());
  return this->FillHexahedra(data, first, divisions, progress.Part(0, 0.8)) &&
    (!scalars.OnCells ||
      this->CopyCellValues(
        scalars, this->ScalarRange, this->CellScalars, progress.Part(0.8, 0.9))) &&
    (!opacity.OnCells ||
      this->CopyCellValues(
        opacity, this->OpacityRange, this->OpacityScalars, progress.Part(0.9, 1)));
}

// False unless all cells can be divided as those of a grid and are in good shape, or when stopped.
bool CellGeometry::UseDividedHexahedra(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, const Progress& progress)
{
  vtkUnsignedCharArray* divisions = this->Divisions
    ? this->Divisions.Get()
    : vtkUnsignedCharArray::SafeDownCast(data->GetCellData()->GetArray(divisionName));
  if (!divisions || this->LayerArray || data->GetNumberOfCells() > mostDividedHexahedra)
  {
    return false;
  }
  const std::size_t n = static_cast<std::size_t>(data->GetNumberOfCells());
  std::vector<std::int32_t> first(n + 1, 0);
  std::atomic<std::int64_t> invalid(0), drawn(0);
  std::atomic<bool> fits(true);
  const auto look = [&](std::size_t begin, std::size_t end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = static_cast<vtkIdType>(begin); cell < static_cast<vtkIdType>(end) && fits;
         ++cell)
    {
      const CellOutcome outcome = walker.Walk(cell, [](const Tetrahedron&) {});
      invalid += outcome == CellOutcome::Invalid;
      if (outcome == CellOutcome::Decomposed)
      {
        first[static_cast<std::size_t>(cell) + 1] = 1;
        ++drawn;
        if (!divisions->GetValue(cell) || walker.GetShape() != CellShape::Whole ||
          walker.IsWarped() || !walker.HasDistinctPoints())
        {
          fits = false;
        }
      }
    }
  };
  if (!ForRanges(n, progress.Part(0, 0.4), look) || !fits || drawn == 0)
  {
    return false;
  }
  this->NumberOfInvalidCells = invalid;
  this->TetrahedraOfHexahedra = ChessboardGrid::TetrahedraPerCell * drawn;
  this->DividesHexahedra = true;
  return this->ListHexahedra(data, first, divisions, scalars, opacity, progress.Part(0.4, 1));
}

// With `divisions`, all begin with an even vertex.
bool CellGeometry::FillHexahedra(vtkDataSet* data, const std::vector<std::int32_t>& first,
  vtkUnsignedCharArray* divisions, const Progress& progress)
{
  return ForRanges(first.size() - 1, progress, [&](std::size_t begin, std::size_t end) {
    TetrahedronSource source(data);
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      if (first[cell] == first[cell + 1])
      {
        continue;
      }
      const vtkIdType number = static_cast<vtkIdType>(cell);
      const HexahedronForm form = HexahedronFormOf(data->GetCellType(number));
      source.IsHidden(number); // reads its points
      if (this->NumberOfMisnumberedCells > 0)
      {
        source.PutInOrder(number);
      }
      const std::size_t at = static_cast<std::size_t>(first[cell]);
      const bool isOdd = divisions && divisions->GetValue(number) % 2 == 0;
      for (std::size_t k = 0; k < 8; ++k)
      {
        const int vertex = form.Vertices[isOdd ? k ^ 1 : k];
        this->Hexahedra[at][k] = static_cast<std::int32_t>(source.GetPoints()->GetId(vertex));
      }
      if (!this->Cells.empty())
      {
        this->Cells[at] = static_cast<std::int32_t>(number);
      }
    }
  });
}

} // namespace nephoscope
