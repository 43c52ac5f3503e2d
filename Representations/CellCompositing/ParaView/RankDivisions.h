// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How several ranks divide unstructured hexahedra in the same way as one rank that has all of them.
 */
#ifndef nephoscope_RankDivisions_h
#define nephoscope_RankDivisions_h

class vtkUnstructuredGrid;

namespace nephoscope
{

/**
 * Stores the division of the cells of ChessboardDivision.h, 0 where the cells of all ranks together
 * have none (divisionName in ChessboardDivision.h).
 * Cells that have the array keep it. All ranks must call it. Ranks exchange the points that
 * they have in common: 56 bytes each.
 */
void StoreRankDivisions(vtkUnstructuredGrid* cells);

} // namespace nephoscope

#endif
