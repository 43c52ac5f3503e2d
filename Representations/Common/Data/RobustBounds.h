// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Bounds of a medium without its stray parts: one particle far away must not set the lengths that
 * all others are drawn by.
 */
#ifndef nephoscope_RobustBounds_h
#define nephoscope_RobustBounds_h

#include "MediumMeasures.h"

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <functional>
#include <vector>

namespace nephoscope
{

/**
 * A place of the medium, how much of the medium it stands for, and for how many places. Those that
 * are not finite do not count.
 */
struct WeightedPlace
{
  double Place[3];
  double Weight;
  double Number;
};

/**
 * Weight of a cell, from its volume and its greatest length: its volume, but next to nothing for a
 * needle. One point far away makes needles of all cells around it, which would outweigh the others.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double WeightOfCell(double volume, double length);

/** Sums and bounds of all processes that share the medium; empty functions: of a single one. */
struct MediumReduction
{
  std::function<void(double* numbers, int count)> Sum = {};
  std::function<MediumBounds(const MediumBounds& mine)> Bounds = {};
};

constexpr MediumBounds WholeMedium = { { -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX,
  VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX } };

/** The number of positions that is enough for robust bounds. */
constexpr vtkIdType enoughPlaces = 10000;

VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT bool HoldsPlace(
  const MediumBounds& bounds, const double place[3]);

/**
 * The bounds of the medium, or of what lies near its bulk, if their diagonal is at most a quarter
 * as long. The bulk is the box that leaves a tenth of the weight on either side of every axis; near
 * means no farther from it than its own diagonal (after Tukey's fences), as nine tenths of all
 * places must be. Uniform and normal distributions have no stray part. `boundsWithin` gives the
 * bounds of this process inside a box; all processes must call.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT MediumBounds RobustBounds(
  const std::vector<WeightedPlace>& places,
  const std::function<MediumBounds(const MediumBounds& box)>& boundsWithin,
  const MediumReduction& over = {});

/**
 * The same of so many places that all count alike; `place` returns whether there is one with that
 * number.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT MediumBounds RobustBoundsOfPlaces(vtkIdType count,
  const std::function<bool(vtkIdType number, double* place)>& place,
  const MediumReduction& over = {});

} // namespace nephoscope

#endif
