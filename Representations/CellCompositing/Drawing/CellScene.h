// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The data that the mapper keeps between renders: geometry, transfer function, order, and the list of drawn cells.
 *
 * Each stage records its sources and is rebuilt only when they change: the geometry with the mesh, its values with the
 * arrays, the transfer table with the volume property, the order with the geometry and the place of the eye. The version of a stage
 * increases whenever it is rebuilt, so that the drawing pass knows what to upload.
 */
#ifndef CellScene_h
#define CellScene_h

#include "BoundaryFaces.h"
#include "CellGeometry.h"
#include "ContourScene.h"
#include "DataIdentity.h"
#include "EyeTetrahedron.h"
#include "PolygonScene.h"
#include "TetrahedronNeighbors.h"
#include "TransferFunctionTable.h"
#include "VisibilityOrder.h"

#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
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
    Projection, ///< cell by cell, in visibility order
    Rays        ///< pixel by pixel
  };
  enum class OrderMethod
  {
    Exact,
    Centroid,
    None
  };
  struct Versions
  {
    std::int64_t Geometry = 0, Colors = 0, Opacities = 0, Topology = 0, Transfer = 0, Order = 0,
                 Pieces = 0, Drawn = 0;
    bool operator!=(const Versions& other) const
    {
      return this->UploadedParts() != other.UploadedParts();
    }

  private:
    std::array<std::int64_t, 7> UploadedParts() const // all but the order
    {
      return { { this->Geometry, this->Colors, this->Opacities, this->Topology, this->Transfer,
        this->Pieces, this->Drawn } };
    }
  };

  /**
   * Returns true when the geometry was made again; `error` then gives the reason, or is empty. When stopped, there is
   * no geometry until the next time. If only values of the selected arrays have changed, they are copied and nothing else is rebuilt.
   */
  bool UpdateGeometry(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, CellGeometry::Form form, std::string& error,
    vtkDataArray* layers = nullptr, const Progress& progress = {});
  void UpdateTransferFunction(vtkVolumeProperty* property);
  /** The same with layers of their own properties, and contours of an array (none: the coloured one). */
  void UpdateTransferFunction(vtkVolumeProperty* property, const ContourSettings& settings,
    vtkDataSet* data, const ScalarSelection& contoured);
  /** Every visible part of the medium has one and the same colour; contours, and layers of another colour, are not looked at. */
  bool HasOneColor() const { return this->ColorIsOne; }
  /** How the cells will be drawn. Rays traverse a mesh through its neighbours: false if stopped before these are known. */
  bool UpdateMethod(Method method, const Progress& progress = {});
  /** From where the scene is seen; what follows the view is made by UpdateOrder and CountCycles. */
  void UpdateView(const OrderView& view) { this->View = view; }
  /** For projection. False when stopped: the order is made the next time, and must not be drawn before. */
  bool UpdateOrder(OrderMethod method, const Progress& progress = {});
  /** Lists the drawn cells; call it after the three others. */
  void UpdateDrawn();
  /** For rays; `eye` is homogeneous and relative to the geometry's centre. */
  void UpdateEye(const Vector4& eye);
  /** Nothing is drawn until the geometry is updated again. */
  void Clear();

  const CellGeometry& GetGeometry() const { return this->Geometry; }
  /** Colour and opacity; colour alone where the geometry has opacity scalars. */
  const TransferFunctionTable& GetTransferFunction() const { return this->Transfers[0]; }
  /** Opacity, read by the opacity scalars of the geometry where it has them. */
  const TransferFunctionTable& GetOpacityFunction() const { return this->Opacities[0]; }
  ///@{
  /** The two above, and after them those of layers with a property of their own. */
  const std::vector<TransferFunctionTable>& GetTransferFunctions() const { return this->Transfers; }
  const std::vector<TransferFunctionTable>& GetOpacityFunctions() const { return this->Opacities; }
  ///@}
  const ContourScene& GetContours() const { return this->Contours; }
  const PolygonScene& GetPolygons() const { return this->Polygons; }
  /** Call it first: it selects what is drawn besides 3-D cells, which determines how these may be drawn. */
  void ReadPolygons(vtkDataSet* data, const ContourSettings& settings)
  {
    this->Polygons.Read(data, settings);
  }
  /** To be called after the geometry was updated. */
  void UpdatePolygons(
    const ScalarSelection& scalars, const ContourSettings& settings, vtkVolumeProperty* property)
  {
    this->Polygons.Update(this->Geometry, this->Current.Geometry, scalars, settings, property);
  }
  /** Number of the tables that each tetrahedron reads; empty where that does not depend on the tetrahedron. */
  const std::vector<std::int32_t>& GetTablesOfTetrahedra() const
  {
    return this->TablesOfTetrahedra;
  }
  bool ContoursMakeLayers() const { return this->LayersOfContours; }
  /** Null for projection. */
  const TetrahedronNeighbors* GetNeighbors() const
  {
    return this->CurrentMethod == Method::Rays ? &this->Neighbors : nullptr;
  }
  /** For a grid: the cells that can be seen lie in it. */
  const CellBox& GetVisibleBox() const { return this->VisibleBox; }
  /** From each cell of an evenly spaced grid to the next that can be seen (ClearDistances.h). */
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
  /** Pieces of tetrahedra, numbered on from the geometry's, that the order may contain. */
  const CellPieces& GetPieces() const { return this->Sorted.Pieces; }

  struct Cycles
  {
    std::int64_t Number = 0, Tetrahedra = 0, BrokenRelations = 0;
  };
  /**
   * Cycles of the last view; sorts exactly if that was not done, so that no drawing method need have an order.
   * `makeTetrahedra` gives the geometry where this one is a grid, which lists none.
   */
  Cycles CountCycles(const std::function<CellGeometry()>& makeTetrahedra);

  const Versions& GetVersions() const { return this->Current; }

