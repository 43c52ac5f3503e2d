// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A sorted list of contour values, and where a scalar lies among them.
 *
 * Values v[0] < v[1] < ... divide the line into layers: layer k lies between v[k-1] and v[k]. A
 * scalar has the code 2k inside layer k, and 2k + 1 on the value v[k], between layers k and k + 1.
 * Everything that follows is decided by comparing codes, so that two cells which share a vertex
 * cannot disagree.
 */
#ifndef nephoscope_ContourLevels_h
#define nephoscope_ContourLevels_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace nephoscope
{

class ContourLevels
{
public:
  /** Code of a scalar that is not a finite number. */
  static constexpr int MissingCode = -1;
  /**
   * Values that differ by less than this part of themselves are one value: a layer between them
   * would be nothing but rounding.
   */
  static constexpr double RelativeGap = 1e-12;

  ContourLevels() = default;
  /** In any order, with duplicates; all of them finite. */
  explicit ContourLevels(const std::vector<double>& values)
  {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    for (std::size_t i : order)
    {
      if (!this->Values.empty() && IsSame(this->Values.back(), values[i]))
      {
        continue;
      }
      this->Values.push_back(values[i]);
      this->Indices.push_back(static_cast<int>(i));
    }
  }

  int Size() const { return static_cast<int>(this->Values.size()); }
  double Value(int level) const { return this->Values[level]; }
  /** Where the value stood in the list given. */
  int Index(int level) const { return this->Indices[level]; }

  int Code(double scalar) const
  {
    if (!std::isfinite(scalar))
    {
      return MissingCode;
    }
    const auto found = std::lower_bound(this->Values.begin(), this->Values.end(), scalar);
    const int below = static_cast<int>(found - this->Values.begin());
    return 2 * below + (found != this->Values.end() && *found == scalar ? 1 : 0);
  }

  /** The value nearest to a scalar between two of them; -1 if there is no value. */
  int Nearest(double scalar) const
  {
    const auto found = std::lower_bound(this->Values.begin(), this->Values.end(), scalar);
    const int above = static_cast<int>(found - this->Values.begin());
    if (above == 0 || above == this->Size())
    {
      return std::min(above, this->Size() - 1);
    }
    return scalar - this->Values[above - 1] <= this->Values[above] - scalar ? above - 1 : above;
  }

private:
  static bool IsSame(double a, double b)
  {
    return b - a <= RelativeGap * std::max(std::abs(a), std::abs(b));
  }

  std::vector<double> Values;
  std::vector<int> Indices;
};

/**
 * Lowest and highest layer of what spans the codes from `least` to `largest`; lowest > highest if
 * all of it is on one value.
 */
constexpr int LowestLayer(int least)
{
  return (least + 1) / 2;
}
constexpr int HighestLayer(int largest)
{
  return largest / 2;
}
/** A value lies strictly between the codes. */
constexpr bool IsCrossed(int least, int largest)
{
  return LowestLayer(least) < HighestLayer(largest);
}

} // namespace nephoscope

#endif
