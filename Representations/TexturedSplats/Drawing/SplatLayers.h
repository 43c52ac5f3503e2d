// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Splats in layers from back to front, in each of them first the scalars and then the vectors:
 * MaxCrawfisBecker1993, section 3.
 *
 * The layers of a structured grid are its samples with one index along an axis. Where that axis
 * points away from the eye, as on the far side of a globe, the layers come in the opposite order,
 * and before the others. Samples without a grid are in layers at right angles to the line of sight,
 * one cell thick.
 */
#ifndef nephoscope_SplatLayers_h
#define nephoscope_SplatLayers_h

#include "SplatOrder.h"

class vtkDataSet;

namespace nephoscope
{

struct SplatClasses;
struct SplatSamples;

class SplatLayers
{
public:
  /**
   * Axis of a grid: 0 to 2, or -1: the one that points most towards the eye; the last one if they
   * are about equal. Lengths and angles are those of the world, whose metric is given.
   */
  void Find(vtkDataSet* data, bool onCells, const SplatSamples& samples, const SplatEye& eye,
    const SplatMetric& metric, int axis);

  /** Thickness of the layers of samples without a grid, in the world. */
  static double Thickness(const SplatSamples& samples, const SplatMetric& metric);

  /**
   * `order`: splats from back to front, of which the last `near` stay at the end as they are. The
   * others come layer by layer: n for the scalar, ~n for the vector of splat n.
   */
  std::vector<std::int32_t> Alternate(
    const SplatClasses& classes, const std::vector<std::int32_t>& order, std::size_t near) const;

  /** The same splats without vectors. */
  std::vector<std::int32_t> Sort(
    const SplatClasses& classes, const std::vector<std::int32_t>& order, std::size_t near) const;

  /**
   * The axis of a grid along which cells are far shorter than along the others, and whose layers
   * rays cross far more often, on the mean: flat cells, seen from above or below. -1: none. Such
   * cells hide one another in the order of their layers, not in that of their distances: the next
   * column's lower cells are nearer than the upper ones of this column, but behind them.
   */
  static int FlatAxis(const SplatSamples& samples, const SplatEye& eye, const SplatMetric& metric);

private:
  std::vector<std::uint32_t> Layers; // of all samples, growing towards the eye
};

} // namespace nephoscope

#endif
