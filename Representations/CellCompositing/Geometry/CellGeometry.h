// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the mapper draws: the tetrahedra of a dataset's 3-D cells, with a scalar per point or per
 * tetrahedron, and where colour and opacity come from different arrays, a second one.
 *
 * Built once per input and array, in three passes: count the tetrahedra of each cell, sum the
 * counts, fill. All passes run in parallel and their result does not depend on the number of
 * threads.
 */
#ifndef nephoscope_CellGeometry_h
#define nephoscope_CellGeometry_h

#include "ChessboardGrid.h"
#include "GridLattice.h"
#include "HexahedronCells.h"
#include "ProgressLoop.h"
#include "ScalarSelection.h"
#include "TetrahedronList.h"
#include "TetrahedronRay.h"

#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

class CellGeometry
{
public:
  struct Point
  {
    float X, Y, Z; ///< model coordinates minus the centre
    float Scalar;  ///< normalised to [0, 1] over the scalar range; unused for cell scalars
  };

  enum class Form
  {
    Tetrahedra, ///< always listed
    Grid,       ///< of structured data only the grid is kept, which implies the tetrahedra
    WholeCells, ///< the same, and hexahedra of others are kept where they are divided as those of a
                ///< grid
    Automatic,  ///< as Hexahedra, unless most cells are tetrahedra and none are warped
    Hexahedra ///< the same as Grid, and cells of others are kept as hexahedra with their own field
              ///< wherever they can be
  };

  /**
   * `opacity` selects the array that the opacity function reads; none: `scalars` too. `layers`, if
   * given, numbers the cells' layers.
   * Returns an empty string, or why nothing can be drawn. Empty except for Stopped, if it was told
   * to stop.
   */
  std::string Build(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity = {}, vtkDataArray* layers = nullptr,
    const Progress& progress = {}, Form form = Form::Tetrahedra);
  /**
   * Other values of colour, opacity or both for the tetrahedra that are there: of the same mesh,
   * from arrays on points or cells. Returns false, and must be built again, where values are
   * missing now or were then (which cells are drawn depends on them), and for grids.
   */
  bool UpdateValues(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, bool ofColor, bool ofOpacity);
  void Clear();
  /** The last Build would have made the same of this form. */
  bool IsOf(Form form) const;

  /** Tetrahedra that are drawn, hidden cells not counted. */
  std::int64_t NumberOfTetrahedra() const;
  /** Largest distance of a point from the centre; infinite points do not count. */
  double Radius() const;

  bool Stopped = false; ///< the last Build was told to stop
  std::vector<Point> Points;
  TetrahedronList Tetrahedra;
  std::vector<Hexahedron> Hexahedra; ///< in place of the list of tetrahedra unless it is empty
  /**
   * Each hexahedron stands for its five tetrahedra (ChessboardPart), not for a field of its own.
   */
  bool DividesHexahedra = false;
  std::int64_t TetrahedraOfHexahedra = 0; ///< into how many these could be divided
  GridLattice Lattice;                    ///< of the grid, where it is evenly spaced
  ChessboardGrid Grid; ///< takes the place of the list of tetrahedra unless it is empty
  std::vector<std::uint8_t> HiddenCells; ///< of the grid, 255: not drawn; empty: all are drawn
  std::vector<float> CellScalars;        ///< one per tetrahedron (hexahedron, cell of the grid),
                                         ///< normalised; empty for point scalars
  double Center[3] = { 0, 0, 0 };
  double ScalarRange[2] = { 0, 1 }; ///< what 0 and 1 of the normalised scalars stand for
  bool SingleScalar = false;        ///< all values are that of 0

  bool HasOpacityScalars = false; ///< opacity comes from another array than colour
  bool OpacityOnCells = false;
  std::vector<float>
    OpacityScalars; ///< one per point, or per tetrahedron if OpacityOnCells; normalised
  double OpacityRange[2] = { 0, 1 };

  /**
   * The cell of the dataset for each tetrahedron or hexahedron; empty where number i is that of
   * cell i, and for a grid.
   */
  std::vector<std::int32_t> Cells;
  std::vector<std::int32_t> Layers; ///< of each tetrahedron's cell, or of each cell of the grid;
                                    ///< empty without a layer array

