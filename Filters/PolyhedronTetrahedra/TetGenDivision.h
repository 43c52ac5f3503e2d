// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * TetGen (Si2015) on single cells: the only file that uses it, and only where the build has found
 * it.
 *
 * TetGen keeps the state of its predicates and its random numbers in variables of the process
 * (exactinit in predicates.cxx sets error bounds from the mesh at hand), so one cell at a time is
 * divided. Why in another process: IsolatedProcess.h.
 */
#ifndef nephoscope_TetGenDivision_h
#define nephoscope_TetGenDivision_h

#include "CellDivision.h"

#include <functional>
#include <string>
#include <vector>

namespace nephoscope
{

/** Whether the build has TetGen. */
bool IsBuiltWithTetGen();

struct TetGenTask
{
  const TriangulatedSurface* Surface;
  CellDivision* Division; ///< gets Tetrahedra and NewPoints
  std::string Failure;    ///< empty, or why there is no result
};

/** The surfaces' triangles are left as they are: new points only inside. */
void DivideTasksByTetGen(std::vector<TetGenTask>& tasks, const std::function<bool()>& keepGoing);

} // namespace nephoscope

#endif