private:
  using SortKey = std::tuple<std::int64_t, OrderMethod, OrderView>;
  bool Sort(OrderMethod method, VisibilityOrder::Sorted& sorted, const Progress& progress);
  void Count(const VisibilityOrder::Sorted& sorted);
  SortKey KeyOf(OrderMethod method) const;
  bool UpdateValues(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, bool ofColor, bool ofOpacity);
  bool ListDrawn();
  void FindVisible();
  void FindVisibleOfGrid();
  void FindVisibleHexahedra();
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
  VisibilityOrder Order;
  OrderView View;
  VisibilityOrder::Sorted Sorted;    // all tetrahedra, back to front
  std::vector<std::uint8_t> Visible; // per tetrahedron: not fully transparent
  std::vector<std::int32_t> Drawn;
  Cycles Counted;
  Versions Current;

  // What the stages were made from. Pointers are compared only.
  MeshIdentity Mesh;
  ValueIdentity ColorValues, OpacityValues, LayerValues, ContouredValues;
  CellGeometry::Form Form = CellGeometry::Form::Tetrahedra;
  std::int64_t ContouredVersion = 0;
  std::tuple<std::int64_t, Method, std::int64_t> TopologyKey;
  using PropertyKey = std::tuple<int, vtkVolumeProperty*, vtkMTimeType>; // layer
  using Ranges = std::array<double, 4>; // of the colour's scalars, of the opacity's
  std::tuple<std::int64_t, Ranges, bool, bool, std::vector<PropertyKey>> TransferKey;
  SortKey OrderKey;
  SortKey CountedKey;
  std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t, Vector4> EyeKey;
  std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t, std::int64_t, std::int64_t>
    VisibleKey;
  std::tuple<std::int64_t, std::int64_t> DrawnKey;
  std::tuple<std::int64_t, std::int64_t> RaysKey;
};

} // namespace nephoscope

#endif
