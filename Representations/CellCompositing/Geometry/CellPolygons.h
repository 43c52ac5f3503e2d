// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The polygons of an unstructured grid, as triangles: surfaces that lie in faces of its 3-D cells,
 * such as vtkContourCellSplitter adds to the pieces of cells.
 *
 * A polygon is divided as the faces of cells are, as a fan from its least vertex
 * (CellDecomposition.h), so that its triangles are faces of tetrahedra. Each belongs to one
 * tetrahedron that has it as a face, the larger one: the other may be too flat to be drawn. Nothing
 * lies between this tetrahedron and the surface. Drawing the surface directly before or after the
 * tetrahedron is therefore correct in any correct order of tetrahedra.
 */
#ifndef nephoscope_CellPolygons_h
#define nephoscope_CellPolygons_h

#include "CellGeometry.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

struct CellPolygons
{
  struct Triangle
  {
    std::array<std::int32_t, 3> Points;
    std::int32_t Contour; ///< ContourIndex of its polygon, 0 without this array
    vtkIdType Cell;       ///< its polygon
  };
  std::vector<Triangle> Triangles;
  std::int64_t NumberOfPolygons = 0; ///< in the data
  std::int64_t NumberOfOthers = 0;   ///< polygons that were not asked for

  enum class Which
  {
    None,
    Contours, ///< those with a ContourIndex of 0 or more
    All
  };
  /** What ghost flags hide is left out. */
  static CellPolygons Read(vtkDataSet* data, Which which);

  /** A triangle as a face of a tetrahedron. */
  struct Face
  {
    std::int32_t Tetrahedron;
    std::int32_t Opposite; ///< the vertex (0 to 3) that is not in the face
    std::int32_t Triangle;
  };
  /**
   * Faces match if their points have the same positions. Where several triangles lie at one face,
   * the first counts.
   */
  std::vector<Face> Match(const CellGeometry& geometry, const std::vector<std::int32_t>& places);
  std::int64_t NumberApart = 0; ///< polygons of which Match found a part in no face

  /**
   * Normals at each triangle's corners: mean over the triangles of one contour that meet there,
   * with any length and sign.
   */
  std::vector<std::array<Vector3, 3>> Normals(
    const CellGeometry& geometry, const std::vector<std::int32_t>& places, bool smooth) const;
};

} // namespace nephoscope

#endif
