// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The faces of tetrahedra, each once, with the tetrahedra on its two sides. */
#ifndef nephoscope_FaceMesh_h
#define nephoscope_FaceMesh_h

#include "CellGeometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

struct MeshFace
{
  std::array<std::int32_t, 3> Points; ///< counterclockwise seen from outside the first tetrahedron
  std::int32_t First;                 ///< a tetrahedron that has this face
  std::int32_t Second;                ///< the one on the other side, or -1
  /**
   * The same places as points of the second: others where blocks repeat their points, whose values
   * may jump there.
   */
  std::array<std::int32_t, 3> SecondPoints;
};

class FaceMesh
{
public:
  /** Faces match where their points have the same coordinates (FaceNeighbors.h). */
  void Build(const CellGeometry& geometry);
  const std::vector<MeshFace>& GetFaces() const { return this->Faces; }

private:
  std::vector<MeshFace> Faces;
};

} // namespace nephoscope

#endif
