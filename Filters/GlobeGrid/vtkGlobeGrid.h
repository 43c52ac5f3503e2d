// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGlobeGrid
 * @brief   longitude-latitude-level fields as a curvilinear grid on a globe or a map
 *
 * Input port 0: a rectilinear, image or structured grid whose axes are longitude and latitude
 * (degrees) and level. Input port 1, optional: one level of surface pressure or terrain height.
 * Output: a vtkStructuredGrid in metres. The filter does this:
 *
 * 1. Read the axes: units of the levels, order of every axis, and whether the longitudes span the
 *    globe.
 * 2. Place the points. Globe: radius PlanetRadius + VerticalExaggeration * height. Map (plate
 *    carree): x = R * longitude, y = R * latitude (radians), z = VerticalExaggeration * height.
 *    Metres.
 * 3. Pass on every point and cell array, with an additional column if the seam is closed, and with
 *    missing rows at the poles.
 * 4. Convert the winds to vectors.
 * 5. Mark points below the ground.
 *
 * The output is always ordered west to east, south to north, bottom to top, whatever the order of
 * the input, so cells have positive volume. A row at a pole collapses to one point on the globe
 * (the hexahedra there are degenerate wedges), and its vectors are the Cartesian mean of the row.
 *
 * The height of a point comes from the array HeightArrayName (geopotential height in metres, or
 * geopotential if the reader reports the units m2 s-2), otherwise from the level axis, whose
 * pressures are converted to heights by the 1976 US standard atmosphere (StandardAtmosphere1976). A
 * level axis that the CF reader has negated (positive = "down") is understood.
 *
 * If the named arrays are on cells and not on points, the cell centres become the points.
 *
 * Point arrays written, besides those of the input:
 * - Wind, float, 3 components, m/s: the physical wind in the Cartesian frame of the output
 *   (u east + v north + w up). Only if both horizontal wind arrays exist.
 * - DisplayVelocity, float, 3 components, m/s in display space: the velocity of the displayed
 *   position of a parcel that moves with Wind, with projection and exaggeration applied. These are
 *   the active vectors.
 * - Height, float, m: physical height, without exaggeration.
 * - BelowGround, unsigned char, 1 below the ground, else 0. Only with MaskBelowGround.
 * - vtkGhostType, unsigned char: HIDDENPOINT is added below the ground and where height or wind is
 *   missing. Written only if there is such a point.
 *
 * Cell array written: vtkGhostType, unsigned char, HIDDENCELL on the cells that touch a hidden
 * point, so that nothing is drawn or advected there, whether a filter checks points or cells.
 *
 * Field data written, double, one value each: GlobeGridProjection (0 globe, 1 map), PlanetRadius
 * (m), VerticalExaggeration.
 *
 * Each piece requests the whole input and computes its own extent of the output.
 */
#ifndef vtkGlobeGrid_h
#define vtkGlobeGrid_h

#include "vtkNephoscopeFiltersGlobeGridModule.h" // for export macro
#include "vtkStructuredGridAlgorithm.h"

#include <string> // for array names

namespace nephoscope
{
class GlobeGridBuilder;
}

