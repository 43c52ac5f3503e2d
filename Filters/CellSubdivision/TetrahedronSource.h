// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tetrahedra of a dataset's cells, one cell after another. One object per thread.
 *
 * Cells are divided as CellDecomposition.h says, with the vertices in the order of their
 * coordinates (x, then y, then z), which does not depend on numbering, blocks or ranks. Cells of
 * structured data are divided by the indices of their vertices, as ChessboardGrid.h says; so are
 * hexahedra and voxels that have left their grid, if the cell array divisionName tells how.
 */
#ifndef nephoscope_TetrahedronSource_h
#define nephoscope_TetrahedronSource_h

#include "CellCorners.h"
#include "ChessboardDivision.h"
#include "HexahedronForm.h"
#include "HigherOrderCells.h"
#include "LinearCellFaces.h"
#include "PolyhedronConvexity.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace nephoscope
{

class TetrahedronSource
{
public:
  /** `divisions`, if given, in place of the cell array of that name. */
  explicit TetrahedronSource(vtkDataSet* data, vtkUnsignedCharArray* divisions = nullptr)
    : Data(data)
    , Grid(vtkUnstructuredGrid::SafeDownCast(data))
    , CellGhosts(data->GetCellGhostArray())
    , PointGhosts(data->GetPointGhostArray())
    , Divisions(divisions
          ? divisions
          : vtkUnsignedCharArray::SafeDownCast(data->GetCellData()->GetArray(divisionName)))
    , Chessboard(FindChessboardGrid(data))
  {
  }

  /**
   * Ghost flags say not to draw the cell, or it touches a hidden point. Leaves the cell's points in
   * GetPoints().
   */
  bool IsHidden(vtkIdType cell)
  {
    constexpr unsigned char skipped = vtkDataSetAttributes::DUPLICATECELL |
      vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
    this->Type = this->Data->GetCellType(cell);
    this->Data->GetCellPoints(cell, this->Points);
    if (this->Type == VTK_EMPTY_CELL ||
      (this->CellGhosts && (this->CellGhosts->GetValue(cell) & skipped)))
    {
      return true;
    }
    const vtkIdType* ids = this->Points->GetPointer(0);
    return this->PointGhosts &&
      std::any_of(ids, ids + this->Points->GetNumberOfIds(), [this](vtkIdType id) {
        return (this->PointGhosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT) != 0;
      });
  }

  vtkIdList* GetPoints() const { return this->Points; }

  /**
   * Finds the shape of the cell last passed to IsHidden. Where it is misnumbered, GetPoints() has
   * its points in the better order from then on;
   * EmitTetrahedra does this too. Cells of grids count as whole.
   */
  CellShape PutInOrder(vtkIdType cell)
  {
    const int division = this->Divisions ? this->Divisions->GetValue(cell) : 0;
    const bool ofGrid = !this->Chessboard.IsEmpty() || (division > 0 && division <= lastOfGrid);
    const CellCorners corners = CellCornersOf(this->Type);
    if (ofGrid || corners.Begin == corners.End)
    {
      this->Shape = CellShape::Whole;
      return this->Shape;
    }
    this->FindPlaces();
    this->OrderPlaces();
    return this->Shape;
  }

  /** The shape of the cell last passed to EmitTetrahedra or PutInOrder. */
  CellShape GetShape() const { return this->Shape; }

  /**
   * A quick test of that cell, with rounded places: false may also mean that PutInOrder has to
   * look.
   */
  template <typename PlaceOfPoint>
  bool PassesQuickTest(PlaceOfPoint placeOfPoint) const
  {
    const CellCorners corners = CellCornersOf(this->Type);
    const vtkIdType* ids = this->Points->GetPointer(0);
    std::array<Vector3, 8> places;
    for (vtkIdType i = 0; i < this->Points->GetNumberOfIds() && corners.Begin; ++i)
    {
      places[i] = placeOfPoint(ids[i]);
    }
    return !corners.Begin ||
      IsWellShaped(corners, [&](int vertex) -> const Vector3& { return places[vertex]; });
  }

  /** Off: all cells are known to be in order, from an earlier walk through the same data. */
  void SetFindsShapes(bool finds) { this->FindsShapes = finds; }

  /**
   * Calls emit({a, b, c, d}) with the point numbers of each tetrahedron of the cell last passed to
   * IsHidden. Returns false when it is no 3-D cell.
   */
  template <typename Emit>
  bool EmitTetrahedra(vtkIdType cell, Emit emit)
  {
    this->VolumeSum = this->VolumeSizes = 0;
    this->Shape = CellShape::Whole;
    if (!this->Chessboard.IsEmpty())
    {
      for (const auto& t : this->Chessboard.Tetrahedra(cell))
      {
        emit(std::array<vtkIdType, 4>{ { t[0], t[1], t[2], t[3] } });
      }
      return true;
    }
    if (this->Divisions && this->Divisions->GetValue(cell) > 0)
    {
      this->EmitFromGrid(this->Divisions->GetValue(cell), emit);
      return true;
    }
    const FaceList<int> faces = LinearCellFaces(this->Type);
    if (faces.Begin)
    {
      this->EmitLinear(faces, emit);
      return true;
    }
    if (this->Type == VTK_POLYHEDRON && this->Grid)
    {
      this->EmitPolyhedron(cell, emit);
      return true;
    }
    return this->EmitTriangulated(cell, emit);
  }

  /**
   * Calls emit({a, b, c}) for each triangle of the polygon last passed to IsHidden, divided like
   * faces of cells. Returns false when it is no polygon of an unstructured grid.
   */
  template <typename Emit>
  bool EmitTriangles(Emit emit)
  {
    if (!this->Grid ||
      (this->Type != VTK_TRIANGLE && this->Type != VTK_QUAD && this->Type != VTK_POLYGON &&
        this->Type != VTK_PIXEL))
    {
      return false;
    }
    std::vector<Place> around;
    for (const vtkIdType id : *this->Points)
    {
      around.push_back(this->PlaceOf(id));
    }
    if (this->Type == VTK_PIXEL)
    {
      std::swap(around[2], around[3]);
    }
    std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
    for (std::size_t k = 1; k + 1 < around.size(); ++k)
    {
      emit(std::array<vtkIdType, 3>{
        { std::get<3>(around[0]), std::get<3>(around[k]), std::get<3>(around[k + 1]) } });
    }
    return true;
  }

  /**
   * Whether those tetrahedra fill the cell. For polyhedra, after EmitTetrahedra: true for a
   * non-convex one, which vtkPolyhedronToTetrahedra should divide first. True if the faces are not
   * closed, so that there is no inside.
   */
  bool TetrahedraFillCell()
  {
    if (this->Type != VTK_POLYHEDRON || !this->Grid)
    {
      return true;
    }
    const vtkIdType* stream = this->Faces->GetPointer(0);
    const auto state =
      this->Surface.Build(FaceList<vtkIdType>{ stream + 1, stream + this->Faces->GetNumberOfIds() },
        [this](vtkIdType id) {
          Vector3 x;
          this->Data->GetPoint(id, x.data());
          return x;
        });
    const bool isFloat = this->Grid->GetPoints()->GetDataType() == VTK_FLOAT;
    return state != PolyhedronSurface::State::Closed ||
      ConeFillsCell(this->Surface, SlackOf(this->Surface, isFloat));
  }

  /**
   * The part of the volume of the tetrahedra in which they overlap, 0 to 1, for the cell last
   * passed to EmitTetrahedra: more than rounding in warped cells, whose tetrahedra are partly
   * inside out. 0 for polyhedra (TetrahedraFillCell) and the cells of grids.
   */
  double GetOverlap() const
  {
    return this->VolumeSizes > 0 ? 1 - std::abs(this->VolumeSum) / this->VolumeSizes : 0;
  }

  /** More than rounding makes them overlap. */
  bool IsWarped() const { return this->GetOverlap() > 1e-3; }

private:
  static constexpr int lastOfGrid = 2; // divisions above it are those of ChessboardDivision.h
  using Place = std::tuple<double, double, double, vtkIdType>;

  // Coordinates, and where points coincide the number.
  Place PlaceOf(vtkIdType point) const
  {
    double x[3];
    this->Data->GetPoint(point, x);
    return { x[0], x[1], x[2], point };
  }

  void FindPlaces()
  {
    const vtkIdType* ids = this->Points->GetPointer(0);
    for (int i = 0; i < static_cast<int>(this->Points->GetNumberOfIds()); ++i)
    {
      this->Places[i] = this->PlaceOf(ids[i]);
    }
  }

  void OrderPlaces()
  {
    std::array<Vector3, 12> positions;
    const int size = static_cast<int>(this->Points->GetNumberOfIds());
    for (int i = 0; i < size; ++i)
    {
      const Place& p = this->Places[i];
      positions[i] = { { std::get<0>(p), std::get<1>(p), std::get<2>(p) } };
    }
    PointOrders::Order order;
    this->Shape = FindCellShape(
      this->Type, [&](int vertex) -> const Vector3& { return positions[vertex]; }, order);
    if (this->Shape == CellShape::Misnumbered)
    {
      const std::array<Place, 12> before = this->Places;
      for (int i = 0; i < size; ++i)
      {
        this->Places[i] = before[order[i]];
        this->Points->SetId(i, std::get<3>(this->Places[i]));
      }
    }
  }

  // A hexahedron or voxel, as in the grid that it comes from.
  template <typename Emit>
  void EmitFromGrid(int division, Emit emit)
  {
    const std::array<int, 8> vertices = HexahedronFormOf(this->Type).Vertices;
    const bool ofGrid = division <= lastOfGrid;
    if (!ofGrid)
    {
      this->FindPlaces();
      if (this->FindsShapes)
      {
        this->OrderPlaces();
      }
    }
    const vtkIdType* ids = this->Points->GetPointer(0);
    for (const auto& corners : cellTetrahedra()[static_cast<std::size_t>((division - 1) & 1)])
    {
      std::array<int, 4> t;
      std::transform(corners.begin(), corners.end(), t.begin(),
        [&](std::int64_t corner) { return vertices[static_cast<std::size_t>(corner)]; });
      if (!ofGrid)
      {
        this->AddVolume(t);
      }
      emit(std::array<vtkIdType, 4>{ { ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]] } });
    }
  }

  // The tetrahedra of a cell with an even, and with an odd first vertex.
  using CellTetrahedra = std::array<std::array<std::int64_t, 4>, ChessboardGrid::TetrahedraPerCell>;
  static const std::array<CellTetrahedra, 2>& cellTetrahedra()
  {
    static const std::array<CellTetrahedra, 2> both{ { ChessboardGrid{ { 2, 2, 2 }, 0 }.Tetrahedra(
                                                         0),
      ChessboardGrid{ { 2, 2, 2 }, 1 }.Tetrahedra(0) } };
    return both;
  }

  template <typename Emit>
  void EmitLinear(FaceList<int> faces, Emit emit)
  {
    this->FindPlaces();
    if (this->FindsShapes)
    {
      this->OrderPlaces();
    }
    const vtkIdType* ids = this->Points->GetPointer(0);
    if (this->MergeCoincident(static_cast<int>(this->Points->GetNumberOfIds())))
    {
      faces = this->WithoutRepeatedVertices(faces);
    }
    DecomposeCell(
      faces, [this](int a, int b) { return this->Places[a] < this->Places[b]; },
      [&](const std::array<int, 4>& t) {
        this->AddVolume(t);
        emit(std::array<vtkIdType, 4>{ { ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]] } });
      });
  }

  void AddVolume(const std::array<int, 4>& t)
  {
    const double volume = this->SixVolumes(t);
    this->VolumeSum += volume;
    this->VolumeSizes += std::abs(volume);
  }

  double SixVolumes(const std::array<int, 4>& t) const
  {
    const auto from = [&](int vertex) {
      const Place &a = this->Places[t[0]], &b = this->Places[vertex];
      return Vector3{ { std::get<0>(b) - std::get<0>(a), std::get<1>(b) - std::get<1>(a),
        std::get<2>(b) - std::get<2>(a) } };
    };
    return Dot(Cross(from(t[1]), from(t[2])), from(t[3]));
  }

  // Where a row of cells shrinks to a pole, vertices of a cell coincide. They become one.
  bool MergeCoincident(int size)
  {
    bool merged = false;
    for (int i = 0; i < size; ++i)
    {
      this->Representatives[i] = i;
      for (int j = 0; j < i; ++j)
      {
        if (std::get<0>(this->Places[i]) == std::get<0>(this->Places[j]) &&
          std::get<1>(this->Places[i]) == std::get<1>(this->Places[j]) &&
          std::get<2>(this->Places[i]) == std::get<2>(this->Places[j]))
        {
          this->Representatives[i] = this->Representatives[j];
          merged = true;
          break;
        }
      }
    }
    return merged;
  }

  FaceList<int> WithoutRepeatedVertices(FaceList<int> faces)
  {
    this->MergedFaces.clear();
    for (const int* face = faces.Begin; face != faces.End; face += *face + 1)
    {
      const std::size_t start = this->MergedFaces.size();
      this->MergedFaces.push_back(0);
      for (int k = 1; k <= *face; ++k)
      {
        const int vertex = this->Representatives[face[k]];
        if (std::find(this->MergedFaces.begin() + start + 1, this->MergedFaces.end(), vertex) ==
          this->MergedFaces.end())
        {
          this->MergedFaces.push_back(vertex);
        }
      }
      this->MergedFaces[start] = static_cast<int>(this->MergedFaces.size() - start) - 1;
    }
    return { this->MergedFaces.data(), this->MergedFaces.data() + this->MergedFaces.size() };
  }

  template <typename Emit>
  void EmitPolyhedron(vtkIdType cell, Emit emit)
  {
    this->Grid->GetFaceStream(cell, this->Faces); // number of faces, then the face list
    const vtkIdType* stream = this->Faces->GetPointer(0);
    DecomposeCell(
      FaceList<vtkIdType>{ stream + 1, stream + this->Faces->GetNumberOfIds() },
      [this](vtkIdType a, vtkIdType b) { return this->PlaceOf(a) < this->PlaceOf(b); }, emit);
  }

  // Higher-order and other 3-D cells: as VTK triangulates them, where neighbours then agree.
  template <typename Emit>
  bool EmitTriangulated(vtkIdType cell, Emit emit)
  {
    this->Data->GetCell(cell, this->Cell);
    auto part = [&](FaceList<int> faces, const int* points) {
      DecomposeCell(
        faces,
        [&](int a, int b) {
          return this->PlaceOf(this->Points->GetId(points[a])) <
            this->PlaceOf(this->Points->GetId(points[b]));
        },
        [&](const std::array<int, 4>& t) {
          emit(std::array<vtkIdType, 4>{
            { this->Points->GetId(points[t[0]]), this->Points->GetId(points[t[1]]),
              this->Points->GetId(points[t[2]]), this->Points->GetId(points[t[3]]) } });
        });
    };
    if (SplitHigherOrderCell(this->Cell->GetRepresentativeCell(), part))
    {
      return true;
    }
    if (this->Cell->GetCellDimension() != 3 ||
      !this->Cell->Triangulate(0, this->Faces, this->CellPoints))
    {
      return false;
    }
    this->MakeIdsGlobal();
    for (vtkIdType i = 0; i + 3 < this->Faces->GetNumberOfIds(); i += 4)
    {
      const vtkIdType* t = this->Faces->GetPointer(i);
      emit(std::array<vtkIdType, 4>{ { t[0], t[1], t[2], t[3] } });
    }
    return true;
  }

  // vtkConvexPointSet of VTK 9.2 numbers its own points from 0; the coordinates identify them.
  void MakeIdsGlobal()
  {
    vtkIdType* ids = this->Faces->GetPointer(0);
    const vtkIdType n = this->Faces->GetNumberOfIds(), own = this->Points->GetNumberOfIds();
    bool global = true, local = true;
    for (vtkIdType i = 0; i < n; ++i)
    {
      global = global && this->IsPlace(ids[i], i);
      local = local && ids[i] < own && this->IsPlace(this->Points->GetId(ids[i]), i);
    }
    for (vtkIdType i = 0; i < n && local && !global; ++i)
    {
      ids[i] = this->Points->GetId(ids[i]);
    }
  }

  bool IsPlace(vtkIdType point, vtkIdType cellPoint) const
  {
    double named[3], meant[3];
    this->Data->GetPoint(point, named);
    this->CellPoints->GetPoint(cellPoint, meant);
    return std::equal(
      named, named + 3, meant, [](double a, double b) { return float(a) == float(b); });
  }

  vtkDataSet* Data;
  vtkUnstructuredGrid* Grid;
  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  vtkUnsignedCharArray* Divisions; // null: none
  ChessboardGrid Chessboard;       // empty: no structured data
  int Type = VTK_EMPTY_CELL;
  std::array<Place, 12> Places; // of the cell's vertices
  std::array<int, 12> Representatives;
  double VolumeSum = 0, VolumeSizes = 0; // six times those of the tetrahedra, with and without sign
  CellShape Shape = CellShape::Whole;
  bool FindsShapes = true;
  std::vector<int> MergedFaces;
  PolyhedronSurface Surface;
  vtkNew<vtkIdList> Points;
  vtkNew<vtkIdList> Faces;
  vtkNew<vtkPoints> CellPoints;
  vtkNew<vtkGenericCell> Cell;
};

} // namespace nephoscope

#endif
