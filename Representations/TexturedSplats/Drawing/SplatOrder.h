// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Splats from back to front: a stable radix sort of their depths, by several threads. */
#ifndef nephoscope_SplatOrder_h
#define nephoscope_SplatOrder_h

#include "SplatMatrix.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

/**
 * Eye in the coordinates of the positions: (position, 1), or (direction towards the eye, 0) in a
 * parallel projection.
 */
using SplatEye = std::array<double, 4>;

/**
 * Where distances are not those of the positions: d . Metric d is the square of the length of a
 * difference d.
 */
using SplatMetric = SplatMatrix;
constexpr SplatMetric UnitMetric = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };

/**
 * The numbers 0 .. samples.size() - 1, farthest first: by the distance from the eye, in a parallel
 * projection by depth. Equal ones stay in the order of `samples`, so that the result depends on
 * neither threads nor the order of the input.
 */
std::vector<std::int32_t> OrderSplats(const std::vector<std::array<float, 3>>& positions,
  const std::vector<std::int32_t>& samples, const SplatEye& eye,
  const SplatMetric& metric = UnitMetric);

/**
 * How many of an order's last, nearest splats lie within `distance` of the eye; none in a parallel
 * projection.
 */
std::size_t CountNear(const std::vector<std::array<float, 3>>& positions,
  const std::vector<std::int32_t>& samples, const std::vector<std::int32_t>& order,
  const SplatEye& eye, double distance, const SplatMetric& metric = UnitMetric);

/**
 * Sorts `keys` ascending, stably; returns where each of them was. The keys themselves are used up.
 */
std::vector<std::int32_t> SortKeys(std::vector<std::uint32_t>& keys);

} // namespace nephoscope

#endif
