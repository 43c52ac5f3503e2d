// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells that meet at an axis or a centre are needles. Splats of their shape would all reach across
 * it, into one another, and make it bright. They get as wide as the samples beside them are, and a
 * part of their extinction such that they keep their mass. GridSamples does so for structured
 * grids.
 */
#ifndef nephoscope_SplatNeedles_h
#define nephoscope_SplatNeedles_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * Shapes of unstructured samples, nine numbers each, all 0 where there is none, and the part of
 * each that counts.
 */
struct CellSplats
{
  std::vector<std::array<float, 9>>& Shapes;
  std::vector<float>& Parts;
  const std::vector<bool>& Kept; ///< those that are not widened; empty: none
};

/**
 * Widens samples that are less than a third as wide as one beside them, at right angles to the line
 * between both: along it the cells of graded meshes differ. None becomes wider than it is long:
 * small cells beside large ones are no needles. Beside a point are those that it has an edge to;
 * beside a cell its corners, each with the mean of the cells around it. `places`: for each point
 * the first one in its place, or empty. `hidden`: flags of cells, or empty.
 */
void WidenNeedles(vtkDataSet* data, bool onCells, const std::vector<vtkIdType>& places,
  const std::vector<unsigned char>& hidden, const CellSplats& splats);

} // namespace nephoscope

#endif
