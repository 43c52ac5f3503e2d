// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSunlight
 * @brief   the light of sun and sky at every point of a cloudy atmosphere
 *
 *     any dataset with an extinction (vtkCloudOptics)  ->  vtkSunlight  ->  the same with its light as point arrays
 *
 * 1. From every point a way goes to the sun, from cell to cell; extinction is linear in each of their tetrahedra, as vtkCellCompositingMapper draws
 *    them. Where the way meets the planet there is night.
 * 2. Light that is scattered several times: discrete ordinates on structured grids, on an image of the same bounds for other data (DiffuseLight.h).
 *    The third index, or z, counts upwards. Above is the sky, below the ground, which reflects a part.
 * 3. The light that a point sends to the eye is its source function; a volume mapper does the rest (scalars Sunlight, opacities ScaledExtinction).
 *
 * Point arrays written, float; light of 1 is that of a white surface that faces the sun:
 * - Sunlight: pi times the source function, for an eye at ViewPosition, or the mean over all directions.
 * - ScaledExtinction, 1/m: the extinction without the light that goes straight on, to be drawn with Sunlight.
 * - SunTransmittance: the share of direct sunlight that arrives.
 * - Irradiance, UpwardIrradiance: of a horizontal surface, by sun and diffuse light from above, and by diffuse light from below.
 * - AbsorbedLight, 1/m: power that becomes heat, per volume; 0 with the sun's beam alone.
 *
 * Field data: SunDirection, three components, towards the sun.
 */
#ifndef vtkSunlight_h
#define vtkSunlight_h

#include "vtkDataSetAlgorithm.h"
#include "vtkNephoscopeFiltersSunlightModule.h" // for export macro

#include <array>  // for members
#include <memory> // for members
#include <string> // for array names
#include <vector> // for members

