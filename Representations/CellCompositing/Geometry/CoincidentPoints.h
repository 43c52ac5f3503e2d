// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Finds the coincident points of a mesh.
 *
 * Parts of a mesh often repeat the points between them: blocks, the first and last column of
 * longitudes. Positions computed in two ways, such as the cosines of 0 and 360 degrees, differ by
 * rounding. Points coincide if their coordinates are equal, or if
 *  - they differ by no more than a few units in the last place of the largest coordinate, and
 *  - by no more than an eighth of the shortest edge of a tetrahedron at either of them, so that no
 *    tetrahedron ever loses its extent, and thin layers stay what they are.
 */
#ifndef nephoscope_CoincidentPoints_h
#define nephoscope_CoincidentPoints_h

#include "CellGeometry.h"
#include "ProgressLoop.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

/** For each point the first of the points with equal coordinates; empty when stopped. */
std::vector<std::int32_t> FindPlaces(const CellGeometry& geometry, const Progress& progress = {});

/**
 * Joins positions that differ by rounding: `places`, as FindPlaces has them, then name the first of
 * all those points. False when stopped.
 */
bool WeldPlaces(
  const CellGeometry& geometry, std::vector<std::int32_t>& places, const Progress& progress = {});

} // namespace nephoscope

#endif
