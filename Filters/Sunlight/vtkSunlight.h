// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSunlight
 * @brief   the light of sun and sky at every point of a cloudy atmosphere
 *
 *     any dataset with an extinction (vtkCloudOptics)
 *         ->  vtkSunlight  ->  the same with its light as point arrays
 *
 * 1. Follow a ray from every point to the sun, from cell to cell; the extinction is linear in their
 *    tetrahedra, as in vtkCellCompositingMapper. A point whose ray meets the planet is on the night
 *    side.
 * 2. Compute multiple scattering by discrete ordinates, on structured grids or, for other data, on
 *    an image with the same bounds (DiffuseLight.h).
 *    The upward direction is Up, or away from the centre of a planet. The sky is above; the ground
 *    below reflects a fraction of the light.
 * 3. Write the source function, the light that a point sends to the eye. A volume mapper does the
 *    rest (scalars Sunlight, opacities ScaledExtinction).
 *
 * Point arrays written, float; a light of 1 is that of a white surface facing the sun:
 * - Sunlight: pi times the source function, for an eye at ViewPosition, or the mean over all
 *   directions.
 * - ScaledExtinction, 1/m: the extinction without light scattered straight forward, for drawing
 *   with Sunlight.
 * - SunTransmittance: the fraction of direct sunlight that arrives.
 * - Irradiance, UpwardIrradiance: irradiance of a horizontal surface, by sun and diffuse light from
 *   above, and by diffuse light from below.
 * - AbsorbedLight, 1/m: power that becomes heat, per volume; 0 if only the sun's beam is computed.
 *
 * FollowCamera adds arrays from which mappers compute the light towards the camera. With the
 * direction d of that light, and the two factors P and Q in PhaseFunction for the angle between d
 * and sunlight, it is Sunlight + d . DiffuseFlux + P2(d . up) DiffuseSecondMoment + (P - 1)
 * SingleScattering[0] + (Q - 1) SingleScattering[1].
 * - SingleScattering, two components: light of the sun's beam, times a quarter of the albedo,
 *   without a phase function: of light straight from the sun, and of light that has been scattered
 *   before, but straight forward.
 * - DiffuseFlux, three components, and DiffuseSecondMoment: the direction of the diffuse light, and
 *   how much of it comes from above and below rather than from the sides. P2 is the Legendre
 *   polynomial.
 * - PhaseFunction, field data: P and Q at angles from 0 to 180 degrees.
 *
 * Smoke, as vtkFlowVolume and vtkSmokePuffs write it, gets its own extinction, albedo and asymmetry
 * (SmokeOptics.h), unless another array is named.
 *
 * The second input is optional: lit clouds, in blocks or not, which cast shadows on the data. Light
 * that they scatter does not reach the data. With clouds, data without an extinction and without
 * three-dimensional cells, such as the ground, get the light that reaches them: Sunlight is then
 * the irradiance by sun, sky and the diffuse light of the clouds.
 *
 * The third input is optional: a vtkSunSource, which replaces SunDirection and DateTime.
 *
 * On several ranks, each computes the light of a whole image, rectilinear or structured grid and
 * keeps its piece, so that clouds of all ranks cast their shadows. The clouds of several blocks,
 * and other data of several ranks, are lit as one mesh, which each rank keeps whole. Blocks keep
 * their structure and get the light at their points. If only one block has clouds, it has the same
 * light as alone.
 *
 * Field data: SunDirection and Up, three components each, towards the sun and upwards from flat
 * ground. Data without a medium below clouds take the Up of these. WhiteLight: the light that a
 * display should show as white (WhiteLight.h).
 */
#ifndef vtkSunlight_h
#define vtkSunlight_h

#include "vtkDataSetAlgorithm.h"
#include "vtkNephoscopeFiltersSunlightModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <array>  // for members
#include <memory> // for members
#include <string> // for array names
#include <vector> // for members

namespace nephoscope
{
class BlocksWithArray;
struct CloudPart;
struct LightGrid;
struct Planet;
}

