// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Which samples of a dataset are left out: hidden ones, and duplicates of what another process has. */
#ifndef HiddenSamples_h
#define HiddenSamples_h

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * One flag for each sample; empty if all are drawn. A cell is left out by its own vtkGhostType or by a hidden corner, a point by its own, if
 * all of its cells are hidden or refined, or if all are duplicates. `withDuplicates`: those are drawn.
 */
std::vector<unsigned char> FindHiddenSamples(vtkDataSet* data, bool onCells, bool withDuplicates);

} // namespace nephoscope

#endif
