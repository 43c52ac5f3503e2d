// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Extinction of samples at points, such that they have together that of the cells between them. */
#ifndef nephoscope_CellExtinction_h
#define nephoscope_CellExtinction_h

#include <vector>

class vtkDataSet;

namespace nephoscope
{

class TransferFunctionTable;

/**
 * Extinction at every point. `scalars` has the value of each, as the table takes it; it is not
 * finite where there is none.
 *
 * In a cell the scalar is interpolated linearly (trilinearly) between its corners, then mapped, as
 * volume renderers of cells do. The mean of that over the cell is less than the mean over its
 * corners where the opacity function begins at a threshold: 7 % of the extinction of the forecast's
 * clouds. Every corner that can be seen gives in the same proportion, so that no sample is drawn
 * that is transparent itself, unless all corners of a visible cell are.
 * Cells with a corner without value (or hidden) do not count, nor do hidden ones, ones that are not
 * solid, and polyhedra. A point without any cell has its own extinction.
 */
std::vector<float> InterpolateExtinction(
  vtkDataSet* data, const std::vector<float>& scalars, const TransferFunctionTable& table);

} // namespace nephoscope

#endif
