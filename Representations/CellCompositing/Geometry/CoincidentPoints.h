// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which points of a mesh lie at the same place.
 *
 * Parts of a mesh often repeat the points between them: blocks, the first and last column of longitudes. Those that were computed in two
 * ways, as the cosines of 0 and 360 degrees, differ by rounding. Points are one place when their coordinates are equal, or when
 *  - they differ by no more than a few units in the last place of the largest coordinate, and
 *  - by no more than an eighth of the shortest edge of a tetrahedron at either of them, so that no tetrahedron ever loses its extent, and
 *    thin layers stay what they are.
 */
#ifndef CoincidentPoints_h
#define CoincidentPoints_h

#include "CellGeometry.h"
#include "ProgressLoop.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

/** For each point the first of the points with equal coordinates; empty when stopped. */
std::vector<std::int32_t> findPlaces(const CellGeometry& geometry, const Progress& progress = {});

/** Joins places that differ by rounding: `places`, as findPlaces has them, then name the first of all those points. False when stopped. */
bool weldPlaces(
  const CellGeometry& geometry, std::vector<std::int32_t>& places, const Progress& progress = {});

} // namespace nephoscope

#endif
