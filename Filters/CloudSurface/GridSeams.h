// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds where a structured grid closes: a last column that coincides with the first, and rows that
// are one point.
#ifndef nephoscope_GridSeams_h
#define nephoscope_GridSeams_h

#include "GridTopology.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{
enum class Circle
{
  Part,    // some of it
  Open,    // one step is missing between the last and the first
  Repeated // the last is the first again
};

// Longitudes in degrees, in either order, with or without jumps of whole turns.
Circle JudgeCircle(const std::vector<double>& degrees);

// Axes whose last points coincide with the first ones become rings with a repeated point.
void FindRepeatedPlaces(vtkDataSet* grid, GridTopology& topology);

// Along an axis that is said to be periodic: true if the values of all point arrays at its last
// points are those at its first ones, and not the same throughout, so that it is no accident.
bool RepeatsValues(vtkDataSet* grid, const GridTopology& topology, int axis);

// Ends of one axis at which all points along another axis coincide.
void FindPoles(vtkDataSet* grid, GridTopology& topology);

// True if the step from the last points to the first is no longer than two of the steps between
// neighbours.
bool ClosesInSpace(vtkDataSet* grid, const GridTopology& topology, int axis);
}

#endif
