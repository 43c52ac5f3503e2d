// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells of other ranks beside those of this one: the outer surface of a piece has no walls where it
 * meets other pieces.
 */
#ifndef nephoscope_NeighborCells_h
#define nephoscope_NeighborCells_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/** Whether there is a 3-D cell. */
bool HasVolumes(vtkDataSet* data);

/**
 * `input`, or a copy whose unstructured grids have a layer of cells of other ranks, marked as
 * duplicates. A grid that has such cells already, or 3-D cells on one rank only, stays as it is.
 * `input` may be null. Collective.
 */
vtkSmartPointer<vtkDataObject> WithNeighborCells(vtkDataObject* input);

} // namespace nephoscope

#endif
