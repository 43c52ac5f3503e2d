// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Normals of contour surfaces on several ranks, from the cells of all of them. */
#ifndef RankGradients_h
#define RankGradients_h

class vtkDataSet;

namespace nephoscope
{

/**
 * Stores the gradients of a point array with one component (storedGradientsName in PointGradients.h): those that one rank with the cells of all would
 * find. All ranks must call it; a piece without cells needs no array. Where the array is missing or has several components on any rank,
 * nothing is stored, and each rank finds the gradients of its own cells. The points of each piece that others may have are exchanged, one rank after another:
 * 96 bytes each.
 */
void storeRankGradients(vtkDataSet* piece, const char* arrayName);

} // namespace nephoscope

#endif
