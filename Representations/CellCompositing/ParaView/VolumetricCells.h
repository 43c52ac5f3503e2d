// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The changes that the Cell Compositing representation makes to its input before it passes it to the view.
 */
#ifndef VolumetricCells_h
#define VolumetricCells_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace nephoscope
{

/** True for datasets whose pieces are boxes that can be sorted by their bounds: images and rectilinear grids. */
bool isAxisAligned(vtkDataSet* data);

/**
 * The dataset to draw: `input` itself (a shallow copy), or the blocks of a composite that have 3-D cells, appended.
 * Null when there is nothing volumetric in it.
 */
vtkSmartPointer<vtkDataSet> volumetricPart(vtkDataObject* input);

/** The dataset itself or, if it has polyhedra that are not convex, a dataset in which tetrahedra replace them. */
vtkSmartPointer<vtkDataSet> withConvexCells(vtkDataSet* data);

/**
 * The cells as tetrahedra, divided as the mapper divides them, and the polygons between them as triangles, without those that a ghost array hides.
 * A cut through a tetrahedron keeps the linear interpolant, a cut through a hexahedron does not: this is what makes a
 * picture independent of where the data is cut for several ranks.
 */
vtkSmartPointer<vtkUnstructuredGrid> tetrahedralize(vtkDataSet* data);

} // namespace nephoscope

#endif
