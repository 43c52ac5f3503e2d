// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of CellGeometry that copies values of arrays.
#include "CellGeometry.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{

bool CellGeometry::CopyScalars(
  vtkDataSet* data, const ScalarSelection& scalars, const Progress& progress)
{
  if (!FindRange(data, scalars, this->ScalarRange, progress.Part(0, 0.5), &this->SingleScalar))
  {
    return false;
  }
  return ForEachIndex(
    scalars.OnCells ? 0 : this->Points.size(), progress.Part(0.5, 1), [&](std::size_t i) {
      this->Points[i].Scalar = Normalized(scalars, static_cast<vtkIdType>(i), this->ScalarRange);
    });
}

bool CellGeometry::CopyOpacityScalars(
  vtkDataSet* data, const ScalarSelection& opacity, const Progress& progress)
{
  this->HasOpacityScalars = opacity.Array != nullptr;
  this->OpacityOnCells = opacity.OnCells;
  if (!opacity.Array)
  {
    this->OpacityRange[0] = 0;
    this->OpacityRange[1] = 1;
    return true;
  }
  if (!FindRange(data, opacity, this->OpacityRange, progress.Part(0, 0.5)))
  {
    return false;
  }
  this->OpacityScalars.resize(opacity.OnCells ? 0 : this->Points.size());
  return ForEachIndex(this->OpacityScalars.size(), progress.Part(0.5, 1), [&](std::size_t i) {
    this->OpacityScalars[i] = Normalized(opacity, static_cast<vtkIdType>(i), this->OpacityRange);
  });
}

// Each tetrahedron or hexahedron has the value of its cell.
bool CellGeometry::CopyCellValues(const ScalarSelection& scalars, const double range[2],
  std::vector<float>& values, const Progress& progress) const
{
  values.resize(this->Tetrahedra.size() + this->Hexahedra.size());
  return ForEachIndex(values.size(), progress, [&](std::size_t i) {
    const vtkIdType cell = this->Cells.empty() ? static_cast<vtkIdType>(i) : this->Cells[i];
    values[i] = Normalized(scalars, cell, range);
  });
}

bool CellGeometry::ValuesAreFinite() const
{
  const auto finite = [](float v) { return std::isfinite(v); };
  return std::all_of(this->Points.begin(), this->Points.end(),
           [&](const Point& p) { return finite(p.Scalar); }) &&
    std::all_of(this->CellScalars.begin(), this->CellScalars.end(), finite) &&
    std::all_of(this->OpacityScalars.begin(), this->OpacityScalars.end(), finite);
}

bool CellGeometry::UpdateValues(vtkDataSet* data, const ScalarSelection& scalars,
  const ScalarSelection& opacity, bool ofColor, bool ofOpacity)
{
  if (!this->Grid.IsEmpty() || (this->Tetrahedra.empty() && this->Hexahedra.empty()) ||
    this->NumberOfInvalidCells > 0)
  {
    return false;
  }
  if (ofColor)
  {
    std::for_each(this->Points.begin(), this->Points.end(), [](Point& p) { p.Scalar = 0.0f; });
    this->CellScalars.clear();
    this->CopyScalars(data, scalars, {});
  }
  if (ofColor && scalars.OnCells)
  {
    this->CopyCellValues(scalars, this->ScalarRange, this->CellScalars, {});
  }
  if (ofOpacity)
  {
    this->OpacityScalars.clear();
    this->CopyOpacityScalars(data, opacity, {});
  }
  if (ofOpacity && opacity.OnCells)
  {
    this->CopyCellValues(opacity, this->OpacityRange, this->OpacityScalars, {});
  }
  return this->ValuesAreFinite();
}

} // namespace nephoscope