  // What was left out, for the mapper to report.
  std::int64_t NumberOfUnsupportedCells = 0; ///< not 3-D, or of a kind that cannot be decomposed
  int UnsupportedCellType = 0;               ///< the largest of their types
  std::int64_t NumberOfInvalidCells = 0;     ///< a coordinate or scalar is not finite
  std::int64_t NumberOfWarpedCells = 0; ///< not polyhedra, not folded: their tetrahedra overlap
  std::int64_t NumberOfMisnumberedCells = 0; ///< drawn with their points in a better order
  bool MostAreTetrahedra = false;            ///< or are pieces of some
  std::int64_t NumberOfFoldedCells = 0;      ///< over themselves, in any order of their points
  std::int64_t FirstFoldedCell = -1;         ///< of both kinds; -1: none
  std::int64_t NumberOfNonConvexCells =
    0; ///< polyhedra that their tetrahedra do not fill: drawn, but wrong
  std::int64_t NumberOfFlatTetrahedra = 0; ///< zero volume: nothing to draw, no error

  ///@{
  /**
   * Tetrahedra numbered on from 0, listed or of the grid, hidden ones among them: how many, which
   * points, and whether it is hidden.
   */
  std::int64_t CountTetrahedra() const;
  std::array<std::int64_t, 4> PointNumbers(std::int64_t tetrahedron) const;
  int TetrahedraPerHexahedron() const { return this->DividesHexahedra ? 5 : 6; }
  /** Vertices of a tetrahedron of a hexahedron. */
  std::array<std::size_t, 4> PartCorners(int part) const
  {
    return this->DividesHexahedra ? ChessboardPart(part) : HexahedronPart(part);
  }
  bool IsHidden(std::int64_t tetrahedron) const;
  ///@}
  /**
   * While it is built: how hexahedra are divided (ChessboardDivision.h). Null: by their
   * coordinates.
   */
  vtkUnsignedCharArray* GetDivisions() const { return this->Divisions; }
  /** Vertices relative to the centre. */
  std::array<Vector3, 4> Vertices(std::size_t tetrahedron) const;
  Vector3 Position(std::int32_t point) const
  {
    const Point& p = this->Points[static_cast<std::size_t>(point)];
    return { p.X, p.Y, p.Z };
  }

private:
  // Those that take a Progress return false when stopped.
  bool CopyPoints(vtkDataSet* data, const Progress& progress);
  bool CopyScalars(vtkDataSet* data, const ScalarSelection& scalars, const Progress& progress);
  bool CopyOpacityScalars(
    vtkDataSet* data, const ScalarSelection& opacity, const Progress& progress);
  bool CopyCellValues(const ScalarSelection& scalars, const double range[2],
    std::vector<float>& values, const Progress& progress) const;
  bool ValuesAreFinite() const;
  bool UseGrid(vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity);
  void PreferHexahedra(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, const Progress& progress);
  bool UseHexahedra(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, const Progress& progress);
  bool UseDividedHexahedra(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, const Progress& progress);
  bool ListHexahedra(vtkDataSet* data, std::vector<std::int32_t>& first,
    vtkUnsignedCharArray* divisions, const ScalarSelection& scalars, const ScalarSelection& opacity,
    const Progress& progress);
  bool FillHexahedra(vtkDataSet* data, const std::vector<std::int32_t>& first,
    vtkUnsignedCharArray* divisions, const Progress& progress);
  void CountShapes(const class ShapeCounts& counts);
  bool FindSeam();
  bool FindLattice();
  void FindHiddenCells(
    vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity);
  void CopyGridCells(const ScalarSelection& scalars, const ScalarSelection& opacity);
  bool Decompose(vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity,
    const Progress& progress);
  bool CountOfCells(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, std::vector<std::int64_t>& counts, const Progress& progress);
  bool FillTetrahedra(vtkDataSet* data, const ScalarSelection& scalars,
    const ScalarSelection& opacity, const std::vector<std::int64_t>& first,
    const Progress& progress);

  Form BuiltForm = Form::Tetrahedra;
  vtkDataArray* LayerArray = nullptr; // while building
  vtkSmartPointer<vtkUnsignedCharArray>
    Divisions; // of unstructured hexahedra, as in a grid; likewise
};

} // namespace nephoscope

#endif
