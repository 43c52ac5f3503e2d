// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Short edges of a mesh of tetrahedra merged. Plain C++17.
#ifndef nephoscope_EdgeMerging_h
#define nephoscope_EdgeMerging_h

#include "StreakMesh.h"

#include <cstddef>

namespace nephoscope
{
struct MergingLimits
{
  double MinimumEdgeLength = 0.0; // shorter edges are merged; 0: none
  double MaximumEdgeLength = 0.0; // no edge becomes longer; 0: any
};

// The shortest edges first, one end moves to the other, and the tetrahedra at the edge vanish. The
// tetrahedra that are left at the point that moves share the mass by volume, so that no density
// exceeds those before. An edge stays whole if a tetrahedron would turn over or become a sliver; if
// sheets would be glued together; if the surface would bend by more than 5 degrees, or the volume
// change by more than 0.1 %; or if the front would change. Edges whose neighbourhood has changed
// wait for the next call. Returns the number of merged edges.
std::size_t MergeShortEdges(StreakMesh& mesh, const MergingLimits& limits);
}

#endif
