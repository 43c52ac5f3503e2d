// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** An unstructured grid with all arrays, in which some cells are replaced by tetrahedra. */
#ifndef nephoscope_DividedGrid_h
#define nephoscope_DividedGrid_h

#include "CellDivision.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkUnstructuredGrid;

namespace nephoscope
{

/** One entry per cell; empty if the cell stays unchanged. */
using CellDivisions = std::vector<std::unique_ptr<CellDivision>>;

/**
 * Writes `output`; returns the number of points that were added. Tetrahedra take the place of their
 * cell in the order.
 * Points keep their numbers, new ones follow.
 *
 * - Cell arrays: each tetrahedron has its cell's values. Global cell ids become a plain array,
 *   since they are not unique any more.
 * - Point arrays: the values at new points are weighted sums (MeanValueWeights.h), rounded in
 *   arrays of integers; arrays that are not numbers take the value of the point with the largest
 *   weight. Ghost flags of new points are 0; global and pedigree ids of new points are -1, and
 *   become plain arrays if there are any.
 */
vtkIdType BuildDividedGrid(
  vtkUnstructuredGrid* input, const CellDivisions& divisions, vtkUnstructuredGrid* output);

} // namespace nephoscope

#endif
