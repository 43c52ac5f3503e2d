// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Smoke (SmokeData.h) over several ranks: whether there is any, and how thick it is. */
#ifndef nephoscope_SmokeCells_h
#define nephoscope_SmokeCells_h

class vtkDataSet;

namespace nephoscope
{

/** True if any rank has smoke. Collective. */
bool IsSmoke(vtkDataSet* cells);

/**
 * Diameter of a disc with the extent of the youngest layer of the smoke of all ranks, which after
 * vtkFlowVolume is the generating polygon;
 * 0 if it has none. The bounds of a disc of radius R have a diagonal of sqrt(8) R, however it is
 * turned; so the result depends neither on how the points are spread over ranks, nor on the room
 * that the smoke bends through. Collective.
 */
double SmokeThickness(vtkDataSet* cells);

} // namespace nephoscope

#endif
