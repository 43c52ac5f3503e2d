// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The drawing method of the splats in a sorted list, by their distance. */
#ifndef nephoscope_SplatRanges_h
#define nephoscope_SplatRanges_h

#include "SplatMatrix.h"
#include "SplatOrder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

class vtkMatrix4x4;

namespace nephoscope
{

struct SceneView;
class DepthTiles;
struct SplatDrawingOptions;
struct SplatSamples;

/** A ball around the largest splat of all, as it is seen. */
struct SplatReach
{
  double Radius = 1; ///< world length
  double PixelsPerSlope =
    1; ///< pixels over the tangent of the angle with the view direction; parallel: over the length
  double LargestSlope = 1; ///< that tangent in the corners of the viewport
  double LargestPoint = 1; ///< pixels across
};

/**
 * Splats at this distance or farther may be points: they are no larger than those, and far outside
 * of the eye.
 */
inline double PointDistance(const SplatReach& reach)
{
  const double stretch =
    1.0 + reach.LargestSlope * reach.LargestSlope; // across, of what is seen at an angle
  const double across = 2.2 * reach.Radius * reach.PixelsPerSlope * stretch;
  return std::max(4.0 * reach.Radius, across / reach.LargestPoint);
}

inline bool ParallelPoints(const SplatReach& reach)
{
  return 2.2 * reach.Radius * reach.PixelsPerSlope <= reach.LargestPoint;
}

/**
 * Splats at this distance or farther may be drawn to first order in radius / distance = e: what is
 * left out is at most 2 e^2 of a splat's peak, here 8.5e-5.
 */
inline double FirstOrderDistance(const SplatReach& reach)
{
  return reach.Radius / 0.0065;
}

/**
 * How much larger than a splat's parallelogram a square around it is, on a screen whose axes are x
 * and y; `jacobian` in view coordinates.
 */
inline double SquareExcess(const SplatMatrix& jacobian)
{
  double xx = 0.0, xy = 0.0, yy = 0.0; // second moments on the screen
  for (const Vector3& column : jacobian)
  {
    xx += column[0] * column[0];
    xy += column[0] * column[1];
    yy += column[1] * column[1];
  }
  const double determinant = std::max(xx * yy - xy * xy, 1e-12 * xx * yy);
  return determinant > 0.0 ? std::max(xx, yy) / std::sqrt(determinant) : 1.0;
}

/** The linear part of a transform, and of that to view coordinates. */
SplatMatrix LinearPart(vtkMatrix4x4* matrix);
SplatMatrix ToViewMatrix(const SceneView& view);

/** The metric of the world, for positions that such a matrix takes there. */
SplatMetric MetricOf(const SplatMatrix& toView);

/**
 * The drawn items from back to front: their positions, in an order, and the greatest stretch of
 * their Jacobians.
 */
struct SortedSplats
{
  const std::vector<std::array<float, 3>>& Places;
  const std::vector<std::int32_t>& Items;
  const std::vector<std::int32_t>& Order;
  double LongestEdge;
};

/**
 * Sets the numbers of splats in the options. Splats that are larger than any sample are away from
 * the eye. `pixels`: size of the viewport.
 */
void FindSplatRanges(const SortedSplats& splats, const SplatSamples& samples, const SceneView& view,
  const int pixels[2], SplatDrawingOptions& options);

/** Adds the drawn items to tiles. */
void AddSplats(const SortedSplats& splats, const SceneView& view,
  const SplatDrawingOptions& options, DepthTiles& tiles);

/** Sets which part of the order may be seen between two distances from the eye's plane. */
void FindSplatsBetween(const SortedSplats& splats, const SceneView& view,
  const std::array<double, 2>& distances, SplatDrawingOptions& options);

} // namespace nephoscope

#endif
