// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Back-to-front order of tetrahedra.
 *
 * Across a shared face the tetrahedron on the eye's side of its plane is in front (Williams1992). Where a ray leaves the mesh and
 * enters it again, the two ends of the gap are related too (ReentryRelations.h), at the pixels of the picture; a convex mesh needs
 * none of that. Drawing everything behind a tetrahedron before it gives a correct order for every mesh without cycles,
 * whatever its shape.
 *
 * Tetrahedra that hide one another in a cycle have no order. They are cut until their pieces have one (CycleSplitter.h), and
 * counted.
 *
 * A face whose plane contains the eye to within the rounding of the coordinates relates nothing: its two cells do not overlap in
 * the picture. Neighbours are found once per mesh (Connect).
 */
#ifndef VisibilityOrder_h
#define VisibilityOrder_h

#include "CellPieces.h"
#include "CycleSplitter.h"
#include "FaceNeighbors.h"
#include "OrderView.h"
#include "ReentryRelations.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class VisibilityOrder
{
public:
  /** Finds the neighbours across faces; needed by SortExact only. False when stopped. */
  bool Connect(const CellGeometry& geometry, const Progress& progress = {});
  void Clear() { *this = VisibilityOrder(); }
  bool IsConnected() const { return this->Faces.IsConnected(); }
  const FaceNeighbors& GetFaces() const { return this->Faces; }

  // For others that go from neighbour to neighbour, once connected.
  /** The first of the coincident points. */
  std::int32_t CanonicalPoint(std::int32_t point) const { return this->Faces.GetPlace(point); }
  /** The tetrahedron across a face, unless both lie on the same side of it by more than rounding; -1: none. */
  std::int32_t UnfoldedNeighbor(std::size_t tetrahedron, int face) const
  {
    return std::max<std::int32_t>(this->Faces.GetWithinRounding(tetrahedron, face), -1);
  }

  struct Sorted
  {
    std::vector<std::int32_t>
      Order; ///< back to front; numbers from the number of tetrahedra on are those of pieces
    CellPieces Pieces;
    std::int64_t NumberOfCycles = 0; ///< groups in which each tetrahedron hides and is hidden
    std::int64_t NumberOfCyclicTetrahedra = 0; ///< their members
    std::int64_t NumberOfBrokenRelations =
      0; ///< what is drawn in the wrong order, because pieces would be too many
  };
  static constexpr std::size_t maximumPieces = std::size_t(1) << 20;

  /** The exact order. False, and nothing, when stopped. */
  bool SortExact(const CellGeometry& geometry, const OrderView& view, Sorted& sorted,
    const Progress& progress = {}, std::size_t mostPieces = maximumPieces) const;

  /** Tetrahedra by distance of the centroid, farthest first; equal ones in input order. False when stopped. */
  static bool SortCentroids(const CellGeometry& geometry, const Vector4& eye,
    std::vector<std::int32_t>& order, const Progress& progress = {});

  /** Input order. */
  static void SortNone(const CellGeometry& geometry, std::vector<std::int32_t>& order);

private:
  FaceNeighbors Faces;
};

} // namespace nephoscope

#endif
