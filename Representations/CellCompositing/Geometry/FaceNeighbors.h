// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which tetrahedra share faces, and the properties of the mesh's surface.
 *
 * Faces are matched by the positions of their points (CoincidentPoints.h), not by point numbers: blocks that repeat their boundary
 * points fit together. Points and faces are thrown into buckets and meet their equals there; each bucket is sorted, so that nothing
 * depends on the order in which threads filled it.
 */
#ifndef FaceNeighbors_h
#define FaceNeighbors_h

#include "CellGeometry.h"
#include "ProgressLoop.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class FaceNeighbors
{
public:
  enum : std::int32_t
  {
    None = -1, ///< the face is on the boundary
    Folded =
      -2 ///< the tetrahedron across the face lies on the same side of it: neither is in front
  };

  /** Returns false, without a result, if stopped. */
  bool Connect(const CellGeometry& geometry, const Progress& progress = {});
  bool IsConnected() const { return this->Connected; }

  /** Across the face opposite a vertex (0 to 3): a tetrahedron, None or Folded. */
  std::int32_t Get(std::size_t tetrahedron, int face) const
  {
    return std::max<std::int32_t>(
      this->Neighbors[4 * tetrahedron + static_cast<std::size_t>(face)], Folded);
  }
  /** The same for algorithms that go from face to face and do not use sides: a fold within rounding error counts as none. */
  std::int32_t GetWithinRounding(std::size_t tetrahedron, int face) const
  {
    const std::int32_t stored = this->Neighbors[4 * tetrahedron + static_cast<std::size_t>(face)];
    return stored < Folded ? foldCode(stored) : stored;
  }

  /** The first of the coincident points. */
  std::int32_t GetPlace(std::int32_t point) const
  {
    return this->Places[static_cast<std::size_t>(point)];
  }

  struct Face
  {
    std::int32_t Tetrahedron;
    std::int32_t Opposite; ///< the vertex (0 to 3) that is not in the face
  };
  /** Faces without a neighbour. */
  const std::vector<Face>& GetBoundary() const { return this->Boundary; }
  /** A ray cannot leave the mesh and come back, except through rounding of coordinates. */
  bool IsConvex() const { return this->Convex; }
  /** Bound on the rounding of a point's coordinates. */
  double GetCoordinateError() const { return this->CoordinateError; }

  std::int64_t GetNumberOfInteriorFaces() const;

private:
  // A tetrahedron across a fold that rounding could make is kept as a number below Folded; the same function takes it back.
  static std::int32_t foldCode(std::int32_t tetrahedron) { return Folded - 1 - tetrahedron; }

  std::vector<std::int32_t> Neighbors; // 4 per tetrahedron
  std::vector<std::int32_t> Places;    // per point
  std::vector<Face> Boundary;
  double CoordinateError = 0;
  bool Convex = false;
  bool Connected = false;

  bool MatchFaces(const CellGeometry& geometry, const Progress& progress);
  bool FindFolds(const CellGeometry& geometry, const Progress& progress);
  std::int32_t FindFold(const CellGeometry& geometry, std::size_t tetrahedron, int face) const;
};

/** Bound on the rounding of a point's coordinates: half a unit in the last place of the largest, twice. */
double findCoordinateError(const CellGeometry& geometry);

/**
 * Side (-1, 0, 1) of the plane through a, b and c on which the homogeneous point e lies; 0 where moving each point by `error`
 * could turn the answer. That moves the determinant by at most three times the error times the areas it multiplies. A direction
 * has no error of its own.
 */
int planeSideWithin(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector4& e, double error);

} // namespace nephoscope

#endif
