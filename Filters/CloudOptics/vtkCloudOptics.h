// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCloudOptics
 * @brief   extinction, albedo and asymmetry of clouds from the water of a weather model
 *
 *     any dataset: cloud water, temperature, pressure
 *         ->  vtkCloudOptics  ->  the same, with optical properties in visible light
 *
 * Each kind of water has the extinction of spheres much larger than the wavelength, beta = 3 q rho
 * / (2 rho_w r_e), with its density rho_w and effective radius r_e; q is a mass mixing ratio and
 * rho the density of the air. The kinds are added (ParticleOptics.h). Extinction is the mean over a
 * cell; with a cloud fraction, radii are computed from the water inside the clouds.
 *
 * Arrays are found by the names that models use, unless they are set; "none" leaves one out.
 * Without an array of pressure, it is in hydrostatic balance with heights and temperatures of the
 * columns of structured data, from the standard atmosphere at the lowest point; in data without
 * columns it is that of the standard atmosphere.
 *
 * Arrays written, float, on points, or on cells where the water is:
 * - Extinction, 1/m of the lengths in the data. If vtkGlobeGrid has exaggerated the heights, it is
 *   divided by the exaggeration, so that the vertical optical depth stays that of the model.
 * - SingleScatteringAlbedo, AsymmetryParameter: of the mixture.
 * - LiquidEffectiveRadius, IceEffectiveRadius, micrometres.
 * - OpticalDepthAbove, ColumnOpticalDepth: from a point to the top of its column, and from the
 *   lowest point of the column. Only on points of structured data, whose columns are along the
 *   index that counts upwards.
 */
#ifndef vtkCloudOptics_h
#define vtkCloudOptics_h

#include "vtkDataSetAlgorithm.h"
#include "vtkNephoscopeFiltersCloudOpticsModule.h" // for export macro

#include <array>  // for array names
#include <memory> // for members
#include <string> // for array names

namespace nephoscope
{
class BlocksWithArray;
}

