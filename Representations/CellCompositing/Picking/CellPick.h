// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a ray through cells and surfaces in them has lost a given part of its light: what a user
 * who points at a medium sees there.
 */
#ifndef nephoscope_CellPick_h
#define nephoscope_CellPick_h

#include "CellGeometry.h"
#include "TransferFunctionTable.h"

#include <functional>
#include <utility>
#include <vector>

namespace nephoscope
{

/** From `Start`, relative to the geometry's centre, to Start + Direction: 0 to 1. */
struct PickRay
{
  Vector3 Start, Direction;
  double Begin = 0, End = 1;
  double Length = 1; ///< of Direction, in the world
  Vector3 At(double parameter) const
  {
    return { { this->Start[0] + parameter * this->Direction[0],
      this->Start[1] + parameter * this->Direction[1],
      this->Start[2] + parameter * this->Direction[2] } };
  }
};

struct PickedCell
{
  std::int64_t Tetrahedron = -1; ///< -1: the ray is never so opaque
  std::int64_t Point = -1;       ///< its nearest vertex
  double Parameter = 0;          ///< along the ray
  double Scalar = 0;             ///< of colour, normalised
};

/** The medium as the mapper draws it. */
struct PickMedium
{
  const std::vector<TransferFunctionTable>& Tables;    ///< that the opacity is read from
  const std::vector<std::int32_t>& TablesOfTetrahedra; ///< empty: the first one for all
  double ExtinctionScale;                              ///< per length in the world
  /**
   * The normalised scalar of a cell that is not linear in its tetrahedra, at a place relative to
   * the geometry's centre. Empty: it is linear.
   */
  std::function<double(std::int64_t cell, const Vector3& place)> Scalar = {};
  /** The same for the opacity, if it has point scalars of its own. */
  std::function<double(std::int64_t cell, const Vector3& place)> OpacityScalar = {};
  /** A contour surface, which takes its opacity from a ray at once. */
  struct Surface
  {
    double Value, Opacity;
  };
  std::vector<Surface> Surfaces = {};
  const std::vector<float>* Contoured =
    nullptr; ///< of points; none: they are of the coloured array
};

/** The part of a ray in a tetrahedron. */
struct PickCrossing
{
  std::int64_t Tetrahedron;
  double Begin, End;
  Vector4 Weights, Slopes; ///< barycentric coordinates: Weights + parameter * Slopes
};

/**
 * Tells of most tetrahedra that the ray misses them: all vertices lie on one side of a plane
 * through the ray.
 */
class SidesOfRay
{
public:
  explicit SidesOfRay(const PickRay& ray);
  bool Miss(const std::array<Vector3, 4>& vertices) const;

private:
  Vector3 Start;
  std::array<Vector3, 2> Normals;
};

bool FindCrossing(const std::array<Vector3, 4>& vertices, const PickRay& ray, PickCrossing& c);

/** Crossings are walked in this order. */
inline bool IsBefore(const PickCrossing& a, const PickCrossing& b)
{
  return std::make_pair(a.Begin + a.End, a.Tetrahedron) <
    std::make_pair(b.Begin + b.End, b.Tetrahedron);
}

/**
 * Lessens the optical depth that is left by that of a crossing. Returns where none is left, or no
 * tetrahedron.
 */
PickedCell WalkCrossing(const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray,
  const PickCrossing& crossing, double& left);

/** The number of a tetrahedron among the values of cells: of a hexahedron or a cell of a grid. */
std::int64_t ValueNumber(const CellGeometry& geometry, std::int64_t tetrahedron);

/** The cell of the dataset. */
std::int64_t CellOfTetrahedron(const CellGeometry& geometry, std::int64_t tetrahedron);

PickedCell PickCell(
  const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray, double opticalDepth);

} // namespace nephoscope

#endif
