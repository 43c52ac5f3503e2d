// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells that are smoke, as vtkFlowVolume and vtkSmokePuffs write them: what makes them opaque, and how thick the smoke is.
 */
#ifndef SmokeCells_h
#define SmokeCells_h

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

/** The density of the cells, for how much smoke there is, if they are smoke (they know when they left the polygon); else null. */
vtkDataArray* smokeDensity(vtkDataSet* cells);

/** What smoke is to be opaque by: its puffs, of cells or points, as vtkSmokePuffs writes them, else its density. Null if no smoke. */
vtkDataArray* visibleSmoke(vtkDataSet* cells);

/** True if any rank has smoke. Collective. */
bool isSmoke(vtkDataSet* cells);

/**
 * Diameter of a disc with the extent of the youngest layer of the smoke of all ranks, which after vtkFlowVolume is the generating polygon;
 * 0 if it has none. The bounds of a disc of radius R have a diagonal of sqrt(8) R, however it is turned; so the result depends
 * neither on how the points are spread over ranks, nor on the room that the smoke bends through. Collective.
 */
double smokeThickness(vtkDataSet* cells);

} // namespace nephoscope

#endif
