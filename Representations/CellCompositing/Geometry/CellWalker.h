// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The cells of a dataset one by one: which of them are drawn, and their tetrahedra. */
#ifndef nephoscope_CellWalker_h
#define nephoscope_CellWalker_h

#include "CellGeometry.h"
#include "TetrahedronSource.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace nephoscope
{

/** Several threads may do it. */
inline void RaiseTo(std::atomic<int>& greatest, int number)
{
  int known = greatest;
  while (number > known && !greatest.compare_exchange_weak(known, number))
  {
  }
}

enum class CellOutcome
{
  Decomposed,
  Skipped,
  Unsupported,
  Invalid
};

/** Counts cells that fold over themselves; several threads may add to it. */
class ShapeCounts
{
public:
  void Add(CellShape shape, vtkIdType cell)
  {
    if (shape != CellShape::Whole)
    {
      ++(shape == CellShape::Folded ? this->Folded : this->Misnumbered);
      std::int64_t known = this->First;
      while ((known < 0 || cell < known) && !this->First.compare_exchange_weak(known, cell))
      {
      }
    }
  }

  std::atomic<std::int64_t> Misnumbered{ 0 }, Folded{ 0 }, First{ -1 };
};

/**
 * Decides of each cell whether it can be drawn, and gives its tetrahedra. One object per thread.
 */
class CellWalker
{
public:
  CellWalker(vtkDataSet* data, const CellGeometry& geometry, const ScalarSelection& scalars,
    const ScalarSelection& opacity)
    : Source(data, geometry.GetDivisions())
    , Geometry(geometry)
    , Scalars(scalars)
    , Opacity(opacity)
  {
  }

  /** Skipped or Invalid, or else Decomposed: it can be. */
  CellOutcome Look(vtkIdType cell)
  {
    return this->Source.IsHidden(cell) ? CellOutcome::Skipped
      : this->IsFinite(cell)           ? CellOutcome::Decomposed
                                       : CellOutcome::Invalid;
  }

  template <typename Emit>
  CellOutcome Walk(vtkIdType cell, Emit emit)
  {
    const CellOutcome outcome = this->Look(cell);
    if (outcome != CellOutcome::Decomposed)
    {
      return outcome;
    }
    const bool supported =
      this->Source.EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& t) {
        emit(Tetrahedron{
          { std::int32_t(t[0]), std::int32_t(t[1]), std::int32_t(t[2]), std::int32_t(t[3]) } });
      });
    return supported ? CellOutcome::Decomposed : CellOutcome::Unsupported;
  }

  /** The shape of the cell that was looked at last. */
  CellShape FindShape(vtkIdType cell)
  {
    const auto rounded = [this](vtkIdType id) { return this->Geometry.Position(std::int32_t(id)); };
    return this->Source.PassesQuickTest(rounded) ? CellShape::Whole : this->Source.PutInOrder(cell);
  }
  /** The shape of the cell that was walked last. */
  CellShape GetShape() const { return this->Source.GetShape(); }
  /** Off: all cells are known to be in order, from an earlier walk. */
  void SetFindsShapes(bool finds) { this->Source.SetFindsShapes(finds); }

  /**
   * Whether the tetrahedra of the cell that was walked last overlap by more than a thousandth of
   * it.
   */
  bool IsWarped() const { return this->Source.IsWarped(); }
  /** Whether no point occurs twice in the cell that was looked at last. */
  bool HasDistinctPoints() const
  {
    const vtkIdList* points = this->Source.GetPoints();
    for (auto p = points->begin(); p != points->end(); ++p)
    {
      if (std::find(points->begin(), p, *p) != p)
      {
        return false;
      }
    }
    return true;
  }
  /** Whether those of the cell that was walked last do. */
  bool TetrahedraFillCell() { return this->Source.TetrahedraFillCell(); }

private:
  bool IsFinite(vtkIdType cell) const
  {
    if ((this->Scalars.OnCells && !std::isfinite(ScalarValue(this->Scalars, cell))) ||
      (this->Opacity.OnCells && !std::isfinite(ScalarValue(this->Opacity, cell))))
    {
      return false;
    }
    const bool opacityOnPoints = this->Geometry.HasOpacityScalars && !this->Opacity.OnCells;
    const vtkIdList* points = this->Source.GetPoints();
    return std::all_of(points->begin(), points->end(), [&](vtkIdType id) {
      const std::size_t i = static_cast<std::size_t>(id);
      const CellGeometry::Point& p = this->Geometry.Points[i];
      return std::isfinite(p.X) && std::isfinite(p.Y) && std::isfinite(p.Z) &&
        std::isfinite(p.Scalar) &&
        (!opacityOnPoints || std::isfinite(this->Geometry.OpacityScalars[i]));
    });
  }

  TetrahedronSource Source;
  const CellGeometry& Geometry;
  const ScalarSelection& Scalars;
  const ScalarSelection& Opacity;
};

} // namespace nephoscope

#endif
