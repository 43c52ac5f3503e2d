// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which samples of a dataset are left out: hidden ones, and duplicates of what another process has.
 */
#ifndef nephoscope_HiddenSamples_h
#define nephoscope_HiddenSamples_h

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * One flag for each sample; empty if all are drawn. A cell is left out by its own vtkGhostType or
 * by a hidden corner, a point by its own, if all of its cells are hidden or refined, or if all are
 * duplicates. `withDuplicates`: those are drawn.
 */
std::vector<unsigned char> FindHiddenSamples(vtkDataSet* data, bool onCells, bool withDuplicates);

/**
 * The cells that give no share to their points: hidden or refined by their own flag. One flag for
 * each cell; empty if there are none. A hidden point takes its own share of its cells with it, and
 * leaves the others theirs.
 */
std::vector<unsigned char> FindHiddenCells(vtkDataSet* data);

} // namespace nephoscope

#endif
