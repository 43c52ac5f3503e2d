// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Which rank draws a sample that several have. */
#ifndef nephoscope_SplatOwners_h
#define nephoscope_SplatOwners_h

#include "RankPlaces.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * For each of this rank's places, whether no lower rank has a sample at the same one, to the
 * rounding of double: pieces of a grid share the points of their borders. Only places inside the
 * bounds of another rank are exchanged. Collective.
 */
std::vector<bool> OwnedByThisRank(const std::vector<Vector3>& places);

/**
 * `piece`, or a copy whose flags of duplicate points follow from those of its cells, where there
 * are any: filters that number the points of a piece with its layer of cells of other ranks
 * (Generate Global Ids) give points of the layer to this rank, which draws none of their cells.
 * Collective.
 */
vtkSmartPointer<vtkDataSet> WithPointFlagsOfCells(vtkDataSet* piece);

/** The extent of an image, a rectilinear or a structured grid; false for other data. */
bool ExtentOf(vtkDataSet* piece, int extent[6]);

/**
 * Whether all ranks have pieces of a structured grid, or nothing; then `extents` are those of all
 * ranks, without the layers of points that they have from neighbours: six numbers each, in the
 * indices of the whole grid. Collective.
 */
bool FindExtentsOfRanks(vtkDataSet* piece, std::vector<int>& extents);

/** The lowest rank whose extent has the point. */
int OwnerOfPoint(const std::vector<int>& extents, int i, int j, int k);

} // namespace nephoscope

#endif