class VTKNEPHOSCOPEFILTERSCLOUDOPTICS_EXPORT vtkCloudOptics : public vtkDataSetAlgorithm
{
public:
  static vtkCloudOptics* New();
  vtkTypeMacro(vtkCloudOptics, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum WaterUnitsType
  {
    AUTOMATIC = 0,
    MIXING_RATIO = 1,
    MIXING_RATIO_GRAMS = 2,
    CONTENT = 3,
    CONTENT_GRAMS = 4
  };

  enum RadiusType
  {
    PARAMETERIZED = 0,
    CONSTANT = 1
  };

  ///@{
  /**
   * Names of the arrays of cloud water: the sum of liquid and ice, of which the temperature
   * determines the ice fraction (all ice below -20 degrees Celsius, all liquid above 0, linear in
   * between), or liquid and ice; rain; snow. Empty (default) or "Automatic": found by name. The sum
   * is ignored if its parts are found.
   */
  vtkSetMacro(TotalWaterArrayName, std::string);
  vtkGetMacro(TotalWaterArrayName, std::string);
  vtkSetMacro(LiquidArrayName, std::string);
  vtkGetMacro(LiquidArrayName, std::string);
  vtkSetMacro(IceArrayName, std::string);
  vtkGetMacro(IceArrayName, std::string);
  vtkSetMacro(RainArrayName, std::string);
  vtkGetMacro(RainArrayName, std::string);
  vtkSetMacro(SnowArrayName, std::string);
  vtkGetMacro(SnowArrayName, std::string);
  ///@}

  ///@{
  /**
   * Names of the arrays of temperature (K; degrees Celsius if its units say so), pressure (Pa or
   * hPa), cloud fraction (0 to 1), land fraction (0 to 1) and height (m). Empty (default): found by
   * name.
   */
  vtkSetMacro(TemperatureArrayName, std::string);
  vtkGetMacro(TemperatureArrayName, std::string);
  vtkSetMacro(PressureArrayName, std::string);
  vtkGetMacro(PressureArrayName, std::string);
  vtkSetMacro(CloudFractionArrayName, std::string);
  vtkGetMacro(CloudFractionArrayName, std::string);
  vtkSetMacro(LandArrayName, std::string);
  vtkGetMacro(LandArrayName, std::string);
  vtkSetMacro(HeightArrayName, std::string);
  vtkGetMacro(HeightArrayName, std::string);
  ///@}

  ///@{
  /**
   * Units of all water arrays. Automatic (default): the units that the reader reports, kg/m3 for
   * arrays named LWC and IWC, otherwise kg/kg.
   */
  vtkSetClampMacro(WaterUnits, int, AUTOMATIC, CONTENT_GRAMS);
  vtkGetMacro(WaterUnits, int);
  void SetWaterUnitsToAutomatic() { this->SetWaterUnits(AUTOMATIC); }
  void SetWaterUnitsToMixingRatio() { this->SetWaterUnits(MIXING_RATIO); }
  void SetWaterUnitsToMixingRatioGrams() { this->SetWaterUnits(MIXING_RATIO_GRAMS); }
  void SetWaterUnitsToContent() { this->SetWaterUnits(CONTENT); }
  void SetWaterUnitsToContentGrams() { this->SetWaterUnits(CONTENT_GRAMS); }
  ///@}

  ///@{
  /**
   * Radii of droplets: computed from the water inside the cloud and the number of droplets
   * (default), or LiquidRadius everywhere.
   * Radii of crystals: from temperature and ice inside the cloud (default), or IceRadius
   * everywhere.
   */
  vtkSetClampMacro(LiquidRadiusType, int, PARAMETERIZED, CONSTANT);
  vtkGetMacro(LiquidRadiusType, int);
  vtkSetClampMacro(IceRadiusType, int, PARAMETERIZED, CONSTANT);
  vtkGetMacro(IceRadiusType, int);
  ///@}

  ///@{
  /** Constant effective radii, micrometres, 1 or more. Defaults 10 and 30. */
  vtkSetClampMacro(LiquidRadius, double, 1.0, 1e4);
  vtkGetMacro(LiquidRadius, double);
  vtkSetClampMacro(IceRadius, double, 1.0, 1e4);
  vtkGetMacro(IceRadius, double);
  ///@}

  ///@{
  /**
   * Droplets per cm3 over land and over the sea, 1 or more. Defaults 300 and 100. Without a land
   * fraction the surface is sea everywhere.
   */
  vtkSetClampMacro(DropletsOverLand, double, 1.0, 1e5);
  vtkGetMacro(DropletsOverLand, double);
  vtkSetClampMacro(DropletsOverSea, double, 1.0, 1e5);
  vtkGetMacro(DropletsOverSea, double);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkCloudOptics();
  ~vtkCloudOptics() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCloudOptics(const vtkCloudOptics&) = delete;
  void operator=(const vtkCloudOptics&) = delete;

  std::array<std::string, 10> Names() const; // of arrays: nephoscope::FieldNames
  bool AddOptics(vtkDataSet* data);

  std::string TotalWaterArrayName, LiquidArrayName, IceArrayName, RainArrayName, SnowArrayName;
  std::string TemperatureArrayName, PressureArrayName, CloudFractionArrayName, LandArrayName,
    HeightArrayName;
  int WaterUnits = AUTOMATIC;
  int LiquidRadiusType = PARAMETERIZED;
  int IceRadiusType = PARAMETERIZED;
  double LiquidRadius = 10;
  double IceRadius = 30;
  double DropletsOverLand = 300;
  double DropletsOverSea = 100;
  vtkMTimeType ToldOfEmptiness = 0, Failed = 0;        // for IsEmptyInput and ReportOnce
  vtkMTimeType ToldOfInput = 0;                        // for HasOtherInput
  std::unique_ptr<nephoscope::BlocksWithArray> Blocks; // some may lack the array
};

#endif
