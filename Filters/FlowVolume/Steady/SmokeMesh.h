// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Input and output of the builders of flow volumes. Plain C++17, no VTK object.
#ifndef nephoscope_SmokeMesh_h
#define nephoscope_SmokeMesh_h

#include "PrismTetrahedra.h"
#include "VelocityField.h"

#include <cstdint>
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

// What became of a flow volume. Masses are those of smoke that has density 1 at the polygon.
struct SmokeReport
{
  double Flux =
    0.0; // volume per second through the triangles of the polygon, whichever way it goes
  double EmittedMass = 0.0;        // Flux times the time that was followed
  double KeptMass = 0.0;           // in the tetrahedra: the sum of density times volume
  double LostMass = 0.0;           // of triangles that ended: EmittedMass - KeptMass
  double ObstacleMass = 0.0;       // of that, at obstacles inside the data
  double FoldedMass = 0.0;         // steady: of that, of triangles that would have folded
  double ExpiredMass = 0.0;        // unsteady: of smoke older than the duration
  std::vector<double> MassPerStep; // kept, by EmissionStep
  std::size_t EndedTriangles =
    0; // at a boundary, an obstacle, a blanked cell or values that are not finite
  std::size_t HalvedEdges = 0;
  std::size_t MergedEdges = 0;
  std::size_t Layers = 0; // steps and parts of halved steps
  std::size_t FoldedTriangles =
    0; // of those: ended because they would have folded in the shortest step, too
  double FollowedTime = 0.0; // s, to where the volume was built
  std::size_t ParallelTriangles =
    0; // of the polygon: the flow crosses them both ways, or not at all; they emit nothing
  bool StartedOutside = false; // some of the polygon is outside the data
  bool LimitReached = false;   // MaximumNumberOfTetrahedra
  bool Coarser = false;        // unsteady: for want of tetrahedra, edges are longer or turn more
  bool Stopped = false;        // the progress function asked for it
};

// Tetrahedra of positive volume without cracks between them. Every point is used.
struct SmokeMesh
{
  std::vector<Vector3> Points;
  std::vector<double> PointAges; // s since the smoke there left the polygon
  std::vector<CellHint> Hints;   // where the points are in the field
  std::vector<TetrahedronPoints> Tetrahedra;
  std::vector<int> EmissionSteps;
  std::vector<double> Ages;           // s, in the middle of the step
  std::vector<double> Densities;      // relative to the density at the polygon
  std::vector<std::uint8_t> Ends;     // 1: a point where smoke ends before its time; empty: none
  std::vector<double> PointDensities; // as AverageDensities makes them; empty before
  SmokeReport Report;
};

// Forgets the points that no tetrahedron uses; the others keep their order.
void CompactPoints(SmokeMesh& mesh);

// Scales the densities of each emission step so that the sum of density times volume over its
// tetrahedra is Report.MassPerStep.
void ScaleDensities(SmokeMesh& mesh);

// A density that is continuous: that of the smoke in all tetrahedra at a point. Interpolated
// linearly in the tetrahedra, it has the mass of the densities of the tetrahedra, but for the smoke
// at Ends, where it fades to 0: triangles end at whole steps, which would show as edges.
void AverageDensities(SmokeMesh& mesh);

struct FlowVolumeSettings
{
  double Duration = 1.0; // s
  double TimeStep = 0.1; // s between layers
  // Longer edges of a layer are halved, down to this over 2 to the power EdgeLevels (1/64); 0: any
  // length.
  double MaximumEdgeLength = 0.0;
  int EdgeLevels = 6;
  // Shorter edges of a layer are merged; 0: never. More than a third of MaximumEdgeLength counts as
  // a third.
  double MinimumEdgeLength = 0.0;
  // Radians that a path turns in a step; 15 degrees. 0: any.
  double MaximumTurnAngle = 0.2617993877991494;
  // Factor by which the area of a triangle changes in a step, and divergence times the step; 0:
  // any.
  double MaximumAreaRatio = 2.0;
  double MaximumDivergence = 0.5;
  // A step is halved at most so often: into 16 parts.
  int MaximumHalvings = 4;
  // Triangles that meet an obstacle or a boundary are divided until their edges are shorter than
  // MaximumEdgeLength (without one: the longest edge of the polygon) over 2 to this power. 0:
  // never.
  int ObstacleLevels = 2;
  // Obstacles of this length or longer are found between the corners of
  // triangles and on the way of a step; 0: only where the corners, in the
  // stages of a step, meet them.
  double ObstacleSize = 0.0;
  // Smoke that ends has met an obstacle if there are data again within this
  // length ahead of it.
  double FarthestObstacle = 0.0;
  bool Adaptive = false;   // RK45 with error control instead of RK4
  double Tolerance = 1e-6; // of the adaptive method, relative to the edge length of the polygon
  std::size_t MaximumNumberOfTetrahedra = 1000000;
};

// Called with the completed fraction; returns false to stop.
using ProgressFunction = std::function<bool(double)>;
}

#endif
