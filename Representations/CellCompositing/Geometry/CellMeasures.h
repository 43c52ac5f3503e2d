// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The size of a dataset's 3-D cells, and how a scalar fills them. */
#ifndef nephoscope_CellMeasures_h
#define nephoscope_CellMeasures_h

#include "MediumMeasures.h"
#include "RobustBounds.h"

#include "vtkNephoscopeRepresentationsCellCompositingModule.h" // for export macro

class vtkDataSet;

namespace nephoscope
{

/** Bounds of the finite points, in a box, of the cells that are shown. `data` may be null. */
VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT MediumBounds BoundsOfCells(
  vtkDataSet* data, const MediumBounds& box = WholeMedium);

/** The same of all processes, without parts that are few and far away. */
VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT MediumBounds RobustBoundsOfCells(
  vtkDataSet* data, const MediumReduction& over = {});

/**
 * Measures of cells. Scalars may be null; vectors count by their magnitude. The opacity may be
 * empty.
 */
struct CellMedium
{
  vtkDataArray* Scalars = nullptr;
  bool OnCells = false;
  std::function<double(double)> Opacity = {};
};

/**
 * Measures a piece, which may be null, as far as it lies in the bounds of all pieces. Integrals
 * come from about 1e5 cells.
 */
VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT MediumMeasures MeasureCells(
  vtkDataSet* data, const CellMedium& medium, const MediumBounds& common);

/**
 * Whether a cell that is shown has a volume; looks at every cell until it finds one. `data` may be
 * null.
 */
VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT bool HoldsVolume(vtkDataSet* data);

} // namespace nephoscope

#endif
