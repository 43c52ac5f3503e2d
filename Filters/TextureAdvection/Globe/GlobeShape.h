// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A structured grid on a globe or a map, recognised by its points: its columns, rows and levels,
// and its winds as GlobeWinds.
#ifndef nephoscope_GlobeShape_h
#define nephoscope_GlobeShape_h

#include "GlobeWinds.h"

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkStructuredGrid;

namespace nephoscope
{
enum class GridKind
{
  Automatic, // what vtkGlobeGrid says in the field data; without, a globe if the points are on one,
             // else neither
  Globe,     // centred at the origin, the axis is z
  Map,       // plate carree: x = R longitude, y = R latitude in radians, z = height
  Cartesian
};

// The sources of a grid's winds.
struct GlobeInput
{
  vtkDataSet* Data = nullptr;
  vtkDataArray* Velocity = nullptr; // of the displayed positions, length/s
  // Another vertical coordinate than the displayed height, which rises with the levels, if Sign is
  // 1, or falls, if it is -1, and its rate following the air.
  vtkDataArray* Vertical = nullptr;
  vtkDataArray* VerticalRate = nullptr;
  double Sign = 1.0;
};

// East, north and up at a point, unit vectors.
struct LocalFrame
{
  double East[3];
  double North[3];
  double Up[3];
};

class GlobeShape
{
public:
  // False, and a sentence in `problem`, if the grid is not of the kind, or not on a globe.
  bool Recognize(vtkDataSet* data, GridKind kind, double planetRadius, std::string& problem);

  // Whether the columns and rows of another grid are the same.
  bool Fits(vtkDataSet* data) const;

  // Hidden points (below the ground), and points where the velocity is not finite, which are
  // counted in `missing`, take the wind of the nearest level of their column that has one, without
  // its upward part; a column without any is calm.
  GlobeWinds MakeWinds(const GlobeInput& input, std::int64_t& missing) const;

  // A displayed position as a direction and a height above the reference radius.
  void PlaceOf(const double position[3], double direction[3], double& height) const;

  const GlobeColumns& Columns() const { return this->Columns_; }
  int Levels() const { return this->Size[2]; }
  bool IsMap() const { return this->OnMap; }
  double Radius() const { return this->Radius_; } // displayed, of height 0
  // The longitude of a column of the whole extent, radians, as the grid counts them, not reduced to
  // one turn.
  double LongitudeOf(int column) const;

private:
  bool RecognizeGlobe(vtkStructuredGrid* grid, std::string& problem);
  bool RecognizeMap(vtkStructuredGrid* grid, std::string& problem);
  bool AdoptAxes(
    std::vector<double> longitudes, std::vector<double> latitudes, std::string& problem);
  bool ReadWind(const GlobeInput& input, vtkIdType point, const LocalFrame& frame,
    std::size_t place, GlobeWinds& winds) const;
  void FillColumn(
    GlobeWinds& winds, const std::vector<unsigned char>& known, int column, int row) const;
  void FillPoleRows(GlobeWinds& winds) const;
  void FillPole(GlobeWinds& winds, int pole, int row, bool isData) const;
  void FillClosingColumn(GlobeWinds& winds) const;
  std::int64_t Index(int column, int row, int level) const;
  std::int64_t IndexOfData(int i, int j, int k) const;

  GlobeColumns Columns_;
  int Size[3] = { 0, 0, 0 };      // of the data, points
  std::vector<double> Longitudes; // of the data
  std::vector<double> Latitudes;
  int SouthRows = 0; // 1: a row at the pole has been added
  int NorthRows = 0;
  bool ColumnAdded = false; // the first one again
  bool OnMap = false;
  double Radius_ = 0.0;
};
}

#endif
