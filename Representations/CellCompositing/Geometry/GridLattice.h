// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A structured grid with evenly spaced points, such as an image has: there, the cell at a position
 * is a matter of arithmetic.
 */
#ifndef nephoscope_GridLattice_h
#define nephoscope_GridLattice_h

#include "ChessboardGrid.h"
#include "TetrahedronRay.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <array>
#include <cmath>

namespace nephoscope
{

struct GridLattice
{
  bool Found = false;
  std::array<double, 16>
    ToNumbers{}; ///< from positions to numbers of points along each axis, by rows

  /**
   * For a grid whose point 0 is `origin`, and whose last ones along each axis are `ends`. False:
   * they span no volume.
   */
  bool Span(const ChessboardGrid& grid, const Vector3& origin, const std::array<Vector3, 3>& ends)
  {
    vtkNew<vtkMatrix4x4> toPlaces;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3& end = ends[static_cast<std::size_t>(axis)];
      for (int i = 0; i < 3; ++i)
      {
        const std::size_t row = static_cast<std::size_t>(i);
        toPlaces->SetElement(i, axis, (end[row] - origin[row]) / (grid.Size[axis] - 1));
        toPlaces->SetElement(i, 3, origin[row]);
      }
    }
    const double volume = std::abs(toPlaces->Determinant());
    vtkMatrix4x4::Invert(toPlaces->GetData(), this->ToNumbers.data());
    return volume > 0 && std::isfinite(volume);
  }

  /** The point with these numbers has this position, to within a thousandth of a cell. */
  bool Has(const std::array<int, 3>& numbers, const Vector3& position) const
  {
    constexpr double tolerance = 1e-3;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double* row = &this->ToNumbers[4 * axis];
      const double number =
        row[0] * position[0] + row[1] * position[1] + row[2] * position[2] + row[3];
      if (!(std::abs(number - numbers[axis]) <= tolerance))
      {
        return false;
      }
    }
    return true;
  }
};

} // namespace nephoscope

#endif
