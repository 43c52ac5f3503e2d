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
#include <vector>

namespace nephoscope
{

/** From `Start`, relative to the geometry's centre, to Start + Direction: 0 to 1. */
struct PickRay
{
  Vector3 Start, Direction;
  double Begin = 0, End = 1;
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
  double ExtinctionScale;                              ///< per length of the ray
  /**
   * The normalised scalar of a cell that is not linear in its tetrahedra, at a parameter of the
   * ray. Empty: it is.
   */
  std::function<double(std::int64_t cell, double parameter)> Scalar = {};
  /** The same for the opacity, if it has point scalars of its own. */
  std::function<double(std::int64_t cell, double parameter)> OpacityScalar = {};
  /** A contour surface, which takes its opacity from a ray at once. */
  struct Surface
  {
    double Value, Opacity;
  };
  std::vector<Surface> Surfaces = {};
  const std::vector<float>* Contoured =
    nullptr; ///< of points; none: they are of the coloured array
};

/** The cell of the dataset. */
std::int64_t CellOfTetrahedron(const CellGeometry& geometry, std::int64_t tetrahedron);

PickedCell PickCell(
  const CellGeometry& geometry, const PickMedium& medium, const PickRay& ray, double opticalDepth);

} // namespace nephoscope

#endif
