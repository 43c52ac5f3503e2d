// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds the points, the winds and the mask of vtkGlobeGrid, row by row in parallel.
//
//   Plan()       units of levels and heights, order of the axes, seam, poles    -> GridOrder
//   Build()      pass 1 points and heights, pass 2 carried arrays, pass 3 winds, pass 4 mask
//   Warnings()   what was missing, counted, with the remedy
#ifndef nephoscope_GlobeGridBuilder_h
#define nephoscope_GlobeGridBuilder_h

#include "Geodesy.h"
#include "GridOrder.h"
#include "HeightUnits.h"
#include "LevelAxis.h"
#include "LonLatLevelGrid.h"

#include "vtkSmartPointer.h"

#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFieldData;
class vtkFloatArray;
class vtkStructuredGrid;

namespace nephoscope
{
// The directions of the two horizontal wind arrays.
enum class WindComponents
{
  Automatic, // east and north, unless their names say otherwise
  EastNorth,
  AlongGrid
};

struct GlobeGridSettings
{
  bool OnMap = false;
  geodesy::Planet Planet = { 6371000.0, 1.0 };
  bool UseCentralMeridian = false;
  double CentralMeridian = 0.0;
  LevelUnits Units = LevelUnits::Automatic;
  HeightUnits HeightsIn = HeightUnits::Automatic;
  WindComponents Components = WindComponents::Automatic;
  std::string Height, Eastward, Northward, Vertical, Temperature, SurfacePressure, TerrainHeight;
  bool VerticalIsOmega = true;
  bool CloseSeam = true;
  bool ClosePoles = true;
  bool MaskBelowGround = true;
};

// The columns alone, from any rows: enough to know their number in the output before any field is
// read.
GridOrder PlanColumns(const LonLatLevelGrid& grid, const GlobeGridSettings& settings);

// Whether the columns of the middle row surround the globe, so that poles can be closed.
bool SpansAllLongitudes(const LonLatLevelGrid& grid);

// The columns, the direction of the rows and the rows added at the poles.
GridOrder PlanRows(const LonLatLevelGrid& grid, const GlobeGridSettings& settings);

class GlobeGridBuilder
{
public:
  GlobeGridBuilder(const LonLatLevelGrid& grid, const GlobeGridSettings& settings)
    : Grid(grid)
    , Settings(settings)
  {
  }

  // Finds the arrays and the order of the axes. Returns the problem, or an empty string.
  std::string Plan(vtkFieldData* units, const LonLatLevelGrid* surface);

  // Fills the extent (relative to output index 0). `keepGoing(progress)` is called between the
  // passes.
  // Returns false if told to stop.
  bool Build(
    const int extent[6], vtkStructuredGrid* output, const std::function<bool(double)>& keepGoing);

  const GridOrder& Order() const { return this->Order_; }
  std::vector<std::string> Warnings() const;

private:
  void FindHeights(vtkFieldData* units);
  void FindLevelUnits();
  void FindHeightUnits(vtkFieldData* units);
  double RatioToStandardAtmosphere() const;
  void CheckAxes();
  void CheckHeights();
  void FindWindComponents();
  std::string FindWinds(vtkFieldData* units);
  void FindSurface(const LonLatLevelGrid* surface);
  bool SurfaceMatches(const LonLatLevelGrid& surface, const GridOrder& order) const;
  void OrderLevels();
  HeightTrend TrendOfHeights() const;

  std::array<double, 3> CoordinatesOf(const std::array<int, 3>& output) const;
  double HeightOf(vtkIdType id, double level, bool& missing) const;
  double RingHeight(int j, int k, bool& missing) const;
  double PressureOf(double level, double height) const;
  bool UpwardWind(vtkIdType id, double level, double height, double& w) const;
  bool WindOf(const std::array<int, 3>& input, const geodesy::Basis& basis, Vector3& wind) const;
  void WritePoleWind(vtkStructuredGrid* output, vtkIdType id, const Vector3& wind,
    const geodesy::Basis& basis) const;
  void TurnFromGrid(const std::array<int, 3>& input, double& u, double& v) const;
  bool PoleWind(int j, int k, Vector3& wind) const;
  bool IsBelowGround(const std::array<int, 3>& index) const;
  double SurfaceValue(vtkDataArray* values, const std::array<int, 3>& index) const;

  void PlacePoints(const int extent[6], vtkStructuredGrid* output);
  void AddWinds(const int extent[6], vtkStructuredGrid* output);
  void AddMask(const int extent[6], vtkStructuredGrid* output);

  const LonLatLevelGrid& Grid;
  const GlobeGridSettings& Settings;
  GridOrder Order_;
  LevelUnits Units = LevelUnits::Metre;
  vtkDataArray* Heights = nullptr;
  double HeightScale = 1.0;
  bool WindsAlongGrid = false;
  vtkDataArray* U = nullptr;
  vtkDataArray* V = nullptr;
  vtkDataArray* W = nullptr;
  vtkDataArray* Temperatures = nullptr;
  const LonLatLevelGrid* SurfaceGrid = nullptr;
  GridOrder SurfaceOrder;
  vtkDataArray* SurfacePressures = nullptr;
  double SurfacePressureScale = 1.0;
  vtkDataArray* TerrainHeights = nullptr;
  vtkSmartPointer<vtkFloatArray> HeightArray;
  std::vector<unsigned char> Hidden; // HiddenReason bits of each output point
  std::vector<std::string> Notes;
  vtkIdType MissingHeights = 0;
  vtkIdType MissingWinds = 0;
  mutable std::atomic<vtkIdType> DoubtfulTemperatures{ 0 };
};
}

#endif
