// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** How far apart particles are. */
#ifndef nephoscope_NeighborSpacing_h
#define nephoscope_NeighborSpacing_h

#include "RobustBounds.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

/** Bounds of the points that are at finite places, without those that are few and far away. */
MediumBounds BulkOfPoints(vtkDataSet* data);

/**
 * The edge of a cube for each point, by the ball that its neighbours fill: its volume over their
 * number; far from all others their mean spacing; 0 at no finite place.
 */
std::vector<float> FindNeighborSpacing(vtkDataSet* data);

} // namespace nephoscope

#endif
