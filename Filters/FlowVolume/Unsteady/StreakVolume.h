// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume of the smoke that has been released from a polygon since a time, in a flow that
// changes. Plain C++17 but for the threads of AdvanceParticles.
//
// Layer k is the polygon released at time StartTime + k TimeStep and moved to
// the present by the flow (formulas of MaxCrawfisBecker1993 Sec. 6 hold layer
// by layer). When a layer is released, it is joined to the one before by
// prisms, each of three tetrahedra, whose mass is what has flown through its
// triangle in the meantime; then tetrahedra with long edges are bisected. Where
// the smoke turns at the polygon, there are more layers in between.
//
// The points are moved in steps that end at the release times and where AdvanceTo is told to stop.
// Volumes with the same stops are identical to the last bit.
#ifndef nephoscope_StreakVolume_h
#define nephoscope_StreakVolume_h

#include "PolygonFlow.h"
#include "StreakLoss.h"
#include "TurningPaths.h"

#include <cmath>

namespace nephoscope
{
struct StreakSettings
{
  double StartTime = 0.0;         // s, of the first release
  double TimeStep = 1.0;          // s between releases
  double Duration = 0.0;          // s after which smoke is dropped; 0: never
  double MaximumEdgeLength = 0.0; // 0: any
  // Shorter edges are merged; 0: never. More than a third of MaximumEdgeLength counts as a third.
  double MinimumEdgeLength = 0.0;
  // Radians that a path turns in a step, and the smoke at the polygon between
  // two layers. 0: any.
  double MaximumTurnAngle = 0.0;
  int MaximumHalvings = 4; // of a step or between two layers
  // Obstacles of this length or longer are found between the corners of tetrahedra; 0: at corners.
  double ObstacleSize = 0.0;
  double ObstacleEdge = 0.0;     // longest edge of a tetrahedron that ends at one; 0: any
  double FarthestObstacle = 0.0; // smoke that ends has met one if there are data again within this
                                 // length ahead of it
  bool Adaptive = false;
  double Tolerance = 1e-6; // of the adaptive method, a length
  std::size_t MaximumNumberOfTetrahedra = 1000000;
  int Releases = 0; // that will be in the volume together; their share of the tetrahedra is kept
                    // for them. 0: unknown
};

class StreakVolume
{
public:
  StreakVolume(const PolygonMesh& polygon, const StreakSettings& settings);

  // Up to rounding.
  bool IsAt(double time) const { return std::abs(time - this->Now) <= this->Rounding(); }
  bool IsAfter(double time) const { return this->Now > time + this->Rounding(); }

  // Moves the smoke to `time`, which has not passed. False if `progress`, called with a time,
  // requests a stop; the volume is then unusable.
  bool AdvanceTo(const VelocityField& field, double time, const ProgressFunction& progress);

  // As AdvanceTo, to the last time of release that is not after `time`.
  bool AdvanceToLastRelease(
    const VelocityField& field, double time, const ProgressFunction& progress);

  // To be called when the second field of a TemporalField has become the first of the next one.
  void TurnHints();

  // The smoke at the time that has been reached, with the part of a layer that is being released.
  SmokeMesh Mesh() const;

  double TimeStep() const { return this->Settings.TimeStep; }
  double MaximumEdgeLength() const { return this->Settings.MaximumEdgeLength; }

private:
  double EmittedMass() const;
  double ReleaseTime(int layer) const;
  double Rounding() const { return 1e-9 * this->Settings.TimeStep; }
  void Step(const VelocityField& field, double time);
  void Move(const VelocityField& field, double time);
  double TimeOfNextLayer(const VelocityField& field, double end);
  IntegrationSettings Integration() const;
  void Emit(const VelocityField& field, double time);
  void TakeVelocities(const PolygonVelocities& velocities);
  void ReleaseRegularLayer(const VelocityField& field);
  void ReleaseLayer(const VelocityField& field);
  StreakFront AddLayer(StreakMesh& smoke) const;
  StreakLoss JoinLayer(StreakMesh& smoke) const;
  void Lose(const VelocityField& field, const StreakLoss& loss);
  void EndSmoke(const VelocityField& field);
  void EndAtObstacles(const VelocityField& field);
  std::vector<unsigned char> FindBlocked(const VelocityField& field) const;
  void MergeTetrahedra();
  void BisectTetrahedra(std::size_t allowed);
  std::size_t Allowed(int layer) const;
  std::size_t AllowedBeforeRelease() const;

  PolygonMesh Polygon;
  std::vector<unsigned char> PolygonInside; // in all samples since the last release
  StreakSettings Settings;
  double Now;
  StreakMesh Smoke;
  int Layer = 0;                // number of the last regular layer that has been released
  double Released;              // s, when the last layer was
  std::vector<double> Emitting; // mass through the triangles since
  double Emitted = 0.0;         // mass of all prisms before
  double Lost = 0.0;
  double Obstacle = 0.0; // of that, at obstacles inside the data
  double Expired = 0.0;
  bool Full = false;
  bool Coarser = false; // longer edges, or smoke that turns more, for want of tetrahedra
};
}

#endif
