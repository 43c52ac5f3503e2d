// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cells around the points of a piece of a mesh, those of other ranks too: they give splats
 * their shapes.
 */
#ifndef nephoscope_SplatBorders_h
#define nephoscope_SplatBorders_h

#include "vtkSmartPointer.h"

class vtkDataSet;

namespace nephoscope
{

/**
 * A mesh whose first points are those of `piece`, with the shown cells that this rank owns and the
 * cells of other ranks near the points that they share: three layers, since the shape of a sample
 * depends on its neighbours, and theirs on their own. Null where no rank has a mesh. Collective.
 */
vtkSmartPointer<vtkDataSet> WithCellsOfOtherRanks(vtkDataSet* piece);

} // namespace nephoscope

#endif
