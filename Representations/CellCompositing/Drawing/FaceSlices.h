// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Boundary faces sorted into slices of the view's depth.
 *
 * Where a ray enters the mesh a hundred times, the next of a hundred faces has to be found a
 * hundred times. Slice by slice from front to back, only the faces that reach into the slice are
 * tested, so that all layers together cost about as much as all faces.
 */
#ifndef nephoscope_FaceSlices_h
#define nephoscope_FaceSlices_h

#include "BoundaryFaces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class FaceSlices
{
public:
  struct Slice
  {
    float Low, High;          ///< depths: from Low on, up to but without High
    std::size_t First, Count; ///< in GetVertices()
  };

  /** The first `count` of the faces, which are copied. */
  void SetFaces(
    const CellGeometry& geometry, const std::vector<BoundaryFace>& faces, std::size_t count);

  /**
   * The depth of a point is toDepth . (x, y, z, 1), to within `error`. There are as many slices as
   * the faces allow: those that reach through several are listed in each.
   */
  void Sort(const std::array<double, 4>& toDepth, double error);

  /** Front to back. */
  const std::vector<Slice>& GetSlices() const { return this->Slices; }
  /** Corners of faces: 3 f + c for corner c of face f. */
  const std::vector<std::uint32_t>& GetVertices() const { return this->Vertices; }

private:
  struct Range
  {
    float Low, High;
  };
  using Ends = std::vector<float>;
  Ends FindEnds(std::size_t slices) const;
  static std::array<std::size_t, 2> Reach(const Ends& ends, const Range& range);
  std::size_t CountListed(const Ends& ends) const;

  std::vector<std::array<float, 9>> Corners; // of each face
  std::vector<Range> Ranges;
  std::vector<Slice> Slices;
  std::vector<std::uint32_t> Vertices;
};

} // namespace nephoscope

#endif
