// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Short edges of a front merged, where streamlines converge. Plain C++17.
#ifndef nephoscope_FrontMerging_h
#define nephoscope_FrontMerging_h

#include "SlabTetrahedra.h"

namespace nephoscope
{
struct MergeLimits
{
  double Shortest = 0.0; // shorter edges are merged
  double Longest = 0.0;  // no edge gets longer by it; 0: any
};

// Merges edges of `above` that the step from `below` has made short: the two prisms beside one
// become pyramids, whose tops are lines. Moves the points that stay, names them in slab.TopOf and
// the changed triangles in slab.Patches. An edge is left as it is if a tetrahedron would turn
// inside out or a triangle would fold, if the boundary would change its form (it bends by more than
// 5 degrees there), or if a triangle beside it belongs to another merged edge. Returns the number
// of merged edges.
std::size_t MergeShortEdges(
  const SmokeFront& below, SmokeFront& above, const MergeLimits& limits, Slab& slab);

// Takes the triangles out that have become lines. The others of their patch share its mass as they
// share the flow, so the density of the patch is one. `chords`: how far each point of the front
// moved in the step.
void RemoveMergedTriangles(SmokeFront& above, const std::vector<Vector3>& chords, const Slab& slab);
}

#endif
