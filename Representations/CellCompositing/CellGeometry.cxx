// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellGeometry.h"

#include "CellWalker.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace nephoscope
{
namespace
{
// No volume but for rounding: coincident or coplanar vertices.
bool isFlat(const CellGeometry& geometry, const Tetrahedron& t)
{
  const Vector3 a = geometry.Position(t[0]);
  const Vector3 ab = difference(geometry.Position(t[1]), a);
  const Vector3 ac = difference(geometry.Position(t[2]), a);
  const Vector3 ad = difference(geometry.Position(t[3]), a);
  const double box = std::sqrt(dot(ab, ab) * dot(ac, ac) * dot(ad, ad));
  return std::abs(dot(cross(ab, ac), ad)) <= 1e-12 * box;
}
}

void CellGeometry::Clear()
{
  *this = CellGeometry();
}

std::array<Vector3, 4> CellGeometry::Vertices(std::size_t tetrahedron) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return { { this->Position(t[0]), this->Position(t[1]), this->Position(t[2]), this->Position(t[3]) } };
}

std::string CellGeometry::Build(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity, vtkDataArray* layers, Form form)
{
  this->Clear();
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
    data->GetCellPoints(0, ids); // builds what datasets build on first use, before threads ask for it
  }
  this->CopyPoints(data);
  this->CopyScalars(data, scalars);
  this->CopyOpacityScalars(data, opacity);
  if (form == Form::Tetrahedra || !this->UseGrid(data, scalars, opacity))
  {
    this->Decompose(data, scalars, opacity);
  }
  this->LayerArray = nullptr;
  return std::string();
}

void CellGeometry::CopyPoints(vtkDataSet* data)
{
  double bounds[6];
  data->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    this->Center[axis] = std::isfinite(middle) ? middle : 0.0;
  }
  this->Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkSMPTools::For(0, data->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    double x[3];
    for (vtkIdType i = begin; i < end; ++i)
    {
      data->GetPoint(i, x);
      this->Points[static_cast<std::size_t>(i)] = { static_cast<float>(x[0] - this->Center[0]),
        static_cast<float>(x[1] - this->Center[1]), static_cast<float>(x[2] - this->Center[2]), 0.0f };
    }
  });
}

void CellGeometry::CopyScalars(vtkDataSet* data, const ScalarSelection& scalars)
{
  findRange(data, scalars, this->ScalarRange);
  if (scalars.OnCells)
  {
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Points[static_cast<std::size_t>(i)].Scalar = normalized(scalars, i, this->ScalarRange);
    }
  });
}

void CellGeometry::CopyOpacityScalars(vtkDataSet* data, const ScalarSelection& opacity)
{
  this->HasOpacityScalars = opacity.Array != nullptr;
  this->OpacityOnCells = opacity.OnCells;
  if (!opacity.Array)
  {
    return;
  }
  findRange(data, opacity, this->OpacityRange);
  if (opacity.OnCells)
  {
    return;
  }
  this->OpacityScalars.resize(this->Points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->OpacityScalars[static_cast<std::size_t>(i)] = normalized(opacity, i, this->OpacityRange);
    }
  });
}

void CellGeometry::Decompose(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  std::vector<std::int64_t> first(static_cast<std::size_t>(data->GetNumberOfCells()) + 1, 0);
  this->CountTetrahedra(data, scalars, opacity, first);               // PASS 1
  std::partial_sum(first.begin(), first.end(), first.begin());        // PASS 2
  this->Tetrahedra.resize(static_cast<std::size_t>(first.back()));
  this->CellScalars.resize(scalars.OnCells ? this->Tetrahedra.size() : 0);
  this->Layers.resize(this->LayerArray ? this->Tetrahedra.size() : 0);
  if (opacity.OnCells)
  {
    this->OpacityScalars.resize(this->Tetrahedra.size());
  }
  this->FillTetrahedra(data, scalars, opacity, first);                // PASS 3
}

// counts[cell + 1]: tetrahedra of the cell.
void CellGeometry::CountTetrahedra(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, std::vector<std::int64_t>& counts)
{
  std::atomic<std::int64_t> unsupported(0), invalid(0), nonConvex(0), flat(0);
  std::atomic<int> unsupportedType(0);
  vtkSMPTools::For(0, data->GetNumberOfCells(), [&](vtkIdType begin, vtkIdType end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      std::int64_t& count = counts[static_cast<std::size_t>(cell) + 1];
      const CellOutcome outcome = walker.Walk(cell, [&](const Tetrahedron& t) {
        isFlat(*this, t) ? ++flat : ++count;
      });
      invalid += outcome == CellOutcome::Invalid;
      nonConvex += outcome == CellOutcome::Decomposed && !walker.TetrahedraFillCell();
      if (outcome == CellOutcome::Unsupported)
      {
        ++unsupported;
        const int type = data->GetCellType(cell);
        int known = unsupportedType;
        while (type > known && !unsupportedType.compare_exchange_weak(known, type))
        {
        }
      }
    }
  });
  this->NumberOfUnsupportedCells = unsupported;
  this->UnsupportedCellType = unsupportedType;
  this->NumberOfInvalidCells = invalid;
  this->NumberOfNonConvexCells = nonConvex;
  this->NumberOfFlatTetrahedra = flat;
}

// first[cell]: where the cell's tetrahedra begin.
void CellGeometry::FillTetrahedra(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, const std::vector<std::int64_t>& first)
{
  vtkSMPTools::For(0, data->GetNumberOfCells(), [&](vtkIdType begin, vtkIdType end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      std::size_t next = static_cast<std::size_t>(first[static_cast<std::size_t>(cell)]);
      walker.Walk(cell, [&](const Tetrahedron& t) {
        if (isFlat(*this, t))
        {
          return;
        }
        if (scalars.OnCells)
        {
          this->CellScalars[next] = normalized(scalars, cell, this->ScalarRange);
        }
        if (opacity.OnCells)
        {
          this->OpacityScalars[next] = normalized(opacity, cell, this->OpacityRange);
        }
        if (this->LayerArray)
        {
          this->Layers[next] = static_cast<std::int32_t>(this->LayerArray->GetComponent(cell, 0));
        }
        this->Tetrahedra[next++] = t;
      });
    }
  });
}

} // namespace nephoscope
