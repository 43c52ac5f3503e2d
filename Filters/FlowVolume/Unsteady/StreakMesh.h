// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Moving smoke: points that move with the flow, and tetrahedra between them that keep their mass.
// Plain C++17.
#ifndef nephoscope_StreakMesh_h
#define nephoscope_StreakMesh_h

#include "PrismTetrahedra.h"
#include "VelocityField.h"

#include <vector>

namespace nephoscope
{
struct HalvedEdge
{
  PointId A = 0; // smaller than B
  PointId B = 0;
  PointId Middle = 0;
};

// The layer that was released last, to which the next one will be joined:
// `Count` points from `First` on, and its edges that have been halved since, in
// their order.
struct StreakFront
{
  PointId First = 0;
  std::size_t Count = 0;
  std::vector<HalvedEdge> Halved;
};

struct StreakMesh
{
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
  std::vector<unsigned char> Inside; // 0 from the moment a point has left the data
  std::vector<double> ReleaseTimes;  // s
  std::vector<Vector3> Ways;         // of the last step of a point, along its path; zero: unknown
  std::vector<double> Steps;         // s, of those; 0: the way is a velocity

  std::vector<TetrahedronPoints> Tetrahedra; // of either orientation: a flow may turn them over
  std::vector<double> Masses;                // density at the polygon times volume
  std::vector<int> EmissionSteps;

  StreakFront Front;

  PointId AddPoint(Vector3 position, CellHint hint, unsigned char inside, double releaseTime)
  {
    this->Positions.push_back(position);
    this->Hints.push_back(hint);
    this->Inside.push_back(inside);
    this->ReleaseTimes.push_back(releaseTime);
    this->Ways.push_back(Vector3{});
    this->Steps.push_back(0.0);
    return static_cast<PointId>(this->Positions.size()) - 1;
  }

  // A point in the middle of an edge, in place and in release time.
  PointId AddMiddle(PointId a, PointId b);

  void AddTetrahedron(const TetrahedronPoints& points, double mass, int emissionStep)
  {
    this->Tetrahedra.push_back(points);
    this->Masses.push_back(mass);
    this->EmissionSteps.push_back(emissionStep);
  }

  bool IsInside(const TetrahedronPoints& tetrahedron) const
  {
    return std::all_of(tetrahedron.begin(), tetrahedron.end(),
      [this](PointId id) { return this->Inside[static_cast<std::size_t>(id)] != 0; });
  }

  // Keeps the tetrahedra t with keep(t), in their order.
  template <typename Keep>
  void Filter(Keep&& keep)
  {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
    {
      if (keep(t))
      {
        this->Tetrahedra[kept] = this->Tetrahedra[t];
        this->Masses[kept] = this->Masses[t];
        this->EmissionSteps[kept++] = this->EmissionSteps[t];
      }
    }
    this->Tetrahedra.resize(kept);
    this->Masses.resize(kept);
    this->EmissionSteps.resize(kept);
  }

  // Drops the points that neither a tetrahedron nor the front uses.
  void DropUnusedPoints();
};
}

#endif
