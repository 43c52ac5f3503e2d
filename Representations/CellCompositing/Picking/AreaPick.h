// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a user sees at each pixel of a rectangle: the same as CellPick.h, for many rays at once.
 *
 * Tetrahedra that are not clear are listed by the tiles of the picture that they cover. Each ray
 * tests those of its tile, from front to back, and ends where the cell is found.
 */
#ifndef nephoscope_AreaPick_h
#define nephoscope_AreaPick_h

#include "CellPick.h"

#include <array>
#include <functional>
#include <vector>

namespace nephoscope
{

struct PickArea
{
  std::array<int, 2> Size; ///< columns and rows: of pixels, or of squares of pixels
  /** From places relative to the geometry's centre to columns and rows, homogeneous. */
  std::array<Vector4, 2> ToPixels;
  Vector4 ToW;     ///< the denominator of both; positive in front of the eye
  Vector4 ToDepth; ///< grows along every ray, linear in space
  /** The ray through a pixel. Called by several threads. */
  std::function<PickRay(int column, int row)> Ray;
};

/**
 * Row by row from the lower left. `makeMedium` is called by several threads: what a medium's
 * functions change belongs to one of them.
 */
std::vector<PickedCell> PickCells(const CellGeometry& geometry,
  const std::function<PickMedium()>& makeMedium, const PickArea& area, double opticalDepth);

} // namespace nephoscope

#endif
