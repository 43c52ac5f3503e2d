// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The changes that the Cell Compositing representation makes to its input before it passes it to
 * the view.
 */
#ifndef nephoscope_VolumetricCells_h
#define nephoscope_VolumetricCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace nephoscope
{

/**
 * True for datasets whose pieces are boxes that can be sorted by their bounds: images and
 * rectilinear grids.
 */
bool IsAxisAligned(vtkDataSet* data);

/**
 * The dataset to draw: `input` itself (a shallow copy), or the blocks of a composite that have 3-D
 * cells, appended.
 * Null when there is nothing volumetric in it. `isPart`: other ranks have others; the layer of
 * points, without volume, that is left for a rank where a grid has too few cells for all of them
 * counts as nothing.
 */
vtkSmartPointer<vtkDataSet> VolumetricPart(vtkDataObject* input, bool isPart);

/**
 * The dataset itself or, if it has polyhedra that are not convex, a dataset in which tetrahedra
 * replace them.
 */
vtkSmartPointer<vtkDataSet> WithConvexCells(vtkDataSet* data);

/**
 * The visible cells as an unstructured grid, without ghost arrays, which ParaView may spread over
 * ranks. Those of a grid keep its division into tetrahedra (divisionName in ChessboardDivision.h).
 */
vtkSmartPointer<vtkUnstructuredGrid> VisibleCells(vtkDataSet* data);

/** What a list of cells may be drawn as. */
enum class WholeCells
{
  Tetrahedra, ///< some are not hexahedra, wedges, pyramids or tetrahedra
  Either,
  Trilinear ///< by default: most are no tetrahedra, or tetrahedra of some overlap, which are warped
};
WholeCells FormOfWholeCells(vtkUnstructuredGrid* cells);

/** The numbers of the points on the outside of the cells. */
std::vector<vtkIdType> PointsOfSurface(vtkUnstructuredGrid* cells);

/** The delivered cells without the flags of those that other ranks have, too. */
vtkSmartPointer<vtkDataSet> WithoutGhosts(vtkDataSet* cells);

} // namespace nephoscope

#endif
