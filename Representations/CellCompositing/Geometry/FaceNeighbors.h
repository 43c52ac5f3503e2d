// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which tetrahedra share faces.
 *
 * Faces are matched by the positions of their points (CoincidentPoints.h), not by point numbers:
 * blocks that repeat their boundary points fit together. Points and faces are thrown into buckets
 * and meet their equals there; each bucket is sorted, so that nothing depends on the order in which
 * threads filled it.
 */
#ifndef nephoscope_FaceNeighbors_h
#define nephoscope_FaceNeighbors_h

#include "CellGeometry.h"
#include "ProgressLoop.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

class FaceNeighbors
{
public:
  static constexpr std::int32_t None = -1;

  /** Returns false, without a result, if stopped. */
  bool Connect(const CellGeometry& geometry, const Progress& progress = {});
  bool IsConnected() const { return this->Connected; }

  /**
   * The tetrahedron across the face opposite a vertex (0 to 3), or None. A mesh that is folded at a
   * face, so that both tetrahedra lie on the same side of it by more than rounding, ends there.
   */
  std::int32_t Get(std::size_t tetrahedron, int face) const
  {
    return this->Neighbors[4 * tetrahedron + static_cast<std::size_t>(face)];
  }

  /** For each point the first of those that coincide. */
  const std::vector<std::int32_t>& GetPlaces() const { return this->Places; }

private:
  std::vector<std::int32_t> Neighbors; // 4 per tetrahedron
  std::vector<std::int32_t> Places;    // per point
  bool Connected = false;

  bool MatchFaces(const CellGeometry& geometry, const Progress& progress);
  bool UnfoldFaces(const CellGeometry& geometry, const Progress& progress);
};

/**
 * The result of FaceNeighbors::Get for some tetrahedra, across from one of their vertices (0 to 3).
 * It needs no list of neighbours, but tests all tetrahedra. `places`: those of all points
 * (GetPlaces()), or empty if none coincide.
 */
std::vector<std::int32_t> FindNeighborsAcross(const CellGeometry& geometry,
  const std::vector<std::int32_t>& places, const std::vector<std::size_t>& tetrahedra, int vertex);

/**
 * Bound on the rounding of a point's coordinates: half a unit in the last place of the largest,
 * twice.
 */
double FindCoordinateError(const CellGeometry& geometry);

/**
 * Side (-1, 0, 1) of the plane through a, b and c on which the homogeneous point e lies; 0 where
 * moving each point by `error` could turn the answer. That moves the determinant by at most three
 * times the error times the areas it multiplies. A direction has no error of its own.
 */
int PlaneSideWithin(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector4& e, double error);

} // namespace nephoscope

#endif
