// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Whether the surface of a mesh is convex, so that no ray enters the mesh twice. */
#ifndef BoundarySurface_h
#define BoundarySurface_h

#include "FaceNeighbors.h"

namespace nephoscope
{

/**
 * True for a closed surface in one piece that bends inwards at none of its edges (by more than the rounding of coordinates):
 * such a surface bounds a convex body. `places` are those of findPlaces. False, too, when stopped.
 */
bool isConvexSurface(const CellGeometry& geometry, const std::vector<FaceNeighbors::Face>& boundary,
  const std::vector<std::int32_t>& places, double coordinateError, const Progress& progress = {});

} // namespace nephoscope

#endif
