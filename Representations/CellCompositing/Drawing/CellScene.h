// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The data that the mapper keeps between renders: geometry, transfer functions, surfaces,
 * neighbours for rays or an order for projection.
 *
 * Each stage is made again only when its sources changed: the geometry with the mesh, its values
 * with the arrays, the tables with the volume property. A counter that grows with each change
 * numbers the versions of all stages, so that a stage is out of date if a source has a greater
 * number, and the drawing pass knows what to upload.
 */
#ifndef nephoscope_CellScene_h
#define nephoscope_CellScene_h

#include "BoundaryFaces.h"
#include "CellGeometry.h"
#include "ContourScene.h"
#include "DataIdentity.h"
#include "EyeTetrahedron.h"
#include "FaceNeighbors.h"
#include "PolygonScene.h"
#include "ProjectionOrder.h"
#include "TetrahedronNeighbors.h"
#include "TransferFunctionTable.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataSet;
class vtkVolumeProperty;

namespace nephoscope
{

struct ContourSettings;

class CellScene
{
public:
  enum class Method
  {
    Projection, ///< cell by cell, in an order
    Rays        ///< pixel by pixel
  };
  /** Numbers of the last changes: a later one is greater. */
  struct Versions
  {
    std::int64_t Geometry = 0, Colors = 0, Opacities = 0, Topology = 0, Transfer = 0, Contours = 0,
                 Polygons = 0, Order = 0, Drawn = 0;
    /** The last change of what is uploaded: all but the order. */
    std::int64_t Latest() const
    {
      return std::max({ this->Geometry, this->Colors, this->Opacities, this->Topology,
        this->Transfer, this->Contours, this->Polygons, this->Drawn });
    }
  };

  /**
   * Returns true when the geometry was made again; `error` then gives the reason, or is empty. When
   * stopped, there is no geometry until the next time. If only values of the selected arrays have
   * changed, they are copied and nothing else is rebuilt.
   */
  bool UpdateGeometry(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, CellGeometry::Form form, std::string& error,
    vtkDataArray* layers = nullptr, const Progress& progress = {});
  void UpdateTransferFunction(vtkVolumeProperty* property);
  /**
   * The same with layers of their own properties, and contours of an array (none: the coloured
   * one).
   */
  void UpdateTransferFunction(vtkVolumeProperty* property, const ContourSettings& settings,
    vtkDataSet* data, const ScalarSelection& contoured);
  /**
   * Every visible part of the medium has one and the same colour; contours, and layers of another
   * colour, are not looked at.
   */
  bool HasOneColor() const { return this->ColorIsOne; }
  /**
   * How the cells will be drawn. Rays traverse a mesh through its neighbours: false if stopped
   * before these are known.
   */
  bool UpdateMethod(Method method, const Progress& progress = {});
  /**
   * For projection; `eye` is homogeneous and relative to the geometry's centre. False when stopped:
   * the order must not be drawn.
   */
  bool UpdateOrder(ProjectionOrder::Kind kind, const Vector4& eye, const Progress& progress = {});
  /** Lists the drawn cells; call it after the three others. */
  void UpdateDrawn();
  /** For rays; `eye` as above. */
  void UpdateEye(const Vector4& eye);
  /** Nothing is drawn until the geometry is updated again. */
  void Clear();

