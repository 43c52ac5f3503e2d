// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Adaptive meshes as cells: of AMR data and hyper tree grids those cells that no finer one covers.
 */
#ifndef nephoscope_AdaptiveCells_h
#define nephoscope_AdaptiveCells_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/**
 * A leaf of a composite as a dataset: itself, or a hyper tree grid's cells. Null when it is
 * neither.
 */
vtkSmartPointer<vtkDataSet> LeafCells(vtkDataObject* leaf);

/**
 * Hides, in copies that replace the blocks, the cells of images that lie under images of smaller
 * cells: blocks of AMR data.
 */
void HideCoveredCells(std::vector<vtkSmartPointer<vtkDataSet>>& blocks);

} // namespace nephoscope

#endif
