// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellGeometry.h"

#include "CellWalker.h"
#include "ChessboardDivision.h"
#include "TetrahedraAmongCells.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace nephoscope
{
namespace
{
// No volume but for rounding: coincident or coplanar vertices.
bool IsFlat(const CellGeometry& geometry, const Tetrahedron& t)
{
  const Vector3 a = geometry.Position(t[0]);
  const Vector3 ab = Difference(geometry.Position(t[1]), a);
  const Vector3 ac = Difference(geometry.Position(t[2]), a);
  const Vector3 ad = Difference(geometry.Position(t[3]), a);
  const double box = std::sqrt(Dot(ab, ab) * Dot(ac, ac) * Dot(ad, ad));
  return std::abs(Dot(Cross(ab, ac), ad)) <= 1e-12 * box;
}
}

void CellGeometry::Clear()
{
  *this = CellGeometry();
}

bool CellGeometry::IsOf(Form form) const
{
  const auto dividesAll = [&](Form f) {
    return f == Form::WholeCells ||
      (f == Form::Automatic && this->MostAreTetrahedra &&
        this->NumberOfWarpedCells + this->NumberOfFoldedCells == 0);
  };
  const auto dividesNone = [&](Form f) {
    return f == Form::Hexahedra || (f == Form::Automatic && !this->MostAreTetrahedra);
  };
  return form == this->BuiltForm || (dividesAll(form) && dividesAll(this->BuiltForm)) ||
    (dividesNone(form) && dividesNone(this->BuiltForm)) ||
    (!this->Grid.IsEmpty() && form != Form::Tetrahedra);
}

std::array<Vector3, 4> CellGeometry::Vertices(std::size_t tetrahedron) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return { { this->Position(t[0]), this->Position(t[1]), this->Position(t[2]),
    this->Position(t[3]) } };
}

std::string CellGeometry::Build(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, vtkDataArray* layers, const Progress& progress, Form form)
{
  this->Clear();
  this->BuiltForm = form;
  this->LayerArray = layers;
  constexpr vtkIdType limit = std::numeric_limits<std::int32_t>::max() / 8;
  if (data->GetNumberOfPoints() > limit || data->GetNumberOfCells() > limit)
  {
    return "The input has more than " + std::to_string(limit) +
      " points or cells in one piece; distribute it over more ranks.";
  }
  if (data->GetNumberOfCells() > 0)
  {
    data->GetCellType(0);
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(
      0, ids); // builds what datasets build on first use, before threads ask for it
  }
  const bool copied = this->CopyPoints(data, progress.Part(0, 0.1)) &&
    this->CopyScalars(data, scalars, progress.Part(0.1, 0.2)) &&
    this->CopyOpacityScalars(data, opacity, progress.Part(0.2, 0.3));
  this->MostAreTetrahedra = TetrahedraBeyondOthers(data) > 0;
  bool implied = copied && form != Form::Tetrahedra &&
    (this->UseGrid(data, scalars, opacity) ||
      ((form == Form::Hexahedra || (form == Form::Automatic && !this->MostAreTetrahedra)) &&
        this->UseHexahedra(data, scalars, opacity, progress.Part(0.3, 1))));
  if (copied && !implied)
  {
    this->Divisions = ChessboardDivision(data);
    implied = form >= Form::WholeCells &&
      this->UseDividedHexahedra(data, scalars, opacity, progress.Part(0.3, 1));
  }
  if (!copied || (!implied && !this->Decompose(data, scalars, opacity, progress.Part(0.3, 1))))
  {
    this->Clear();
    this->Stopped = true;
  }
  else if (form == Form::Automatic && this->NumberOfWarpedCells + this->NumberOfFoldedCells > 0)
  {
    this->PreferHexahedra(data, scalars, opacity, progress.Part(0.9, 1));
  }
  this->LayerArray = nullptr;
  this->Divisions = nullptr;
  return std::string();
}

void CellGeometry::PreferHexahedra(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, const Progress& progress)
{
  if (this->UseHexahedra(data, scalars, opacity, progress))
  {
    this->Tetrahedra = {};
    this->NumberOfFlatTetrahedra = 0;
  }
  else if (!this->Hexahedra.empty()) // some were found when it was told to stop
  {
    this->Clear();
    this->Stopped = true;
  }
}

bool CellGeometry::CopyPoints(vtkDataSet* data, const Progress& progress)
{
  double bounds[6];
  data->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    this->Center[axis] = std::isfinite(middle) ? middle : 0.0;
  }
  // What is left of the pole of a globe by the rounding of sines and cosines is not a place of its
  // own.
  double noise = 0;
  for (const double bound : bounds)
  {
    noise = std::isfinite(bound) ? std::max(noise, 1e-14 * std::abs(bound)) : noise;
  }
  const auto place = [&](double x, int axis) {
    const double d = x - this->Center[axis];
    return std::abs(d) < noise ? 0.0f : static_cast<float>(d);
  };
  this->Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  return ForRanges(this->Points.size(), progress, [&](std::size_t begin, std::size_t end) {
    double x[3];
    for (std::size_t i = begin; i < end; ++i)
    {
      data->GetPoint(static_cast<vtkIdType>(i), x);
      this->Points[i] = { place(x[0], 0), place(x[1], 1), place(x[2], 2), 0.0f };
    }
  });
}

