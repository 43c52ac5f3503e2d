// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the builders of flow volumes take and make. Plain C++17, no VTK object.
#ifndef nephoscope_SmokeMesh_h
#define nephoscope_SmokeMesh_h

#include "PrismTetrahedra.h"
#include "VelocityField.h"

#include <functional>
#include <vector>

namespace nephoscope
{
// The generating polygon, divided into triangles that are counter-clockwise seen from downstream.
struct PolygonMesh
{
  std::vector<Vector3> Points;
  std::vector<std::array<PointId, 3>> Triangles;
};

// Tetrahedra of positive volume without cracks between them.
struct SmokeMesh
{
  std::vector<Vector3> Points;
  std::vector<double> PointAges; // s since the smoke there left the polygon
  std::vector<CellHint> Hints;   // where the points are in the field
  std::vector<TetrahedronPoints> Tetrahedra;
  std::vector<int> EmissionSteps;
  std::vector<double> Ages;      // s, in the middle of the step
  std::vector<double> Densities; // relative to the density at the polygon
};

struct FlowVolumeSettings
{
  double Duration = 1.0;          // s
  double TimeStep = 0.1;          // s between layers
  double MaximumEdgeLength = 0.0; // 0: any
  double MinimumEdgeLength = 0.0; // 0: edges are never merged
  double MaximumTurnAngle =
    0.2617993877991494;    // radians between the two halves of a step; 15 degrees
  bool Adaptive = false;   // RK45 with error control instead of RK4
  double Tolerance = 1e-6; // of the adaptive method, relative to the edge length of the polygon
  std::size_t MaximumNumberOfTetrahedra = 10000000;
};

// Told the share that is done; false asks to stop.
using ProgressFunction = std::function<bool(double)>;
}

#endif
