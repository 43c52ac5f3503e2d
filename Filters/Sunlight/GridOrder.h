// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An order of the points of a structured grid in which the third index counts upwards, and the first one closes on itself if any does: light does not
 * depend on how a grid is stored. Plain C++17.
 */
#ifndef nephoscope_GridOrder_h
#define nephoscope_GridOrder_h

#include "SunFrame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nephoscope
{
class GridOrder
{
public:
  using Sizes = std::array<int, 3>;

  GridOrder() = default;
  /** `upAt` gives the unit vector upwards at a place. */
  GridOrder(const Sizes& sizes, const std::vector<Place>& places,
    const std::function<Place(const Place&)>& upAt);

  const Sizes& GetSizes() const { return this->Ordered; }

  /** The number in the data of a point in this order. */
  std::size_t NumberOf(std::size_t point) const
  {
    return this->Numbers.empty() ? point : this->Numbers[point];
  }

  /** Values in this order; no values remain none. */
  template <typename T>
  std::vector<T> Of(const std::vector<T>& values) const
  {
    if (this->Numbers.empty() || values.empty())
    {
      return values;
    }
    std::vector<T> ordered(values.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      ordered[p] = values[this->Numbers[p]];
    }
    return ordered;
  }

private:
  std::size_t Stride(int axis) const;
  double Climb(int axis, const std::vector<Place>& places,
    const std::function<Place(const Place&)>& upAt) const;
  bool IsClosed(int axis, const std::vector<Place>& places) const;
  void Number(const std::array<int, 3>& axes, bool downwards);

  Sizes Stored{ { 0, 0, 0 } }, Ordered{ { 0, 0, 0 } };
  std::vector<std::int32_t> Numbers; ///< empty: as they are stored
};
}

#endif
