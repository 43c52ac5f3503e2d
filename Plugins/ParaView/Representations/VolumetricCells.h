// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the Cell Compositing representation does to its input before it hands it to the view.
 */
#ifndef VolumetricCells_h
#define VolumetricCells_h

#include "vtkSmartPointer.h"

class vtkDataArray;
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

/**
 * The cells as tetrahedra, divided as the mapper divides them, without those that a ghost array hides.
 * A cut through a tetrahedron keeps the linear interpolant, a cut through a hexahedron does not: this is what makes a
 * picture independent of where the data is cut for several ranks.
 */
vtkSmartPointer<vtkUnstructuredGrid> tetrahedralize(vtkDataSet* data);

/** Volume and bounds of the cells that this process owns, and what a scalar is like over that volume. */
struct CellMeasures
{
  double Volume = 0.0;
  double ScalarIntegral = 0.0;
  double ScalarRange[2] = { 1.0, -1.0 };
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

/**
 * Of a piece. `scalars` may be null; vectors count by their magnitude. Integrals come from about 1e5 evenly chosen cells.
 */
CellMeasures measureCells(vtkDataSet* data, vtkDataArray* scalars, bool onCells);

/** Of all ranks together. Collective. */
CellMeasures reduceOverRanks(const CellMeasures& mine);

/**
 * Mean length of a ray inside the cells: their volume divided by the mean projected area of their bounding box, which is
 * a quarter of its surface (Cauchy). 0 without 3-D cells.
 */
double meanChord(const CellMeasures& measures);

/** Mean over the volume of a ramp from 0 to 1 over the scalar's range; 0.5 when the scalar is constant or missing. */
double meanRamp(const CellMeasures& measures);

} // namespace nephoscope

#endif
