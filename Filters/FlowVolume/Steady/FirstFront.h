// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The front of age zero: the generating polygon. Plain C++17.
#ifndef nephoscope_FirstFront_h
#define nephoscope_FirstFront_h

#include "FrontMarks.h"

namespace nephoscope
{
// The polygon with its points in the order of their coordinates and its triangles in that of their
// points, so that the order in which they come makes no difference. Triangles without area or with
// points that do not exist are left out.
SmokeFront MakeFirstFront(const PolygonMesh& polygon);

struct Emission
{
  double Flux = 0.0; // volume per second, whichever way it goes
  std::size_t Parallel =
    0; // triangles that were dropped because the flow crosses them both ways, or not at all
  bool Outside = false;      // some of the polygon was outside the field
  bool LimitReached = false; // more triangles than allowed: none are left
};

// Samples the flow at the polygon; divides, as `limits` say, and drops triangles that are partly
// outside the field, or which the flow crosses both ways: their prisms would cross themselves.
// Turns the others to the flow and gives each the mass that crosses it per second: its area times
// the mean of the flow at its corners, which is exact for a linear flow.
Emission EmitFrom(SmokeFront& front, const VelocityField& field, double time,
  const EdgeLimits& limits, std::size_t maximumNumberOfTriangles);
}

#endif
