// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The size of a dataset's cells, and how a scalar fills them: what the automatic unit distance is made of.
 */
#ifndef CellMeasures_h
#define CellMeasures_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkType.h"

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

/** Volume and bounds of the cells that this process owns, and what a scalar is like over that volume. */
struct CellMeasures
{
  double Volume = 0.0;
  double ScalarIntegral = 0.0;
  double ScalarRange[2] = { 1.0, -1.0 };
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

/** A value of an array of scalars; the magnitude of a vector. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT double scalarOf(vtkDataArray* scalars, vtkIdType tuple);

/**
 * Of a piece. `scalars` may be null; vectors count by their magnitude. Integrals come from about 1e5 evenly chosen cells.
 */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT CellMeasures measureCells(vtkDataSet* data, vtkDataArray* scalars, bool onCells);

/** Of all ranks together. Collective. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT CellMeasures reduceOverRanks(const CellMeasures& mine);

/**
 * Mean length of a ray inside the cells: their volume divided by the mean projected area of their bounding box, which is
 * a quarter of its surface (Cauchy). 0 without 3-D cells.
 */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT double meanChord(const CellMeasures& measures);

/** Mean over the volume of a ramp from 0 to 1 over the scalar's range; 0.5 when the scalar is constant or missing. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT double meanRamp(const CellMeasures& measures);

} // namespace nephoscope

#endif
