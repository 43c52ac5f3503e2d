// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ways to the sun through the tetrahedra of a structured grid (ChessboardGrid.h), found from
 * indices alone. Its first axis may close on itself, and the rows at its ends may be poles. Or the
 * grid repeats beyond its sides. Plain C++17.
 */
#ifndef nephoscope_GridRays_h
#define nephoscope_GridRays_h

#include "ChessboardGrid.h"
#include "SunFrame.h"

#include <utility>
#include <vector>

namespace nephoscope
{
class GridRays : public SunPathsOfPoints
{
public:
  /** Cells that are hidden let light through; empty: none are. */
  GridRays(const ChessboardGrid& grid, std::vector<bool> hidden)
    : Grid(grid)
    , Hidden(std::move(hidden))
  {
  }

  /**
   * Finds seam and poles. False if points coincide elsewhere, or cells do not fit at the seam. No
   * points in `merged`: none coincide.
   */
  bool Connect(const std::vector<std::int32_t>& merged);

  /**
   * The grid repeats along the first and the second axis: its last points are the first ones of the
   * next copy. These axes need an even number of cells.
   */
  void Repeat() { this->Closed[0] = this->Closed[1] = this->IsRepeated = true; }

  void Turn(std::vector<SunPoint> points);

  std::array<double, 2> DepthsFrom(std::int32_t point) const override;

private:
  struct Path;
  using Index = std::array<int, 3>;

  static std::vector<bool> FindPoles(
    const ChessboardGrid& grid, const std::vector<std::int32_t>& merged);
  bool IsFitting(const std::vector<std::int32_t>& merged) const;
  bool IsPole(const Index& at) const;
  bool HasPoint(int index, int axis) const;
  int Wrapped(int index, int axis) const;
  SunPoint PointAt(const Index& at) const;
  void Follow(Path& path) const;
  double SizeAt(const Index& at) const;
  bool Begin(std::int32_t point, Path& path) const;
  bool BeginBeside(const Index& at, Path& path) const;
  bool BeginIn(const Index& at, const Index& side, Path& path) const;

  bool IsHidden(std::int64_t cell) const { return !this->Hidden.empty() && this->Hidden[cell]; }

  ChessboardGrid Grid;
  std::vector<bool> Hidden;
  std::vector<SunPoint> Points;
  LastClouds Clouds;
  std::array<bool, 3> Closed{ { false, false, false } };
  bool IsRepeated = false;
  std::array<std::array<double, 3>, 2>
    Periods{};             ///< from the first to the last point, if it is repeated
  std::vector<bool> Poles; ///< of the first and the last row of each level
};
}

#endif
