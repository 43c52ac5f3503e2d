// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The part of a picture that one of several processes draws.
 *
 * A process draws a splat in those pixels whose ray is in its region at the splat's distance from
 * the eye, and then all of the splat.
 * Along a ray regions come one after the other, and so do distances: pictures of regions that fill
 * space, laid over each other, show every splat once, and in the order in which one process draws
 * them. To cut kernels where regions end would not do that: of two that overlap there, each would
 * be in part behind the other.
 *
 * Near the border a process needs splats of its neighbours too: those whose reach
 * (SplatReachAround) enters its region.
 */
#ifndef nephoscope_SplatRegion_h
#define nephoscope_SplatRegion_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace nephoscope
{

/** Bounds as in VTK; they may be infinite. */
using SplatRegion = std::array<double, 6>;

constexpr SplatRegion WholeSpace{ { 1, -1, 1, -1, 1, -1 } }; ///< no region: invalid bounds

inline bool IsRegion(const SplatRegion& region)
{
  return region[0] <= region[1] && region[2] <= region[3] && region[4] <= region[5];
}

/** What processes that draw one picture agree on, so that they compute the same. */
struct SplatFrame
{
  std::optional<std::array<double, 3>>
    Origin;                   ///< of positions in float; none: the centre of the data
  double LongestEdge = 0;     ///< of the cells of all processes
  bool WithNeighbors = false; ///< draw duplicates, too

  bool operator==(const SplatFrame& other) const
  {
    return this->Origin == other.Origin && this->LongestEdge == other.LongestEdge &&
      this->WithNeighbors == other.WithNeighbors;
  }
};

/**
 * How far from its centre a splat counts in choosing processes, where nothing of it is seen farther
 * than `radius` from the centre: the place on a ray at the centre's distance from the eye is at
 * most twice as far from the centre as the ray is.
 */
inline double SplatReachAround(double radius)
{
  return 2.0 * radius;
}

/** Whether a ball touches a region. */
inline bool Touches(const SplatRegion& region, const double center[3], double radius)
{
  double square = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double outside =
      std::max({ region[2 * axis] - center[axis], center[axis] - region[2 * axis + 1], 0.0 });
    square += outside * outside;
  }
  return square <= radius * radius;
}

} // namespace nephoscope

#endif
