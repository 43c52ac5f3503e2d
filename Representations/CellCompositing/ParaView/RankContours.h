// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What contour surfaces on several ranks need of the cells of all of them: the range of values, and
 * normals.
 */
#ifndef nephoscope_RankContours_h
#define nephoscope_RankContours_h

class vtkDataSet;

namespace nephoscope
{

/**
 * Stores the range of a point array (storedContourRangeName in PointGradients.h) and, if asked to,
 * its gradients (storedGradientsName there): those that one rank with the cells of all would find.
 * All ranks must call it; a piece without cells needs no array. Arrays of several components have
 * those of their magnitude. Where the array is missing on any rank, or has several components and
 * `ofMagnitude` is false, nothing is stored, and each rank finds what its own cells have. The
 * points that several pieces have are exchanged for the gradients: 96 bytes each.
 */
void StoreRankContours(vtkDataSet* piece, const char* arrayName, bool ofMagnitude, bool gradients);

} // namespace nephoscope

#endif
