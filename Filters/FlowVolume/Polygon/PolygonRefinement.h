// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a generating polygon made small and well shaped. Plain C++17.
#ifndef nephoscope_PolygonRefinement_h
#define nephoscope_PolygonRefinement_h

#include "SmokeMesh.h"

namespace nephoscope
{
// Swaps the diagonals of neighbouring triangles until the angles opposite every inner edge sum to
// at most half a turn (Delaunay triangulation: Lawson1977), where the new edge is not longer than
// `longest` (0: any length).
void SwapToDelaunay(PolygonMesh& mesh, double longest);

// Halves longer edges, again and again, so that the triangles stay conforming, and improves their
// shape. False, and an unfinished mesh, if there would be more triangles than allowed.
bool HalveLongEdges(PolygonMesh& mesh, double longest, std::size_t maximumNumberOfTriangles);
}

#endif
