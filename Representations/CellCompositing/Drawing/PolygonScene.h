// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The polygons of the input that lie in faces of its cells, ready for the shaders: for each
 * tetrahedron the surfaces in its faces, for each surface its colour and its normals. All is made
 * again only when its source changed.
 */
#ifndef nephoscope_PolygonScene_h
#define nephoscope_PolygonScene_h

#include "CellPolygons.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

class vtkDataSet;
class vtkVolumeProperty;

namespace nephoscope
{

struct ContourSettings;
struct TetrahedronNeighbors;

class PolygonScene
{
public:
  /** Four texels of the shaders' buffer. */
  struct Surface
  {
    std::array<float, 4>
      Color; ///< and opacity; red < 0: of the colour function where the surface is
    std::array<std::array<float, 4>, 3>
      Normals; ///< at the corners, ascending by their number in the tetrahedron; model coordinates
  };

  /**
   * Finds the polygons selected by the settings; call it before geometry and drawing method are
   * chosen.
   */
  void Read(vtkDataSet* data, const ContourSettings& settings);
  /** To be called after the geometry was built. `scalars` are those of colour. */
  void Update(const CellGeometry& geometry, std::int64_t geometryVersion,
    const ScalarSelection& scalars, const ContourSettings& settings, vtkVolumeProperty* property);

  /** Some polygon that was found is not transparent. */
  bool IsUsed() const { return this->Used; }
  /** The tetrahedron has a surface that can be seen. */
  bool HasSurface(std::size_t tetrahedron) const
  {
    return !this->OfTetrahedra.empty() &&
      this->OfTetrahedra[tetrahedron] != std::array<std::int32_t, 4>{ { 0, 0, 0, 0 } };
  }
  const CellPolygons& GetPolygons() const { return this->Polygons; }

  /**
   * Per tetrahedron and face, named by the vertex opposite: number of its surface, counted from 1;
   * 0: none.
   */
  std::vector<std::array<std::int32_t, 4>> OfTetrahedra;
  std::vector<Surface> Surfaces;
  std::int64_t Version = 0; ///< grows whenever one of the two changed

  /**
   * The two for rays: vertices ascend by their merged numbers, and both tetrahedra of a face have
   * its surface.
   */
  void ListForRays(const CellGeometry& geometry, const TetrahedronNeighbors& neighbors,
    std::vector<std::array<std::int32_t, 4>>& ofTetrahedra, std::vector<Surface>& surfaces) const;

private:
  std::array<float, 4> ColorOf(const CellPolygons::Triangle& triangle,
    const ScalarSelection& scalars, const ContourSettings& settings,
    vtkVolumeProperty* property) const;
  std::vector<double> DescribeLook(std::int64_t geometryVersion, const ScalarSelection& scalars,
    const ContourSettings& settings, vtkVolumeProperty* property) const;
  void FindFaces(const CellGeometry& geometry, std::int64_t geometryVersion, bool smooth);

  CellPolygons Polygons;
  bool Used = false;
  std::vector<CellPolygons::Face> Faces;
  std::vector<std::array<Vector3, 3>> Normals; // of triangles

  std::tuple<vtkDataSet*, vtkMTimeType, CellPolygons::Which> ReadKey;
  std::int64_t ReadVersion = 0;
  std::tuple<std::int64_t, std::int64_t, bool> FacesKey;
  std::vector<double> LookKey; // of colours and opacities; empty: nothing is drawn
};

} // namespace nephoscope

#endif
