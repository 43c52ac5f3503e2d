// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * TetGen (Si2015) on one cell: the only file that uses it, and only where the build has found it.
 *
 * TetGen keeps the state of its predicates and its random numbers in variables of the whole process (exactinit in predicates.cxx sets
 * error bounds from the mesh at hand), so one cell at a time is divided, whichever thread asks.
 */
#ifndef TetGenDivision_h
#define TetGenDivision_h

#include "CellDivision.h"

#include <string>

namespace nephoscope
{

/** Whether the build has TetGen. */
bool hasTetGen();

/**
 * Fills Tetrahedra and NewPoints, with the surface's triangles left as they are. Returns an empty string, or why there is no result.
 */
std::string divideByTetGen(const TriangulatedSurface& surface, CellDivision& division);

} // namespace nephoscope

#endif
