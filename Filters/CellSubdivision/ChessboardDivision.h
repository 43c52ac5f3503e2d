// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Unstructured hexahedra divided as those of a grid are: the vertices of a grid are even or odd, and so are those of any mesh of
 * hexahedra and voxels in which the edges of every closed path are even in number.
 *
 * The same cells then look the same as a grid and as unstructured data. Division by coordinates (TetrahedronSource.h) would
 * make six tetrahedra of each cell in place of five, with diagonals in the same direction everywhere.
 */
#ifndef ChessboardDivision_h
#define ChessboardDivision_h

#include "vtkNephoscopeFiltersCellSubdivisionModule.h" // for export macro
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

class vtkDataSet;

namespace nephoscope
{

/**
 * For each cell 3 where its first vertex is even, 4 where it is odd, as divisionName in TetrahedronSource.h has it. The point with the
 * least number of each connected part is even; parts that touch at coincident points agree there if they can. Null for data that
 * are not unstructured, have the array already, have other cells than hexahedra and voxels, or cannot be coloured.
 */
VTKNEPHOSCOPEFILTERSCELLSUBDIVISION_EXPORT vtkSmartPointer<vtkUnsignedCharArray> chessboardDivision(
  vtkDataSet* data);

} // namespace nephoscope

#endif
