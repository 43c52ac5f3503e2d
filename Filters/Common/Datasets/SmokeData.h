// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells that are smoke, as vtkFlowVolume and vtkSmokePuffs write them: its density, and how wide it
 * was when it left the polygon.
 */
#ifndef nephoscope_SmokeData_h
#define nephoscope_SmokeData_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkMultiProcessController;

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

/**
 * The bounds of the data that smoke will be in, in the field data of smoke that has no cells yet. A
 * camera that is set then sees what comes. Without them `bounds` stay as they are.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT void PutBoundsToCome(vtkDataSet* smoke, const double bounds[6]);
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT void FindBoundsToCome(vtkDataObject* smoke, double bounds[6]);

/**
 * Diameter of a disc with the extent of the youngest layer of the smoke, which after vtkFlowVolume
 * is the generating polygon; 0 without ages. The bounds of a disc of radius R have a diagonal of
 * sqrt(8) R, however it is turned, so the result depends neither on how the points are spread over
 * ranks, nor on the room that the smoke bends through.
 * `ranks`: all of them call this, each with its piece of the smoke, which may be null; or null.
 */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT double WidthOfSmoke(
  vtkDataSet* cells, vtkMultiProcessController* ranks);

} // namespace nephoscope

#endif