  const CellGeometry& GetGeometry() const { return this->Geometry; }
  /**
   * Call this before reading the geometry between renders. False if the input no longer has the
   * cells that the geometry reads from it.
   */
  bool RefreshGeometry(vtkDataSet* data) { return this->Geometry.Tetrahedra.Refresh(data); }
  /** Colour and opacity; colour alone where the geometry has opacity scalars. */
  const TransferFunctionTable& GetTransferFunction() const { return this->Transfers[0]; }
  /** Opacity, read by the opacity scalars of the geometry where it has them. */
  const TransferFunctionTable& GetOpacityFunction() const { return this->Opacities[0]; }
  ///@{
  /** The two above, and after them those of layers with a property of their own. */
  const std::vector<TransferFunctionTable>& GetTransferFunctions() const { return this->Transfers; }
  const std::vector<TransferFunctionTable>& GetOpacityFunctions() const { return this->Opacities; }
  /**
   * With this scale of the extinction, what is seen at all is opaque. The squares of optical depths
   * are still floats.
   */
  double GetOpaqueExtinctionScale() const;
  ///@}
  const ContourScene& GetContours() const { return this->Contours; }
  const PolygonScene& GetPolygons() const { return this->Polygons; }
  /**
   * Call it first: it selects what is drawn besides 3-D cells, which determines how these may be
   * drawn.
   */
  void ReadPolygons(vtkDataSet* data, const ContourSettings& settings)
  {
    this->Polygons.Read(data, settings);
  }
  /** To be called after the geometry was updated. */
  void UpdatePolygons(
    const ScalarSelection& scalars, const ContourSettings& settings, vtkVolumeProperty* property)
  {
    const std::int64_t before = this->Polygons.Version;
    this->Polygons.Update(this->Geometry, this->Current.Geometry, scalars, settings, property);
    this->Current.Polygons =
      this->Polygons.Version == before ? this->Current.Polygons : ++this->LastVersion;
  }
  /**
   * Number of the tables that each tetrahedron reads; empty where that does not depend on the
   * tetrahedron.
   */
  const std::vector<std::int32_t>& GetTablesOfTetrahedra() const
  {
    return this->TablesOfTetrahedra;
  }
  bool ContoursMakeLayers() const { return this->LayersOfContours; }
  /**
   * Frees the lists of neighbours after the upload, unless there are polygons, which need them.
   * RenewUploaded() lets UpdateMethod make the lists again for another upload.
   */
  void ReleaseUploaded();
  void RenewUploaded() { this->Current.Topology = this->Released ? 0 : this->Current.Topology; }
  /** Null for projection. */
  const TetrahedronNeighbors* GetNeighbors() const
  {
    return this->CurrentMethod == Method::Rays ? &this->Neighbors : nullptr;
  }
  /** For a grid: the cells that can be seen lie in it. */
  const CellBox& GetVisibleBox() const { return this->VisibleBox; }
  /**
   * 0: the cell can be seen. Otherwise from a cell of an evenly spaced grid to the next that can be
   * seen (ClearDistances.h); of other grids, and of hexahedra crossed whole, 1.
   */
  const std::vector<std::uint8_t>& GetClearDistances() const { return this->ClearDistances; }
  /** For rays: where they enter what can be seen. */
  const std::vector<BoundaryFace>& GetBoundaryFaces() const
  {
    return this->Geometry.Grid.IsEmpty() ? this->Neighbors.BoundaryFaces : this->GridBoundary;
  }
  const EyeTetrahedron& GetEyeTetrahedron() const { return this->Eye; }
  /** Tetrahedra that the transfer function lets be seen. */
  std::int64_t GetNumberOfVisible() const { return this->NumberOfVisible; }
  /** For projection: tetrahedra that can be seen, back to front. */
  const std::vector<std::int32_t>& GetDrawn() const { return this->Drawn; }
  /** For projection: the order of all tetrahedra, and its cycles. Empty with rays. */
  const ProjectionOrder& GetOrder() const { return this->Order; }

  const Versions& GetVersions() const { return this->Current; }

private:
  void Change(std::int64_t& version) { version = ++this->LastVersion; }
  bool UpdateValues(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, bool ofColor, bool ofOpacity);
  void ListDrawn();
  void FindVisible();
  bool IsVisible(std::size_t tetrahedron) const;
  void FindVisibleOfGrid();
  void FindVisibleHexahedra();
  bool IsClearHexahedron(std::size_t cell) const;
  int CountVisibleParts(std::size_t cell) const;
  void BuildTables(const std::vector<vtkVolumeProperty*>& properties);
  void FindTablesOfTetrahedra(const std::vector<int>& layers);
  using VertexNumbersOf = std::array<std::int64_t, 4>;
  bool IsTransparent(
    std::size_t number, const VertexNumbersOf& vertices, float low, float high) const;
  std::pair<float, float> ContourRange(std::size_t number, const VertexNumbersOf& vertices) const;

  Method CurrentMethod = Method::Projection;
  CellGeometry Geometry;
  TetrahedronNeighbors Neighbors;
  EyeTetrahedron Eye;
  CellBox VisibleBox;
  std::vector<std::uint8_t> ClearDistances;
  std::vector<BoundaryFace> GridBoundary;
  std::int64_t NumberOfVisible = 0;
  std::vector<TransferFunctionTable> Transfers = std::vector<TransferFunctionTable>(1);
  std::vector<TransferFunctionTable> Opacities = std::vector<TransferFunctionTable>(1);
  std::vector<std::int32_t> TablesOfTetrahedra;
  ContourScene Contours;
  PolygonScene Polygons;
  bool LayersOfContours = false;
  bool ColorIsOne = false;
  FaceNeighbors Faces; // until rays have their own neighbours, or for the topological order
  ProjectionOrder Order;
  bool Released = false;             // the lists of neighbours have been freed
  std::vector<std::uint8_t> Visible; // for projection, per tetrahedron: not fully transparent
  std::vector<std::int32_t> Drawn;
  Versions Current;
  std::int64_t LastVersion = 0;

  // What the stages were made from. Pointers are compared only.
  MeshIdentity Mesh;
  ValueIdentity ColorValues, OpacityValues, LayerValues, ContouredValues;
  std::int64_t ContouredVersion = 0, VisibleVersion = 0;
  std::int64_t FieldOfTopology = 0; // version of the contoured field
  ProjectionOrder::Kind OrderKind = ProjectionOrder::Kind::None;
  Vector4 EyeOfOrder = { { 0, 0, 0, 0 } }, EyeOfRays = { { 0, 0, 0, 0 } };
  std::int64_t EyeVersion = 0;
  /** A volume property, as it was when its tables were made. */
  struct TableSource
  {
    int Layer;
    const vtkVolumeProperty* Property;
    vtkMTimeType Time;
    bool operator==(const TableSource& other) const
    {
      return this->Layer == other.Layer && this->Property == other.Property &&
        this->Time == other.Time;
    }
  };
  std::vector<TableSource> TableSources;
  std::array<double, 5>
    TableRanges = {}; // of the colour's scalars, of the opacity's, and whether there are any
};

} // namespace nephoscope

#endif
