// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tetrahedra as the sun sees them: x and y across its direction, z towards it. From any point the way to the sun goes along z, from tetrahedron to
 * tetrahedron through the faces between them. Extinction is linear in a tetrahedron, so that optical depths are exact. A path ends above the last cloud.
 * Plain C++17.
 */
#ifndef nephoscope_SunMesh_h
#define nephoscope_SunMesh_h

#include "ChessboardGrid.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace nephoscope
{
class SunMesh
{
public:
  using Place = std::array<double, 3>;
  using Tetrahedron = std::array<std::int32_t, 4>;
  /** Calls body(begin, end) for parts of [0, count), perhaps by several threads. */
  using Loop = std::function<void(
    std::int64_t count, const std::function<void(std::int64_t, std::int64_t)>& body)>;

  /** Tetrahedra with a vertex twice are left out. Points of a grid are in its order, so that their neighbours are found fast. */
  SunMesh(std::vector<Tetrahedron> tetrahedra, std::size_t numberOfPoints,
    const ChessboardGrid& grid, const Loop& loop);

  /** Positions in the frame of a sun in this direction, of length 1. */
  void Turn(const std::vector<Place>& places, const Place& towardsSun);

  /** Nothing dims light that goes away from the clouds: `fields` are 0 farther than so from the centre of a globe, or higher. */
  void FindCeiling(const std::vector<std::array<float, 2>>& fields, bool onGlobe);

  /** Integral of two linear fields from the point to the exit of the path from the mesh. */
  std::array<double, 2> DepthsFrom(
    std::int32_t point, const std::vector<std::array<float, 2>>& fields) const;

  std::size_t NumberOfTetrahedra() const { return this->Tetrahedra.size(); }

private:
  struct Ray;
  bool IsFlat(std::size_t tetrahedron) const;
  void FindNeighboursInGrid(const ChessboardGrid& grid, const Loop& loop);
  void FindOtherNeighbours(std::size_t numberOfPoints);
  void FindTetrahedraOfPoints(std::size_t numberOfPoints);
  bool Start(Ray& ray, std::int32_t point) const;
  void Walk(Ray& ray, const std::vector<std::array<float, 2>>& fields) const;
  double EndOfWay(double x, double y) const;
  double HeightOf(const Place& place) const;

  std::vector<Tetrahedron> Tetrahedra;
  std::vector<Tetrahedron> Neighbours; ///< across from each vertex; -1: none
  std::vector<std::int32_t> First, OfPoint;
  std::vector<Place> Places;
  Place Up{ { 0, 0, 1 } }; ///< in the frame of the sun
  bool OnGlobe = false;
  double Ceiling = 0;
};

/** Point numbers that are equal for coincident points: seams and poles. */
std::vector<std::int32_t> mergedPoints(const std::vector<SunMesh::Place>& places);
}

#endif
