// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where smoke starts that is to pass a place: upstream of it.
#ifndef nephoscope_UpstreamPlace_h
#define nephoscope_UpstreamPlace_h

#include "PolygonPlaces.h"

namespace nephoscope
{
// A place upstream of `from`, for a polygon of its radius or more. Where the flow enters the data
// there: just inside, and up to four times as wide, with as much room around the polygon as in it.
// Elsewhere (it goes round, comes from a wall, or enters askew) at most 0.8 of `halfDiagonal`
// upstream, where smoke goes farthest. `reach` is set to how far smoke from there goes
// (FlowReach.h). Collective.
Candidate UpstreamPlace(const DataSetField& field, const PolygonPoints& polygon,
  const Candidate& from, double halfDiagonal, double& reach);
}

#endif
