// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A structured grid whose clouds repeat beyond its sides, as in models with periodic boundaries:
 * one copy of it, closed by the first points of the next one. If the values on opposite sides are
 * equal, these sides are the same points. Otherwise the next copy begins one grid spacing beyond
 * the last points.
 */
#ifndef nephoscope_RepeatedGrid_h
#define nephoscope_RepeatedGrid_h

#include "Planet.h"
#include "SunFrame.h"
#include "UprightOrder.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{
class RepeatedGrid
{
public:
  /**
   * Opposite sides are the same points if `sidesMeet`, or if `values` are equal on them. The third
   * index of the new grid counts upwards.
   */
  RepeatedGrid(vtkDataSet* data, const Planet& planet, const std::vector<Place>& places,
    const std::vector<float>& values, bool sidesMeet);

  /** False if the data are not a structured grid of three dimensions, or are on a globe. */
  bool Exists() const { return this->Grid != nullptr; }
  vtkStructuredGrid* GetGrid() const { return this->Grid; }

  /** Values at the points of this grid. Values of sides that are the same points are averaged. */
  std::vector<float> Of(std::vector<float> values) const;

  /** The numbers in this grid of the points of the data. */
  const std::vector<std::int32_t>& GetNumbers() const { return this->Numbers; }

private:
  using Index = std::array<int, 3>;
  bool AreEqual(int axis, const std::vector<float>& values) const;
  template <typename Body>
  void ForSides(int axis, Body body) const;
  std::size_t Number(const Index& at) const;
  Index Extent() const;
  Place Period(int axis, const std::vector<Place>& places) const;
  void Make(const std::vector<Place>& places);

  UprightOrder Order;
  Place Up{ { 0, 0, 1 } };
  Index Sizes{ { 0, 0, 0 } };                   // of the data
  std::array<bool, 2> Meet{ { false, false } }; // sides along an axis are the same points
  std::array<int, 2> Copies{ { 1, 1 } };        // to an even number of cells: tetrahedra fit
  vtkSmartPointer<vtkStructuredGrid> Grid;
  std::vector<std::size_t> Sources; // of points of this grid, in the ordered data
  std::vector<std::int32_t> Numbers;
};
}

#endif
