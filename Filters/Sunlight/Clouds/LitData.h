// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A dataset made ready for light: its optical properties, its tetrahedra, its grid with the axes of
// each point.
#ifndef nephoscope_LitData_h
#define nephoscope_LitData_h

#include "LightGrid.h"
#include "Planet.h"
#include "SunFrame.h"
#include "UprightOrder.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace nephoscope
{
struct OpticalFields
{
  std::vector<float> Extinction, Albedo, Asymmetry;
};

/**
 * Values of the array on points; `otherwise` where there is none. NaN and negative values become 0
 * and are counted.
 */
std::vector<float> ValuesOf(
  vtkDataSet* data, const std::string& name, double otherwise, double scale, vtkIdType& wrong);

std::vector<Place> PlacesOf(vtkDataSet* data);

/** Whether any cell is three-dimensional. */
bool HasCellsInSpace(vtkDataSet* data);

/**
 * Ways to the sun; the fields are those that depths are integrals of. `repeats`: the data are the
 * grid of a RepeatedGrid.
 */
std::unique_ptr<SunPaths> SunPathsOf(vtkDataSet* data, const std::vector<Place>& places,
  const std::vector<Fields>& fields, const Place& sun, bool repeats = false);

/** The points in the order of a LightGrid, and the axes of each: unit vectors along the indices. */
struct GridAxes
{
  UprightOrder Order;
  std::vector<std::array<Vector, 3>> Axes;
};

/** True for structured data; then the grid has sizes, steps and seam. */
bool MakeGrid(vtkDataSet* data, const Planet& planet, const std::vector<Place>& places,
  LightGrid& grid, GridAxes& axes);

/**
 * Coordinates whose third counts upwards: along the horizon of flat ground, or on a globe longitude
 * and latitude in radians and the distance from the centre.
 */
class SampleFrame
{
public:
  SampleFrame(const Planet& planet, const std::vector<Place>& places);

  Place FromPlace(const Place& place) const;
  Place ToPlace(const Place& coordinates) const;

  /**
   * An image of about `points` points around the places, in these coordinates. With clear sides it
   * has margins as wide as it is high, or half as wide as it is if that is less.
   */
  vtkSmartPointer<vtkImageData> MakeImage(
    const std::vector<Place>& places, double points, bool hasClearSides) const;

  /** The data, with their arrays, at the points of the image. */
  vtkSmartPointer<vtkDataSet> Sampled(vtkDataSet* data, vtkImageData* image) const;

  /**
   * Whether the data fill at least half of the sides of the image. A part of larger clouds does;
   * clouds cut out of clear air do not.
   */
  static bool FillSides(vtkDataSet* sampled, vtkImageData* image);

private:
  bool IsOnGlobe() const { return this->Ground.Radius > 0; }

  Planet Ground;
  std::array<Place, 3> Horizon;
  double Middle = 0; // longitude
};
}

#endif
