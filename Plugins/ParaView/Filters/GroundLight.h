// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The light that arrives at the ground of a globe, between the points of a grid.
#ifndef nephoscope_GroundLight_h
#define nephoscope_GroundLight_h

class vtkDataArray;
class vtkStructuredGrid;

namespace nephoscope
{

class GroundLight
{
public:
  /**
   * `lit`: the output of vtkSunlight for a grid of vtkGlobeGrid that covers the globe, its columns
   * and rows evenly spaced, from west to east. It must live as long as this object.
   */
  explicit GroundLight(vtkStructuredGrid* lit);

  /**
   * Irradiance at the lowest level, bilinear in longitude and latitude (radians); 1 is that of a
   * surface that faces the sun.
   */
  double At(double longitude, double latitude) const;

private:
  double Value(int column, int row) const;

  vtkDataArray* Irradiance;
  int Columns, Rows;
  double FirstLongitude, LongitudeStep, FirstLatitude, LatitudeStep;
};

}

#endif
