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
struct StreakMesh
{
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
  std::vector<unsigned char> Inside; // 0 from the moment a point has left the data
  std::vector<double> ReleaseTimes;  // s

  std::vector<TetrahedronPoints> Tetrahedra; // of either orientation: a flow may turn them over
  std::vector<double> Masses;                // density at the polygon times volume
  std::vector<int> EmissionSteps;

  PointId AddPoint(Vector3 position, CellHint hint, unsigned char inside, double releaseTime)
  {
    this->Positions.push_back(position);
    this->Hints.push_back(hint);
    this->Inside.push_back(inside);
    this->ReleaseTimes.push_back(releaseTime);
    return static_cast<PointId>(this->Positions.size()) - 1;
  }

  void AddTetrahedron(const TetrahedronPoints& points, double mass, int emissionStep)
  {
    this->Tetrahedra.push_back(points);
    this->Masses.push_back(mass);
    this->EmissionSteps.push_back(emissionStep);
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

  // Drops the points that no tetrahedron uses, except `count` from `first` on, which stay together.
  // Returns the new `first`.
  PointId DropUnusedPoints(PointId first, std::size_t count);
};
}

#endif
