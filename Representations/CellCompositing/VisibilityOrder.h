// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Back-to-front order of tetrahedra.
 *
 * Across a shared face the tetrahedron on the eye's side of its plane is in front (Williams1992). A depth-first search
 * over these relations, started from the farthest centroids, draws everything behind a tetrahedron before it. The order
 * is exact for convex acyclic meshes. Relations that close a cycle cannot be honoured; they are counted. A face whose plane
 * contains the eye to within the rounding of the coordinates relates nothing: its two cells do not overlap in the picture.
 *
 * Which tetrahedra share faces, and on which side of each face they lie, is found once per mesh (Connect). Faces are
 * matched by coordinates, not by point numbers: blocks that repeat their boundary points fit together.
 */
#ifndef VisibilityOrder_h
#define VisibilityOrder_h

#include "CellGeometry.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

class VisibilityOrder
{
public:
  /** Finds the neighbours across faces; needed by SortExact only. */
  void Connect(const CellGeometry& geometry);
  void Clear();
  bool IsConnected() const { return this->Connected; }

  /**
   * Tetrahedra from back to front for the homogeneous eye (x, y, z, 1), or (direction towards the eye, 0), relative to the
   * geometry's centre. Returns the number of face relations that the order breaks: 0 unless the mesh is cyclic.
   */
  std::int64_t SortExact(
    const CellGeometry& geometry, const Vector4& eye, std::vector<std::int32_t>& order) const;

  /** Tetrahedra by distance of the centroid, farthest first; equal ones in input order. */
  static void SortCentroids(
    const CellGeometry& geometry, const Vector4& eye, std::vector<std::int32_t>& order);

  /** Input order. */
  static void SortNone(const CellGeometry& geometry, std::vector<std::int32_t>& order);

  std::int64_t GetNumberOfInteriorFaces() const;
  /** The tetrahedron across the face opposite a vertex, or -1. Valid once connected. */
  std::int32_t GetNeighbor(std::size_t tetrahedron, int face) const { return this->Neighbors[4 * tetrahedron + face]; }

  // For others that go from neighbour to neighbour, once connected.
  /** First of the points at the same place. */
  std::int32_t CanonicalPoint(std::int32_t point) const
  {
    return this->CanonicalPoints[static_cast<std::size_t>(point)];
  }
  /** The tetrahedron across a face, unless both lie on the same side of it; -1: none. */
  std::int32_t UnfoldedNeighbor(std::size_t tetrahedron, int face) const
  {
    const std::size_t slot = 4 * tetrahedron + static_cast<std::size_t>(face);
    return this->Sides[slot] != 0 ? this->Neighbors[slot] : -1;
  }

private:
  // Per tetrahedron and face: the neighbour (-1: none) and the side of the face's plane, seen with the vertices in
  // canonical order, on which the tetrahedron lies (-1, 1, opposite for the
  // neighbour; 0 where the mesh is folded).
  std::vector<std::int32_t> Neighbors;
  std::vector<std::int8_t> Sides;
  std::vector<std::int32_t> CanonicalPoints; // first of the points at the same place
  double CoordinateError = 0; // bound on the rounding of a point's coordinates
  bool Connected = false;

  void MergePoints(const CellGeometry& geometry);
  void MatchFaces(const CellGeometry& geometry);
  void OrientFaces(const CellGeometry& geometry);
  int FarVertexSide(
    const CellGeometry& geometry, const std::array<std::int32_t, 3>& face, const Tetrahedron& t) const;
  int EyeSide(const CellGeometry& geometry, const std::array<std::int32_t, 3>& face, const Vector4& eye) const;
  std::array<std::int32_t, 3> CanonicalFace(const Tetrahedron& t, int face) const;
  void FindRelations(
    const CellGeometry& geometry, const Vector4& eye, std::vector<std::int32_t>& behind) const;
};

} // namespace nephoscope

#endif
