// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The orders in which earlier methods project cells (MaxCrawfisBecker1993, section 2), back to
 * front. Rays need none.
 *
 * - Topological: across a shared face the tetrahedron on the eye's side of its plane is in front
 *   (Williams1992), and is drawn after the other. Correct for convex meshes in which no tetrahedra
 *   hide one another in a cycle. Gaps relate nothing: what they separate, and the members of a
 *   cycle, are roughly in the order of their centroids.
 * - Centroid: by the distance of the centroid from the eye.
 * - None: as stored, which is correct for a medium of one colour.
 */
#ifndef nephoscope_ProjectionOrder_h
#define nephoscope_ProjectionOrder_h

#include "FaceNeighbors.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

struct ProjectionOrder
{
  /** Numbered as vtkCellCompositingMapper::VisibilityOrderType. */
  enum class Kind
  {
    Topological,
    Centroid,
    None
  };

  /**
   * `faces` are needed, connected, by the topological order only. False, and empty, when stopped.
   */
  bool Sort(Kind kind, const CellGeometry& geometry, const FaceNeighbors& faces, const Vector4& eye,
    const Progress& progress = {});

  std::vector<std::int32_t> Tetrahedra; ///< back to front

  // Topological order: groups of tetrahedra each of which hides another and is hidden, their
  // members, and the relations across faces that are in the wrong order for this reason.
  std::int64_t NumberOfCycles = 0;
  std::int64_t NumberOfCyclicTetrahedra = 0;
  std::int64_t NumberOfBrokenRelations = 0;
};

} // namespace nephoscope

#endif
