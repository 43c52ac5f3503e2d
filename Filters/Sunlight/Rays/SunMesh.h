// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ways to the sun through tetrahedra of any order: through the faces between them, and across gaps.
 * Plain C++17.
 */
#ifndef nephoscope_SunMesh_h
#define nephoscope_SunMesh_h

#include "EntryFaces.h"
#include "SunFrame.h"

namespace nephoscope
{
class SunMesh : public SunPathsOfPoints
{
public:
  using Tetrahedron = std::array<std::int32_t, 4>;

  /**
   * Tetrahedra with a vertex twice are left out. `merged` has the numbers of all points that stand
   * for them in tetrahedra.
   */
  SunMesh(std::vector<Tetrahedron> tetrahedra, std::vector<std::int32_t> merged);

  void Turn(std::vector<SunPoint> points);

  std::array<double, 2> DepthsFrom(std::int32_t point) const override;

private:
  struct Path;
  bool IsFlat(std::size_t tetrahedron) const;
  void FindNeighbours(std::size_t numberOfPoints);
  void FindTetrahedraOfPoints(std::size_t numberOfPoints);
  double SizeAt(std::int32_t point) const;
  bool Begin(std::int32_t point, Path& path) const;
  void Step(Path& path) const;
  bool Enter(Path& path) const;
  std::vector<EntryFaces::Face> FacesFromBelow() const;

  std::vector<std::int32_t> Merged;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<Tetrahedron> Neighbours; ///< across from each vertex; -1: none
  std::vector<std::int32_t> First, OfPoint;
  std::vector<SunPoint> Points;
  LastClouds Clouds;
  EntryFaces Entries;
};
}

#endif