bool CellGeometry::Decompose(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, const Progress& progress)
{
  std::vector<std::int64_t> first(static_cast<std::size_t>(data->GetNumberOfCells()) + 1, 0);
  bool counted = this->CountOfCells(data, scalars, opacity, first, progress.Part(0, 0.5)); // PASS 1
  if (this->Divisions && this->NumberOfMisnumberedCells > 0)
  {
    this->Divisions = nullptr; // their edges are not those of the mesh
    counted = this->CountOfCells(data, scalars, opacity, first, progress.Part(0, 0.5));
  }
  if (!counted)
  {
    return false;
  }
  const bool oneEach =
    std::all_of(first.begin() + 1, first.end(), [](std::int64_t count) { return count == 1; });
  std::partial_sum(first.begin(), first.end(), first.begin()); // PASS 2
  this->Tetrahedra.Resize(static_cast<std::size_t>(first.back()));
  this->Cells.resize(oneEach ? 0 : this->Tetrahedra.size());
  this->Layers.resize(this->LayerArray ? this->Tetrahedra.size() : 0);
  if (!this->FillTetrahedra(data, scalars, opacity, first, progress.Part(0.5, 0.9))) // PASS 3
  {
    return false;
  }
  if (oneEach)
  {
    this->Tetrahedra.ReadFrom(data);
  }
  return (!scalars.OnCells ||
           this->CopyCellValues(
             scalars, this->ScalarRange, this->CellScalars, progress.Part(0.9, 0.95))) &&
    (!opacity.OnCells ||
      this->CopyCellValues(
        opacity, this->OpacityRange, this->OpacityScalars, progress.Part(0.95, 1)));
}

// counts[cell + 1]: tetrahedra of the cell.
bool CellGeometry::CountOfCells(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, std::vector<std::int64_t>& counts, const Progress& progress)
{
  std::atomic<std::int64_t> unsupported(0), invalid(0), nonConvex(0), warped(0), flat(0);
  std::atomic<int> unsupportedType(0);
  ShapeCounts shapes;
  const std::size_t n = static_cast<std::size_t>(data->GetNumberOfCells());
  const bool done = ForRanges(n, progress, [&](std::size_t begin, std::size_t end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = static_cast<vtkIdType>(begin); cell < static_cast<vtkIdType>(end); ++cell)
    {
      std::int64_t& count = counts[static_cast<std::size_t>(cell) + 1];
      count = 0;
      const CellOutcome outcome =
        walker.Walk(cell, [&](const Tetrahedron& t) { IsFlat(*this, t) ? ++flat : ++count; });
      invalid += outcome == CellOutcome::Invalid;
      nonConvex += outcome == CellOutcome::Decomposed && !walker.TetrahedraFillCell();
      warped += outcome == CellOutcome::Decomposed && walker.IsWarped() &&
        walker.GetShape() != CellShape::Folded;
      if (outcome == CellOutcome::Decomposed)
      {
        shapes.Add(walker.GetShape(), cell);
      }
      if (outcome == CellOutcome::Unsupported)
      {
        ++unsupported;
        RaiseTo(unsupportedType, data->GetCellType(cell));
      }
    }
  });
  this->NumberOfUnsupportedCells = unsupported;
  this->UnsupportedCellType = unsupportedType;
  this->NumberOfInvalidCells = invalid;
  this->NumberOfNonConvexCells = nonConvex;
  this->NumberOfWarpedCells = warped;
  this->NumberOfFlatTetrahedra = flat;
  this->CountShapes(shapes);
  return done;
}

void CellGeometry::CountShapes(const ShapeCounts& counts)
{
  this->NumberOfMisnumberedCells = counts.Misnumbered;
  this->NumberOfFoldedCells = counts.Folded;
  this->FirstFoldedCell = counts.First;
}

// first[cell]: where the cell's tetrahedra begin.
bool CellGeometry::FillTetrahedra(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, const std::vector<std::int64_t>& first, const Progress& progress)
{
  const std::size_t n = static_cast<std::size_t>(data->GetNumberOfCells());
  return ForRanges(n, progress, [&](std::size_t begin, std::size_t end) {
    CellWalker walker(data, *this, scalars, opacity);
    walker.SetFindsShapes(this->NumberOfMisnumberedCells > 0);
    for (vtkIdType cell = static_cast<vtkIdType>(begin); cell < static_cast<vtkIdType>(end); ++cell)
    {
      std::size_t next = static_cast<std::size_t>(first[static_cast<std::size_t>(cell)]);
      walker.Walk(cell, [&](const Tetrahedron& t) {
        if (IsFlat(*this, t))
        {
          return;
        }
        if (!this->Cells.empty())
        {
          this->Cells[next] = static_cast<std::int32_t>(cell);
        }
        if (this->LayerArray)
        {
          this->Layers[next] = static_cast<std::int32_t>(this->LayerArray->GetComponent(cell, 0));
        }
        this->Tetrahedra.Set(next++, t);
      });
    }
  });
}

} // namespace nephoscope
