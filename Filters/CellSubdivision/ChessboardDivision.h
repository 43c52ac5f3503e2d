// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Unstructured hexahedra divided as those of a grid are: the vertices of a grid are even or odd,
 * and so are those of any mesh of hexahedra and voxels in which the edges of every closed path are
 * even in number.
 *
 * The same cells then look the same as a grid and as unstructured data. Division by coordinates
 * (TetrahedronSource.h) would make six tetrahedra of each cell in place of five, with diagonals in
 * the same direction everywhere.
 */
#ifndef nephoscope_ChessboardDivision_h
#define nephoscope_ChessboardDivision_h

#include "ChessboardGrid.h"

#include "vtkNephoscopeFiltersCellSubdivisionModule.h" // for export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace nephoscope
{

/**
 * Bytes: 1 for a cell of a grid whose first vertex is even, 2 where it is odd; 3 and 4 likewise for
 * cells of unstructured data; 0 for others.
 */
constexpr const char* divisionName = "NephoscopeDivision";

/**
 * The grid of structured data with cells in three dimensions; empty for all other data. Its seam
 * counts as open.
 */
VTKNEPHOSCOPEFILTERSCELLSUBDIVISION_EXPORT ChessboardGrid FindChessboardGrid(vtkDataSet* data);

/** Parts that belong together: what is even in one is even or odd in the whole. */
class VTKNEPHOSCOPEFILTERSCELLSUBDIVISION_EXPORT ColoredParts
{
public:
  std::int32_t Add();
  /**
   * The whole to which a part belongs, named by one of its parts, and 1 if the part is odd there.
   */
  std::pair<std::int32_t, int> Find(std::int32_t part);
  /**
   * `odd`: what is even in one is odd in the other. False if the two belong together in the other
   * way already.
   */
  bool Join(std::int32_t a, std::int32_t b, int odd);
  std::size_t Count() const { return this->Parents.size(); }

private:
  std::vector<std::int32_t> Parents;
  std::vector<unsigned char> Odd; // against the parent
};

/** Which vertices of a mesh are odd. */
class VTKNEPHOSCOPEFILTERSCELLSUBDIVISION_EXPORT ChessboardColors
{
public:
  explicit ChessboardColors(vtkUnstructuredGrid* grid);

  /** False if it has other cells than hexahedra and voxels, or no such colours. */
  bool Find();
  /** Wholes share no edge. They are numbered in the order of their first points. */
  std::size_t CountWholes() const { return this->FirstIsOdd.size(); }
  /**
   * The whole of a point, -1 for one that belongs to no cell, and 1 if it has another colour than
   * the first point.
   */
  std::pair<std::int32_t, int> ColorOf(vtkIdType point);
  /**
   * Cell by cell 3 where the first vertex is even, 4 where it is odd; `odd`: whether the first
   * point of each whole is.
   */
  vtkSmartPointer<vtkUnsignedCharArray> MakeDivisions(const std::vector<unsigned char>& odd);

private:
  bool Add(vtkIdType cell);
  void JoinCoincident();
  void NumberWholes();

  vtkUnstructuredGrid* Grid;
  std::vector<std::int32_t> PartOf; // of each point; -1: it belongs to no cell
  std::vector<unsigned char> Odd;   // in its part
  ColoredParts Parts;
  std::vector<std::int32_t> Wholes; // numbers of those that parts name
  std::vector<unsigned char> FirstIsOdd;
};

/**
 * For each cell 3 where its first vertex is even, 4 where it is odd, as divisionName has it. The
 * point with the least number of each connected part is even; parts that touch at coincident points
 * agree there if they can. Null for data that are not unstructured, have the array already, have
 * other cells than hexahedra and voxels, or cannot be coloured.
 */
VTKNEPHOSCOPEFILTERSCELLSUBDIVISION_EXPORT vtkSmartPointer<vtkUnsignedCharArray> ChessboardDivision(
  vtkDataSet* data);

} // namespace nephoscope

#endif
