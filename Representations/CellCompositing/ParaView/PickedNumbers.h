// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Which cells and points of the input a user picks, where blocks are drawn as one dataset. */
#ifndef nephoscope_PickedNumbers_h
#define nephoscope_PickedNumbers_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/** Arrays of the piece: numbers in a block, and the block's composite index. */
constexpr const char* pickedCellsName = "NephoscopePickedCells";
constexpr const char* pickedPointsName = "NephoscopePickedPoints";
constexpr const char* pickedBlocksName = "NephoscopePickedBlocks";

/**
 * The input itself, or a composite dataset whose blocks have the arrays above. Blocks of adaptive
 * meshes and hyper tree grids, which ParaView does not select by composite index, get none.
 */
vtkSmartPointer<vtkDataObject> WithPickedNumbers(vtkDataObject* input);

/** Whether the piece has the cells and points of the input in their order. */
bool HasNumbersOf(vtkDataObject* input, vtkDataSet* piece);

/**
 * Removes the numbers of points where blocks share points: such a point is that of several blocks.
 */
void DropSharedNumbers(vtkDataObject* input, vtkDataSet* piece);

} // namespace nephoscope

#endif
