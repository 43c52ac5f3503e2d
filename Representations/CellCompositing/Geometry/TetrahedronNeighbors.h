// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh of tetrahedra as a ray walks through it (in the manner of AmanDemirciGudukbay2021): 16
 * bytes per tetrahedron on the GPU, and 20 here until the upload.
 *
 * A walk has three vertices of the tetrahedron that it enters; the exclusive-or of all four gives
 * the fourth. The neighbours stand in the order of the vertices that they do not have, by ascending
 * number, so that which of them lies ahead follows from the number of the vertex left behind. A
 * walk knows the neighbour that it comes from; exclusive-ors of two neighbours give the others.
 * Faces without a neighbour are the boundary, where rays enter.
 *
 * Coincident points (CoincidentPoints.h) with equal values become one point. Where values jump
 * between coincident points, each side keeps its own values and its own face: a ray that leaves
 * through one face continues from the other.
 */
#ifndef nephoscope_TetrahedronNeighbors_h
#define nephoscope_TetrahedronNeighbors_h

#include "CellGeometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class FaceNeighbors;

struct TetrahedronNeighbors
{
  enum : std::int32_t
  {
    None = -1,
    Jump = -2 ///< minus n: the ray goes on from the other tetrahedron's boundary face, n or n + 1
  };
  /**
   * Four per tetrahedron: a tetrahedron, None, or Jump - n. Six per hexahedron:
   * HexahedronNeighbors.h.
   */
  std::vector<std::int32_t> Neighbors;
  std::vector<std::int32_t> VertexSums; ///< exclusive-or of the four vertex numbers
  /**
   * Three vertices, seen counterclockwise from outside, and where a walk begins: the tetrahedron;
   * eight times the hexahedron plus its face; or for a divided hexahedron four times (eight times
   * its number plus the odd corner, the first of the three) plus the axis of the face.
   * Faces where rays enter come first, then those where values jump, with the two sides of a face
   * next to each other. Faces without extent are left out: those whose height is below the rounding
   * of their coordinates, and whose length is a million times larger.
   */
  std::vector<std::array<std::int32_t, 4>> BoundaryFaces;
  std::size_t NumberOfJumps = 0; ///< at the end of them

  /** The number that stands for each point; empty where none is at the place of another. */
  std::vector<std::int32_t> MergedPoints;
  /**
   * For each point the first point at the same place, whatever the values are; empty if no points
   * coincide.
   */
  std::vector<std::int32_t> Places;
  bool DependOnValues =
    false; ///< there are points at the same place, which are merged where their values are equal

  std::int32_t Merged(std::int64_t point) const
  {
    return this->MergedPoints.empty() ? static_cast<std::int32_t>(point)
                                      : this->MergedPoints[static_cast<std::size_t>(point)];
  }

  /**
   * `third`: more values of points, or none. Where the mesh is folded, the ray leaves the one
   * tetrahedron and enters the other anew.
   */
  void Build(
    const CellGeometry& geometry, const FaceNeighbors& faces, const std::vector<float>& third = {});
  void Clear();
  /**
   * Finds MergedPoints: points at one of `places` (CoincidentPoints.h) with equal values become the
   * first of them. `third`: as above.
   */
  void MergePoints(const CellGeometry& geometry, const std::vector<std::int32_t>& places,
    const std::vector<float>& third);
  /** The same, whatever the values are. */
  void MergePlaces(const std::vector<std::int32_t>& places);
  /** Tetrahedra, or boundary faces, that Links can number. */
  static constexpr std::size_t Most = (std::size_t(1) << 29) - 2;
  /**
   * What the GPU has of each tetrahedron (NeighborTopology.glsl): the exclusive-or of its vertices,
   * and those of its last neighbour with each of the others. Each neighbour includes the rank that
   * the vertex behind the face has in it.
   */
  std::vector<std::array<std::int32_t, 4>> Links(const CellGeometry& geometry) const;
  /**
   * The face from which a ray goes on after it leaves a tetrahedron through a face where values
   * jump; `link`: Jump - n.
   */
  const std::array<std::int32_t, 4>& FaceAcross(std::int32_t link, std::int32_t tetrahedron) const
  {
    const std::size_t first = static_cast<std::size_t>(Jump - link);
    return this->BoundaryFaces[this->BoundaryFaces[first][3] == tetrahedron ? first + 1 : first];
  }
  /** Frees the lists of neighbours, which are no longer needed when the GPU has them. */
  void ReleaseNeighbors();
  /**
   * For each of the given tetrahedra, one neighbour in the form of Links, and the rank of the
   * vertex across from it. Tests all tetrahedra once, and reads no list of neighbours.
   */
  std::vector<std::array<std::int32_t, 2>> FindOneNeighbor(
    const CellGeometry& geometry, const std::vector<std::size_t>& tetrahedra) const;

private:
  void FindNeighbors(const CellGeometry& geometry, const FaceNeighbors& faces);
  void ListBoundary(const CellGeometry& geometry);
  Tetrahedron MergedVertices(const CellGeometry& geometry, std::size_t tetrahedron) const;
  std::int32_t Packed(
    const CellGeometry& geometry, const Tetrahedron& t, int vertex, std::int32_t neighbor) const;
  std::int32_t Linked(const CellGeometry& geometry, const Tetrahedron& vertices,
    std::int32_t neighbor, int face) const;
  std::int32_t FindJump(const Tetrahedron& t, std::int32_t tetrahedron, int face) const;
};

} // namespace nephoscope

#endif
