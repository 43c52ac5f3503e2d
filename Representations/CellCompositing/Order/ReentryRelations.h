// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Who is in front of whom where rays leave a mesh and enter it again.
 *
 * The tetrahedra along a ray are related across the faces that they share, but where the ray leaves the mesh through a
 * boundary face and comes back through another, nothing relates the two sides of the gap. XMPVO (SilvaMitchellWilliams1998)
 * finds the missing relations by sweeping; here the boundary faces are scan-converted at the pixels of the picture, and
 * the crossings of each pixel's ray are sorted by depth. Tetrahedra on the ray of a pixel centre are related exactly;
 * tetrahedra that no ray meets need no relation.
 *
 * A pixel centre on an edge belongs to one of the faces that meet there, so that crossings alternate: in, out, in, out.
 */
#ifndef ReentryRelations_h
#define ReentryRelations_h

#include "FaceNeighbors.h"
#include "OrderView.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace nephoscope
{

/** A ray leaves `Front` through its face opposite vertex `Opposite`, and next enters `Behind`. */
struct ReentryRelation
{
  std::int32_t Front;
  std::int32_t Opposite;
  std::int32_t Behind;
  bool operator<(const ReentryRelation& other) const
  {
    return std::tie(this->Front, this->Opposite, this->Behind) <
      std::tie(other.Front, other.Opposite, other.Behind);
  }
  bool operator==(const ReentryRelation& other) const
  {
    return this->Front == other.Front && this->Opposite == other.Opposite &&
      this->Behind == other.Behind;
  }
};

/** Sorted, each once. False when stopped. */
bool findReentryRelations(const CellGeometry& geometry,
  const std::vector<FaceNeighbors::Face>& boundary, const OrderView& view,
  std::vector<ReentryRelation>& relations, const Progress& progress = {});

} // namespace nephoscope

#endif
