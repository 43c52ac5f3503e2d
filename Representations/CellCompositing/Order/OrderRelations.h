// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** For one view: what lies directly behind each tetrahedron. */
#ifndef OrderRelations_h
#define OrderRelations_h

#include "FaceNeighbors.h"
#include "OrderView.h"
#include "ReentryRelations.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class OrderRelations
{
public:
  OrderRelations(const CellGeometry& geometry, const FaceNeighbors& faces)
    : Geometry(geometry)
    , Faces(faces)
  {
  }

  /** False when stopped. */
  bool Find(const OrderView& view, const Progress& progress);

  /**
   * The next tetrahedron behind this one, or -1. `cursor` starts at 0; `opposite` becomes the vertex opposite the face through
   * which the other is seen.
   */
  std::int32_t Next(std::int32_t tetrahedron, std::int32_t& cursor, std::int32_t& opposite) const
  {
    const std::uint8_t flags = this->Flags[static_cast<std::size_t>(tetrahedron)];
    while (cursor < 4)
    {
      opposite = cursor++;
      if ((flags >> opposite) & 1)
      {
        return this->Faces.Get(static_cast<std::size_t>(tetrahedron), opposite);
      }
    }
    return flags & hasReentries ? this->NextReentry(tetrahedron, cursor, opposite) : -1;
  }

private:
  static constexpr std::uint8_t hasReentries = 16;

  const CellGeometry& Geometry;
  const FaceNeighbors& Faces;
  std::vector<std::uint8_t> Flags; // per tetrahedron, bit k: what is across face k is behind it
  std::vector<ReentryRelation> Reentries;

  std::uint8_t FlagsOf(std::size_t tetrahedron, const Vector4& eye) const;
  std::int32_t NextReentry(
    std::int32_t tetrahedron, std::int32_t& cursor, std::int32_t& opposite) const;
};

} // namespace nephoscope

#endif
