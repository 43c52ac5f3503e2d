// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes of the whole duration, however few tetrahedra they may have. Plain C++17.
#ifndef nephoscope_WholeVolume_h
#define nephoscope_WholeVolume_h

#include "StreakVolume.h"

namespace nephoscope
{
// The polygon as triangles with edges that are not longer; fewer of them, the longer the edges.
using PolygonMaker = std::function<PolygonMesh(double edge)>;

struct WholeVolume
{
  SmokeMesh Mesh;
  FlowVolumeSettings Settings; // with which it was built
  double PolygonEdgeLength = 0.0;
  bool IsCoarser = false; // than asked for
};

// BuildSteadyVolume again and again, coarser each time, until the volume of the whole duration has
// no more than MaximumNumberOfTetrahedra. What makes most of the tetrahedra is coarsened: edges
// that the flow stretches, else the triangles of the polygon if there are many, else the steps. A
// duration that cannot be reached ends early (mesh.Report.LimitReached).
//
// Where smoke would be lost by that, as in a thin shell of air that long triangles leave, a
// duration that `canBeShorter` is shortened to what could be followed.
WholeVolume BuildWholeVolume(const VelocityField& field, const PolygonMesh& polygon,
  const FlowVolumeSettings& settings, double time, bool canBeShorter, const PolygonMaker& remake,
  const ProgressFunction& progress);

// The same for unsteady smoke, before it is released: a polygon of fewer triangles or longer steps,
// so that the releases of the time that is `followed` take no more than half of the tetrahedra.
// Returns whether it is coarser than requested.
bool FitReleases(
  PolygonMesh& polygon, StreakSettings& settings, double followed, const PolygonMaker& remake);
}

#endif
