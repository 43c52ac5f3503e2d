// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells that are smoke, as vtkFlowVolume and vtkSmokePuffs write them: its density, and how wide it
 * was when it left the polygon.
 */
#ifndef nephoscope_SmokeData_h
#define nephoscope_SmokeData_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

class vtkBoundingBox;
class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

/**
 * The density of the cells if they are smoke (their arrays say when they left the polygon);
 * otherwise null.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkDataArray* SmokeDensity(vtkDataSet* cells);

/**
 * The opacity array of smoke: its puffs on cells or points, as written by vtkSmokePuffs, otherwise
 * its density at the points, as written by vtkFlowVolume, or on the cells. Null if no smoke.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkDataArray* VisibleSmoke(vtkDataSet* cells);

/**
 * Writes the density at the generating polygon to the field data, where InitialSmokeDensity reads
 * it.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT void PutInitialDensity(vtkDataSet* cells, double density);

/**
 * The density at the generating polygon, by which smoke of different times is comparable; 0 where
 * the data do not tell.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT double InitialSmokeDensity(vtkDataSet* cells);

/** The least age of a point; VTK_DOUBLE_MAX without ages. */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT double LeastSmokeAge(vtkDataSet* cells);

/**
 * The bounds of the points that are at most so old: of the youngest layer, which is the generating
 * polygon.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkBoundingBox BoundsOfYoungSmoke(vtkDataSet* cells, double age);

/**
 * Diameter of a disc with these bounds: a radius of R gives a diagonal of sqrt(8) R, however it is
 * turned. 0 without bounds.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT double DiameterOfSmoke(const vtkBoundingBox& bounds);

} // namespace nephoscope

#endif
