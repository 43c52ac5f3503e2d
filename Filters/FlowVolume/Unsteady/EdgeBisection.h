// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Long edges of a mesh of tetrahedra halved, the longest first, in all tetrahedra at an edge
// together: no cracks and no hanging points (Rivara1984, without propagation, as no edge needs to
// be the longest of its tetrahedra). Plain C++17.
#ifndef nephoscope_EdgeBisection_h
#define nephoscope_EdgeBisection_h

#include "StreakMesh.h"

#include <cstddef>

namespace nephoscope
{
struct BisectionLimits
{
  double MaximumEdgeLength = 0.0;
  std::size_t MaximumNumberOfTetrahedra = 0;
  PointId FirstFixed = 0;      // edges between two of these points are left, as
  std::size_t FixedPoints = 0; // something else will be joined to them
};

// The new point lies in the middle of the edge, in place and in release time; both halves of a
// tetrahedron have half its mass and half its volume. False if the limit of tetrahedra has been
// reached.
bool BisectLongEdges(StreakMesh& mesh, const BisectionLimits& limits);
}

#endif