class VTKNEPHOSCOPEFILTERSSUNLIGHT_EXPORT vtkSunlight : public vtkDataSetAlgorithm
{
public:
  static vtkSunlight* New();
  vtkTypeMacro(vtkSunlight, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Disconnects the second input, the third input. */
  void RemoveClouds() { this->SetInputConnection(1, nullptr); }
  void RemoveSun() { this->SetInputConnection(2, nullptr); }
  ///@}

  ///@{
  /**
   * Direction towards the sun, in the coordinates of the data, with any length > 0. Default (1, -1,
   * 1). Used if DateTime is empty.
   */
  vtkSetVector3Macro(SunDirection, double);
  vtkGetVector3Macro(SunDirection, double);
  ///@}

  ///@{
  /**
   * Date and time in UTC, such as "2011-10-11 18:30"; empty (default): SunDirection. On the globe
   * of vtkGlobeGrid it gives the position of the sun; for other data the sun is as seen from
   * Longitude and Latitude, with x to the east and y to the north (see Up).
   */
  vtkSetMacro(DateTime, std::string);
  vtkGetMacro(DateTime, std::string);
  ///@}

  ///@{
  /**
   * The direction upwards from flat ground, in the coordinates of the data, with any length > 0; on
   * a globe up is away from its centre. With DateTime, x points east and y north, turned with z the
   * shortest way to Up: where y is up, -z points north. Default (0, 0, 1).
   */
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Longitude and latitude (degrees east and north) of the observer for whom the sun is computed at
   * DateTime, if the data are not on a globe. Default 0, 0.
   */
  vtkSetClampMacro(Longitude, double, -360.0, 360.0);
  vtkGetMacro(Longitude, double);
  vtkSetClampMacro(Latitude, double, -90.0, 90.0);
  vtkGetMacro(Latitude, double);
  ///@}

  ///@{
  /**
   * Names of the arrays of the extinction (1/length of the data), of the single-scattering albedo
   * and the asymmetry parameter. Cell arrays become point arrays.
   */
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
  /**
   * Single-scattering albedo (0 to 1, default 1) and asymmetry parameter (-0.99 to 0.99, default
   * 0.85), used without arrays of them.
   */
  vtkSetClampMacro(Albedo, double, 0.0, 1.0);
  vtkGetMacro(Albedo, double);
  vtkSetClampMacro(Asymmetry, double, -0.99, 0.99);
  vtkGetMacro(Asymmetry, double);
  ///@}

  ///@{
  /** Fraction of the light that the ground reflects, 0 to 1. Default 0.1. */
  vtkSetClampMacro(GroundAlbedo, double, 0.0, 1.0);
  vtkGetMacro(GroundAlbedo, double);
  ///@}

  ///@{
  /**
   * Irradiance from the sky under an overhead sun, as a fraction of the sun's irradiance, 0 or
   * more; it decreases as the sun sinks. Default 0.08.
   */
  vtkSetClampMacro(SkyLight, double, 0.0, 10.0);
  vtkGetMacro(SkyLight, double);
  ///@}

  ///@{
  /**
   * The clouds of an image, a rectilinear or a structured grid repeat beyond its sides, as in
   * models with periodic boundaries. The copies cast shadows into the grid and scatter light into
   * it. If the extinction is equal on opposite sides, these sides count as the same points.
   * Otherwise the next copy begins one grid spacing beyond the last points. Off by default: no
   * shadows come from beyond the sides, which are mirrors for diffuse light or open (OpenSides).
   * Not for globes and unstructured data.
   */
  vtkSetMacro(PeriodicSides, bool);
  vtkGetMacro(PeriodicSides, bool);
  vtkBooleanMacro(PeriodicSides, bool);
  ///@}

  ///@{
  /**
   * Diffuse light leaves through the sides of the data, and only the light of sun and sky enters
   * there: for clouds that are alone in a box that fits tightly. Off by default: the sides are
   * mirrors for diffuse light, as if the clouds continued beyond them. Grids that close around,
   * such as globes of all longitudes, have no open sides. PeriodicSides takes precedence.
   */
  vtkSetMacro(OpenSides, bool);
  vtkGetMacro(OpenSides, bool);
  vtkBooleanMacro(OpenSides, bool);
  ///@}

  ///@{
  /**
   * Includes light that is scattered more than once. On by default. Off: only the sun's beam is
   * scattered, and the extinction is not scaled.
   */
  vtkSetMacro(MultipleScattering, bool);
  vtkGetMacro(MultipleScattering, bool);
  vtkBooleanMacro(MultipleScattering, bool);
  ///@}

  ///@{
  /**
   * Number of zenith angles in each hemisphere (1 to 16) and of azimuth angles (4 to 64) of the
   * diffuse light. Zenith angles with larger solid angles have twice as many azimuth angles.
   * Default 0, automatic: 6 and 8 for grids of up to 20,000 points, 4 and 6 up to 120,000, else 3
   * and 4.
   */
  vtkSetClampMacro(ZenithAngles, int, 0, 16);
  vtkGetMacro(ZenithAngles, int);
  virtual void SetAzimuthAngles(int count);
  vtkGetMacro(AzimuthAngles, int);
  ///@}

  ///@{
  /**
   * Computes Sunlight for an eye at ViewPosition (or, with ParallelView, far away in that
   * direction), with the forward peak of cloud droplets. Off by default: the mean over all
   * directions.
   */
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
  /**
   * Keeps the light that depends on the direction of view in separate arrays, so that mappers draw
   * the light for the camera of each frame without a new computation. Sunlight is then the mean
   * over all directions, and UseViewPosition is ignored. Off by default.
   */
  vtkSetMacro(FollowCamera, bool);
  vtkGetMacro(FollowCamera, bool);
  vtkBooleanMacro(FollowCamera, bool);
  ///@}

  /**
   * Phase functions of FollowCamera: that of Henyey and Greenstein with the mean asymmetry
   * parameter of the data, a sum of two of these, or a table for cloud droplets.
   */
  enum
  {
    HENYEY_GREENSTEIN,
    DOUBLE_HENYEY_GREENSTEIN,
    CLOUD_DROPLETS
  };
  ///@{
  /**
   * The distribution of light scattered from the sun's beam over directions.
   * DOUBLE_HENYEY_GREENSTEIN and CLOUD_DROPLETS (Mie, effective radius 10 micrometres, with fogbow
   * and glory) are for water droplets, whatever the asymmetry parameter is. Default
   * HENYEY_GREENSTEIN.
   */
  vtkSetClampMacro(PhaseFunction, int, HENYEY_GREENSTEIN, CLOUD_DROPLETS);
  vtkGetMacro(PhaseFunction, int);
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HENYEY_GREENSTEIN); }
  void SetPhaseFunctionToDoubleHenyeyGreenstein()
  {
    this->SetPhaseFunction(DOUBLE_HENYEY_GREENSTEIN);
  }
  void SetPhaseFunctionToCloudDroplets() { this->SetPhaseFunction(CLOUD_DROPLETS); }
  ///@}

  ///@{
  /**
   * Iterations of the last execution, and the mean change in the last of them as a fraction of the
   * mean fluence.
   */
  vtkGetMacro(NumberOfIterations, int);
  vtkGetMacro(LastChange, double);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkSunlight();
  ~vtkSunlight() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSunlight(const vtkSunlight&) = delete;
  void operator=(const vtkSunlight&) = delete;

  struct Work;
  struct Joint;
  bool FindSun(vtkDataSet* data, std::array<double, 3>& sun);
  void WarnOfPlace(
    vtkDataSet* data, const std::array<double, 3>& sun, const std::array<double, 3>& sunOnGlobe);
  bool Check(vtkDataSet* data);
  bool CheckUp();
  nephoscope::Planet PlanetOf(vtkDataSet* data);
  bool HasExtinction(vtkDataSet* data) const;
  void TakeForClearAir(vtkDataSet* data);
  bool IsSurfaceBelowClouds(vtkDataSet* data);
  double PhaseTowardsEye(const Work& work, std::size_t p, double cosine) const;
  float SkyAt(const std::array<double, 3>& place, const Work& work) const;
  void ChooseExtinction(vtkDataSet* data);
  bool Compute(vtkDataSet* data, Work& work);
  bool ComputeLight(vtkDataSet* data, Work& work);
  bool AddLight(vtkDataSet* data, vtkDataSet* input);
  void ReadOptics(vtkDataSet* data, Work& work);
  void ScaleOptics(Work& work) const;
  bool TraceSun(vtkDataSet* data, Work& work);
  bool Light(vtkDataSet* data, Work& work);
  bool LightRepeated(vtkDataSet* data, Work& work);
  bool Diffuse(vtkDataSet* data, Work& work);
  bool Sample(vtkDataSet* data, Work& work);
  void Write(vtkDataSet* data, const Work& work);
  bool GoOn(double fraction);
  bool Shade(Work& work);
  void CropToPiece(vtkDataSet* data, vtkInformation* input, vtkInformation* output);
  void JoinClouds();
  void JoinShadingClouds();
  vtkDataSet* ShadingClouds();
  nephoscope::CloudPart PartOf(vtkDataSet* data);
  nephoscope::CloudPart* FindPart(vtkDataSet* input);
  bool ComputeJoint();
  bool AddJointLight(vtkDataSet* data, nephoscope::CloudPart& part);
  void WarnOfValues(vtkIdType wrong);
  void WarnOfOtherSun(const Work& work);
  void WarnOfLight(vtkDataSet* data, const Work& work);
  void WarnOfDepth(vtkDataSet* data, const Work& work);
  void WarnOfSides(const nephoscope::LightGrid& grid);
  void WarnOfPieces(vtkDataSet* data, vtkInformation* information);
  std::vector<double> State() const;

  std::string ExtinctionArrayName = "Extinction";
  std::string AlbedoArrayName = "SingleScatteringAlbedo";
  std::string AsymmetryArrayName = "AsymmetryParameter";
  std::string UsedExtinction; // of smoke its own
  std::string DateTime;
  double SunDirection[3] = { 1, -1, 1 };
  double Up[3] = { 0, 0, 1 };
  double Longitude = 0;
  double Latitude = 0;
  double ExtinctionScale = 1;
  double Albedo = 1;
  double Asymmetry = 0.85;
  double GroundAlbedo = 0.1;
  double SkyLight = 0.08;
  bool PeriodicSides = false;
  bool OpenSides = false;
  bool MultipleScattering = true;
  int ZenithAngles = 0;
  int AzimuthAngles = 0;
  bool UseViewPosition = false;
  bool ParallelView = false;
  bool FollowCamera = false;
  int PhaseFunction = HENYEY_GREENSTEIN;
  double ViewPosition[3] = { 0, 0, 1 };
  int NumberOfIterations = 0;
  double LastChange = 0;
  bool ToldOfPieces = false, ToldOfPlace = false;
  bool OnSurface = false;                              // without a medium, below clouds
  bool OnCells = false;                                // the extinction is on cells
  vtkMTimeType ToldOfEmptiness = 0, Failed = 0;        // for IsEmptyInput and ReportOnce
  vtkMTimeType ToldOfInput = 0;                        // for HasOtherInput
  std::unique_ptr<nephoscope::BlocksWithArray> Blocks; // some may lack the array
  std::unique_ptr<Work> Last;                          // kept for another eye
  std::vector<double> LastState;                       // that it was computed for
  std::unique_ptr<Joint> Joined;                       // of several blocks or ranks
  vtkSmartPointer<vtkDataSet> JoinedShading;           // likewise, of the second input
  double ColumnOfRanks = 0;                            // SmokeColumn; 0: each dataset has its own
};

#endif
