// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The input for placing haze: the bounds of a renderer's scene, and the field data of vtkGlobeGrid
 * in it.
 */
#ifndef nephoscope_HazeScene_h
#define nephoscope_HazeScene_h

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

class vtkRenderer;

namespace nephoscope
{

/** Replaces each number by the greatest of all ranks. */
using MaximumOfRanks = std::function<void(double* numbers, int count)>;

struct HazeScene
{
  double Low[3] = { infinity(), infinity(), infinity() };
  double High[3] = { -infinity(), -infinity(), -infinity() };
  double Eye[3] = { 0, 0, 0 };
  double GlobeGridProjection = -1; ///< 0 globe, 1 map, -1 not told
  double PlanetRadius = 0;         ///< 0: not told
  double VerticalExaggeration = 0; ///< 0: not told

  HazeScene() = default;
  /**
   * All visible props; of several that tell something the largest values count, whatever their
   * order.
   */
  explicit HazeScene(vtkRenderer* renderer);

  /** The scene of all ranks. */
  void Join(const MaximumOfRanks& maximum);

  bool IsEmpty() const { return !(this->Low[0] <= this->High[0]); }
  double Diagonal() const
  {
    return std::hypot(
      this->High[0] - this->Low[0], this->High[1] - this->Low[1], this->High[2] - this->Low[2]);
  }
  /**
   * From the origin to the farthest place of the bounds along an axis, in the mean of the three
   * axes.
   */
  double Reach() const
  {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
    {
      sum += std::max(std::abs(this->Low[c]), std::abs(this->High[c])) / 3;
    }
    return sum;
  }

private:
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }
};

} // namespace nephoscope

#endif
