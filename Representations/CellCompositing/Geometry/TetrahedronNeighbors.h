// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh of tetrahedra as a ray walks through it: 20 bytes per tetrahedron (in the manner of AmanDemirciGudukbay2021).
 *
 * A walk knows three vertices of the tetrahedron that it enters; the exclusive-or of the four gives the fourth. The neighbours stand
 * in the order of the vertices that they do not have, by ascending number, so that which of them lies ahead follows from the number
 * of the vertex left behind. Faces without a neighbour are the boundary, where rays enter.
 */
#ifndef TetrahedronNeighbors_h
#define TetrahedronNeighbors_h

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class CellGeometry;
class VisibilityOrder;

struct TetrahedronNeighbors
{
  std::vector<std::int32_t> Neighbors;  ///< four per tetrahedron; -1: none
  std::vector<std::int32_t> VertexSums; ///< exclusive-or of the four vertex numbers
  std::vector<std::array<std::int32_t, 4>> BoundaryFaces; ///< three vertices, seen counterclockwise from outside, and the tetrahedron

  std::vector<std::int32_t> MergedPoints; ///< number that stands for each point
  bool DependOnValues = false; ///< there are points at the same place, which are merged where their values are equal

  std::int32_t Merged(std::int64_t point) const { return this->MergedPoints[static_cast<std::size_t>(point)]; }

  /**
   * Points that coincide and have equal scalars become one. `connected` knows the neighbours by place; where values jump between
   * two blocks, or the mesh is folded, the ray leaves the one tetrahedron and enters the other anew.
   */
  void Build(const CellGeometry& geometry, const VisibilityOrder& connected);
  void Clear();
};

} // namespace nephoscope

#endif
