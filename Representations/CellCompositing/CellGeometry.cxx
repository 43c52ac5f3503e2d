// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellGeometry.h"

#include "TetrahedronSource.h"

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
enum class Outcome
{
  Decomposed,
  Skipped,
  Unsupported,
  Invalid
};

/** Decides of each cell whether it can be drawn, and gives its tetrahedra. One object per thread. */
class CellWalker
{
public:
  CellWalker(vtkDataSet* data, const CellGeometry& geometry, const ScalarSelection& scalars,
    const ScalarSelection& opacity)
    : Source(data)
    , Geometry(geometry)
    , Scalars(scalars)
    , Opacity(opacity)
  {
  }

  template <typename Emit>
  Outcome Walk(vtkIdType cell, Emit emit)
  {
    if (this->Source.IsHidden(cell))
    {
      return Outcome::Skipped;
    }
    if (!this->IsFinite(cell))
    {
      return Outcome::Invalid;
    }
    const bool supported = this->Source.EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& t) {
      emit(Tetrahedron{ { std::int32_t(t[0]), std::int32_t(t[1]), std::int32_t(t[2]), std::int32_t(t[3]) } });
    });
    return supported ? Outcome::Decomposed : Outcome::Unsupported;
  }

private:
  bool IsFinite(vtkIdType cell) const
  {
    if ((this->Scalars.OnCells && !std::isfinite(scalarValue(this->Scalars, cell))) ||
      (this->Opacity.OnCells && !std::isfinite(scalarValue(this->Opacity, cell))))
    {
      return false;
    }
    const bool opacityOnPoints = this->Geometry.HasOpacityScalars && !this->Opacity.OnCells;
    const vtkIdList* points = this->Source.GetPoints();
    return std::all_of(points->begin(), points->end(), [&](vtkIdType id) {
      const std::size_t i = static_cast<std::size_t>(id);
      const CellGeometry::Point& p = this->Geometry.Points[i];
      return std::isfinite(p.X) && std::isfinite(p.Y) && std::isfinite(p.Z) && std::isfinite(p.Scalar) &&
        (!opacityOnPoints || std::isfinite(this->Geometry.OpacityScalars[i]));
    });
  }

  TetrahedronSource Source;
  const CellGeometry& Geometry;
  const ScalarSelection& Scalars;
  const ScalarSelection& Opacity;
};

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
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity, vtkDataArray* layers)
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
  this->Decompose(data, scalars, opacity);
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
  std::atomic<std::int64_t> unsupported(0), invalid(0), flat(0);
  std::atomic<int> unsupportedType(0);
  vtkSMPTools::For(0, data->GetNumberOfCells(), [&](vtkIdType begin, vtkIdType end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      std::int64_t& count = counts[static_cast<std::size_t>(cell) + 1];
      const Outcome outcome = walker.Walk(cell, [&](const Tetrahedron& t) {
        isFlat(*this, t) ? ++flat : ++count;
      });
      invalid += outcome == Outcome::Invalid;
      if (outcome == Outcome::Unsupported)
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