class VTKNEPHOSCOPEFILTERSSUNLIGHT_EXPORT vtkSunlight : public vtkDataSetAlgorithm
{
public:
  static vtkSunlight* New();
  vtkTypeMacro(vtkSunlight, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Direction towards the sun, in the coordinates of the data, with any length > 0. Default (1, -1, 1). Used where DateTime is empty. */
  vtkSetVector3Macro(SunDirection, double);
  vtkGetVector3Macro(SunDirection, double);
  ///@}

  ///@{
  /**
   * Date and time in UTC, such as "2011-10-11 18:30"; empty (default): SunDirection. On the globe of vtkGlobeGrid the sun is where it is then; elsewhere as seen
   * from Longitude and Latitude, with x to the east and y to the north.
   */
  vtkSetMacro(DateTime, std::string);
  vtkGetMacro(DateTime, std::string);
  ///@}

  ///@{
  /** Place in degrees east and north, from which the sun is seen at DateTime, where data are not on a globe. Default 0, 0. */
  vtkSetClampMacro(Longitude, double, -360.0, 360.0);
  vtkGetMacro(Longitude, double);
  vtkSetClampMacro(Latitude, double, -90.0, 90.0);
  vtkGetMacro(Latitude, double);
  ///@}

  ///@{
  /** Names of the arrays of the extinction (1/length of the data), of the single-scattering albedo and the asymmetry parameter. Cell arrays become point arrays. */
  vtkSetMacro(ExtinctionArrayName, std::string);
  vtkGetMacro(ExtinctionArrayName, std::string);
  vtkSetMacro(AlbedoArrayName, std::string);
  vtkGetMacro(AlbedoArrayName, std::string);
  vtkSetMacro(AsymmetryArrayName, std::string);
  vtkGetMacro(AsymmetryArrayName, std::string);
  ///@}

  ///@{
  /** Multiplies the extinction, 0 or more. Default 1. */
  vtkSetClampMacro(ExtinctionScale, double, 0.0, 1e30);
  vtkGetMacro(ExtinctionScale, double);
  ///@}

  ///@{
  /** Single-scattering albedo (0 to 1, default 1) and asymmetry parameter (-0.99 to 0.99, default 0.85) where there are no arrays of them. */
  vtkSetClampMacro(Albedo, double, 0.0, 1.0);
  vtkGetMacro(Albedo, double);
  vtkSetClampMacro(Asymmetry, double, -0.99, 0.99);
  vtkGetMacro(Asymmetry, double);
  ///@}

  ///@{
  /** Share of the light that the ground reflects, 0 to 1. Default 0.1. */
  vtkSetClampMacro(GroundAlbedo, double, 0.0, 1.0);
  vtkGetMacro(GroundAlbedo, double);
  ///@}

  ///@{
  /** Irradiance from the sky under an overhead sun, as a share of that of the sun, 0 or more; lower with the sun. Default 0.08. */
  vtkSetClampMacro(SkyLight, double, 0.0, 10.0);
  vtkGetMacro(SkyLight, double);
  ///@}

  ///@{
  /** Light that is scattered more than once. On by default; off, only the sun's beam is scattered, and the extinction is not scaled. */
  vtkSetMacro(MultipleScattering, bool);
  vtkGetMacro(MultipleScattering, bool);
  vtkBooleanMacro(MultipleScattering, bool);
  ///@}

  ///@{
  /** Zenith angles in each hemisphere (1 to 16) and azimuth angles (4 to 64) of diffuse light. Defaults 3 and 4; cost is their product. */
  vtkSetClampMacro(ZenithAngles, int, 1, 16);
  vtkGetMacro(ZenithAngles, int);
  vtkSetClampMacro(AzimuthAngles, int, 4, 64);
  vtkGetMacro(AzimuthAngles, int);
  ///@}

  ///@{
  /** Sunlight for an eye at ViewPosition (or, with ParallelView, far away in that direction), with the forward peak of cloud droplets. Off by default: the mean over all directions. */
  vtkSetMacro(UseViewPosition, bool);
  vtkGetMacro(UseViewPosition, bool);
  vtkBooleanMacro(UseViewPosition, bool);
  vtkSetMacro(ParallelView, bool);
  vtkGetMacro(ParallelView, bool);
  vtkBooleanMacro(ParallelView, bool);
  vtkSetVector3Macro(ViewPosition, double);
  vtkGetVector3Macro(ViewPosition, double);
  ///@}

  ///@{
  /** Iterations of the last execution, and the mean change in the last of them as a fraction of the mean fluence. */
  vtkGetMacro(NumberOfIterations, int);
  vtkGetMacro(LastChange, double);
  ///@}

protected:
  vtkSunlight();
  ~vtkSunlight() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSunlight(const vtkSunlight&) = delete;
  void operator=(const vtkSunlight&) = delete;

  struct Work;
  bool FindSun(vtkDataSet* data, std::array<double, 3>& sun);
  bool Check(vtkDataSet* data);
  bool Compute(vtkDataSet* data, Work& work);
  bool AddLight(vtkDataSet* data, vtkDataSet* input);
  bool ReadOptics(vtkDataSet* data, Work& work);
  bool TraceSun(vtkDataSet* data, Work& work);
  bool Diffuse(vtkDataSet* data, Work& work);
  bool Sample(vtkDataSet* data, Work& work);
  void Write(vtkDataSet* data, const Work& work);
  bool GoOn(double fraction);
  std::vector<double> State(vtkDataSet* input) const;

  std::string ExtinctionArrayName = "Extinction";
  std::string AlbedoArrayName = "SingleScatteringAlbedo";
  std::string AsymmetryArrayName = "AsymmetryParameter";
  std::string DateTime;
  double SunDirection[3] = { 1, -1, 1 };
  double Longitude = 0;
  double Latitude = 0;
  double ExtinctionScale = 1;
  double Albedo = 1;
  double Asymmetry = 0.85;
  double GroundAlbedo = 0.1;
  double SkyLight = 0.08;
  bool MultipleScattering = true;
  int ZenithAngles = 3;
  int AzimuthAngles = 4;
  bool UseViewPosition = false;
  bool ParallelView = false;
  double ViewPosition[3] = { 0, 0, 1 };
  int NumberOfIterations = 0;
  double LastChange = 0;
  std::unique_ptr<Work> Last;    // kept for another eye
  std::vector<double> LastState; // that it was computed for
};

#endif