class VTKNEPHOSCOPEFILTERSGLOBEGRID_EXPORT vtkGlobeGrid : public vtkStructuredGridAlgorithm
{
public:
  static vtkGlobeGrid* New();
  vtkTypeMacro(vtkGlobeGrid, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ProjectionType
  {
    GLOBE = 0,
    MAP = 1
  };

  enum LevelUnitsType
  {
    AUTOMATIC = 0,
    PRESSURE_HPA = 1,
    PRESSURE_PA = 2,
    HEIGHT_M = 3,
    HEIGHT_KM = 4
  };

  ///@{
  /**
   * Globe (default) or plate carree map.
   */
  vtkSetClampMacro(Projection, int, GLOBE, MAP);
  vtkGetMacro(Projection, int);
  void SetProjectionToGlobe() { this->SetProjection(GLOBE); }
  void SetProjectionToMap() { this->SetProjection(MAP); }
  ///@}

  ///@{
  /**
   * Radius of the planet at height 0, in metres; greater than 0. Default 6371000 (the Earth's mean
   * radius).
   */
  vtkSetMacro(PlanetRadius, double);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /**
   * Multiplies heights in the display only, 0 or more; 0 gives a flat grid. Default 1. The
   * atmosphere is thin: values from 20 to 100 make clouds visible on a whole globe. DisplayVelocity
   * includes it, Wind does not.
   */
  vtkSetMacro(VerticalExaggeration, double);
  vtkGetMacro(VerticalExaggeration, double);
  ///@}

  ///@{
  /**
   * Map only: centres the map on CentralMeridian (degrees east, default 0). The columns of a global
   * grid are rotated; a regional grid is shifted by multiples of 360 degrees. Off by default: the
   * map keeps the longitudes of the input.
   */
  vtkSetMacro(UseCentralMeridian, bool);
  vtkGetMacro(UseCentralMeridian, bool);
  vtkBooleanMacro(UseCentralMeridian, bool);
  vtkSetMacro(CentralMeridian, double);
  vtkGetMacro(CentralMeridian, double);
  ///@}

  ///@{
  /**
   * Meaning of the level axis. Automatic (default): a negative axis is pressure that the reader
   * negated; a positive one is pressure in hPa if its largest value is within 500 to 1100, in Pa
   * within 50000 to 110000, unless the height array grows with it; otherwise it is height in
   * metres. A pressure axis that ends between 0.9 and 1.1 is a sigma or hybrid axis. Its heights
   * come from the height array, otherwise, with a warning, from the standard atmosphere over a
   * ground at 1013.25 hPa, as does the density in the conversion of omega.
   */
  vtkSetClampMacro(LevelUnits, int, AUTOMATIC, HEIGHT_KM);
  vtkGetMacro(LevelUnits, int);
  void SetLevelUnitsToAutomatic() { this->SetLevelUnits(AUTOMATIC); }
  void SetLevelUnitsToPressureHectopascal() { this->SetLevelUnits(PRESSURE_HPA); }
  void SetLevelUnitsToPressurePascal() { this->SetLevelUnits(PRESSURE_PA); }
  void SetLevelUnitsToHeightMetre() { this->SetLevelUnits(HEIGHT_M); }
  void SetLevelUnitsToHeightKilometre() { this->SetLevelUnits(HEIGHT_KM); }
  ///@}

  enum HeightUnitsType
  {
    AUTOMATIC_HEIGHT = 0,
    METRE = 1,
    KILOMETRE = 2,
    GEOPOTENTIAL = 3
  };

  enum WindComponentsType
  {
    AUTOMATIC_WIND = 0,
    EAST_NORTH = 1,
    ALONG_GRID = 2
  };

  ///@{
  /**
   * What the values of the height array are: metres, kilometres, or a geopotential in m2 s-2, which
   * is divided by 9.80665 m s-2.
   * Automatic (default): the units that the reader reports; if it reports none and the levels are
   * pressures, the units that fit the standard atmosphere best, with a warning if these are not
   * metres; otherwise metres.
   */
  vtkSetClampMacro(HeightUnits, int, AUTOMATIC_HEIGHT, GEOPOTENTIAL);
  vtkGetMacro(HeightUnits, int);
  void SetHeightUnitsToAutomatic() { this->SetHeightUnits(AUTOMATIC_HEIGHT); }
  void SetHeightUnitsToMetre() { this->SetHeightUnits(METRE); }
  void SetHeightUnitsToKilometre() { this->SetHeightUnits(KILOMETRE); }
  void SetHeightUnitsToGeopotential() { this->SetHeightUnits(GEOPOTENTIAL); }
  ///@}

  ///@{
  /**
   * Directions of the two horizontal wind arrays: east and north, or along and across the rows of a
   * curvilinear grid (GRIB: uvRelativeToGrid). Automatic (default): along the grid if the eastward
   * array is called x_wind or grid_eastward_wind, otherwise east and north, with a warning if the
   * rows do not follow parallels.
   */
  vtkSetClampMacro(WindComponents, int, AUTOMATIC_WIND, ALONG_GRID);
  vtkGetMacro(WindComponents, int);
  void SetWindComponentsToAutomatic() { this->SetWindComponents(AUTOMATIC_WIND); }
  void SetWindComponentsToEastNorth() { this->SetWindComponents(EAST_NORTH); }
  void SetWindComponentsToAlongGrid() { this->SetWindComponents(ALONG_GRID); }
  ///@}

  ///@{
  /**
   * Name of the point array of heights above sea level, in HeightUnits. Default "gh", or "zg" if
   * the input has no "gh". Without either, the level axis gives the heights.
   */
  vtkSetMacro(HeightArrayName, std::string);
  vtkGetMacro(HeightArrayName, std::string);
  ///@}

  ///@{
  /**
   * Names of the wind arrays: eastward and northward (m/s) and vertical (Pa/s or m/s, see
   * VerticalWindIsOmega). Default "u", "v", "w"; if the input has no such arrays, "ua", "va" and
   * "wap" (omega) or "wa" (m/s), or "U", "V" and "OMEGA" or "W", the names in CMIP and other
   * models. An empty vertical name means no vertical wind.
   */
  void SetWindArrayNames(
    const std::string& eastward, const std::string& northward, const std::string& vertical);
  vtkSetMacro(EastwardWindArrayName, std::string);
  vtkGetMacro(EastwardWindArrayName, std::string);
  vtkSetMacro(NorthwardWindArrayName, std::string);
  vtkGetMacro(NorthwardWindArrayName, std::string);
  vtkSetMacro(VerticalWindArrayName, std::string);
  vtkGetMacro(VerticalWindArrayName, std::string);
  ///@}

  ///@{
  /**
   * On (default): the vertical wind array is omega = dp/dt in Pa/s, positive downwards, and
   * w = -omega / (rho g). Off: it is the upward wind in m/s.
   */
  vtkSetMacro(VerticalWindIsOmega, bool);
  vtkGetMacro(VerticalWindIsOmega, bool);
  vtkBooleanMacro(VerticalWindIsOmega, bool);
  ///@}

  ///@{
  /**
   * Name of the point array of temperatures in kelvin, for the density in the conversion of omega.
   * Default "t", or "ta" if there is no "t". Without it the standard atmosphere gives the
   * temperature.
   */
  vtkSetMacro(TemperatureArrayName, std::string);
  vtkGetMacro(TemperatureArrayName, std::string);
  ///@}

  ///@{
  /**
   * On (default): repeats the first column of a global grid at its end to close the gap at the
   * seam. Regional grids, and grids that already repeat the column, stay unchanged.
   */
  vtkSetMacro(CloseSeam, bool);
  vtkGetMacro(CloseSeam, bool);
  vtkBooleanMacro(CloseSeam, bool);
  ///@}

  ///@{
  /**
   * On (default): closes the hole at a pole. A global grid that ends within one grid spacing of the
   * pole, as Gaussian and cell-centred grids do, gets a row there. Its scalars are the mean of the
   * last row (the median for integers). Its wind is the mean vector; the horizontal wind arrays
   * have the components of that vector at each meridian. Arrays of several components are treated
   * as Cartesian.
   */
  vtkSetMacro(ClosePoles, bool);
  vtkGetMacro(ClosePoles, bool);
  vtkBooleanMacro(ClosePoles, bool);
  ///@}

  ///@{
  /**
   * On (default): writes BelowGround and hides the points below the ground. A point is below the
   * ground if its pressure exceeds the surface pressure (SurfacePressureArrayName, Pa or hPa,
   * default "sp"); without that array, if it is lower than the terrain (TerrainHeightArrayName, m,
   * default "orog"); without that too, if it is below the sea level, except on a level axis of
   * heights. The arrays are looked for on port 1, then on port 0.
   */
  vtkSetMacro(MaskBelowGround, bool);
  vtkGetMacro(MaskBelowGround, bool);
  vtkBooleanMacro(MaskBelowGround, bool);
  vtkSetMacro(SurfacePressureArrayName, std::string);
  vtkGetMacro(SurfacePressureArrayName, std::string);
  vtkSetMacro(TerrainHeightArrayName, std::string);
  vtkGetMacro(TerrainHeightArrayName, std::string);
  ///@}

  ///@{
  /**
   * Port 1, optional: a grid of one level with the same longitudes and latitudes as port 0.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSurfaceData(vtkDataObject* data) { this->SetInputData(1, data); }
  void RemoveSurface() { this->SetInputConnection(1, nullptr); }
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkGlobeGrid();
  ~vtkGlobeGrid() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkGlobeGrid(const vtkGlobeGrid&) = delete;
  void operator=(const vtkGlobeGrid&) = delete;

  void AddProjection(vtkStructuredGrid* output);
  bool MakeGrid(vtkInformationVector** inputs, vtkInformationVector* outputs);
  bool BuildPiece(nephoscope::GlobeGridBuilder* builder, const int first[3],
    vtkInformation* outInfo, vtkStructuredGrid* output);

  int Projection = GLOBE;
  double PlanetRadius = 6371000.0;
  double VerticalExaggeration = 1.0;
  bool UseCentralMeridian = false;
  double CentralMeridian = 0.0;
  int LevelUnits = AUTOMATIC;
  std::string HeightArrayName = "gh";
  int HeightUnits = AUTOMATIC_HEIGHT;
  int WindComponents = AUTOMATIC_WIND;
  std::string EastwardWindArrayName = "u";
  std::string NorthwardWindArrayName = "v";
  std::string VerticalWindArrayName = "w";
  bool VerticalWindIsOmega = true;
  std::string TemperatureArrayName = "t";
  bool CloseSeam = true;
  bool ClosePoles = true;
  bool MaskBelowGround = true;
  std::string SurfacePressureArrayName = "sp";
  std::string TerrainHeightArrayName = "orog";
  vtkMTimeType Failed = 0;      // for ReportOnce
  vtkMTimeType ToldOfInput = 0; // for HasOtherInput
};

#endif
