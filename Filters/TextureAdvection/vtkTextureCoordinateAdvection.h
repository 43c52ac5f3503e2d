// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureCoordinateAdvection
 * @brief   texture coordinates that move with the wind
 *
 *     port 0: grid with a velocity, time series      port 1 (optional): points
 *                        |                                    |
 *                        +--> vtkTextureCoordinateAdvection <-+
 *                                            |
 *             the grid, or the points, at the requested time with
 *             TextureCoordinates1, TextureCoordinates2, TextureWeights
 *
 * Section 5 of MaxCrawfisBecker1993 (N. Max, R. Crawfis, B. Becker, "New Techniques in 3D Scalar
 * and Vector Field Visualization", Pacific Graphics 1993). For each point:
 *
 * 1. Trace the air back in time through the winds of the series (linear in time between its steps)
 *    to the birth of the younger set of coordinates, and on to the birth of the older set.
 * 2. Write the position of the air at each birth, and the weights for blending the two sets: 0 at
 *    birth and death, 1 in the middle of life; their sum is 1.
 *
 * On the output of vtkGlobeGrid, globe or map, paths are on the sphere, and the wind is
 * interpolated as a Cartesian vector, so that poles and seam need no special treatment. Air follows
 * its height or its pressure, so that the motion relative to sloping and moving levels is correct;
 * it slides along the ground and under the top. Beyond the border of a regional grid, the wind is
 * that on the border.
 * In other datasets paths are Cartesian; beyond the border, in holes and in blanked cells, the wind
 * is that at the nearest position with a wind.
 *
 * Winds of one Period are in memory, and each time step is read once while time goes forward. A
 * frame traces the paths of one period and does not depend on earlier frames.
 *
 * Every process reads the whole grid and makes its own piece of the output.
 *
 * Arrays written; README.md of this folder and Documentation/texture-advection.md give their units
 * and meaning:
 * - TextureCoordinates1, TextureCoordinates2: points, float, 3 components. Longitude/360,
 *   latitude/360 and height over the equator's length of the position of origin, longitudes
 *   unwrapped; or Cartesian.
 * - TextureWeights, TextureAges: field data, double, 2 values; ages in seconds.
 * - TextureFrame (int, 0 longitude-latitude-height, 1 Cartesian), TextureOrigin (double, 3 values),
 *   TextureLength (double): field data.
 * - FiniteTimeLyapunovExponent: points, float, 1/s, with ComputeLyapunovExponent.
 * - TextureWeights: points, float, 2 components, with MaximumStretch.
 *
 * Between time steps the arrays of the grid itself are interpolated linearly in time.
 *
 * These give an error and no texture arrays: no velocity, invalid settings, times that do not
 * increase, missing time steps, a grid whose columns change, an incomplete grid. Warnings report
 * points without a wind.
 */
#ifndef vtkTextureCoordinateAdvection_h
#define vtkTextureCoordinateAdvection_h

#include "vtkDataSetAlgorithm.h"
#include "vtkNephoscopeFiltersTextureAdvectionModule.h" // for export macro

#include "vtkSmartPointer.h" // for data between time steps

#include <functional> // for progress
#include <memory>     // for the state between updates
#include <string>     // for array names
#include <vector>     // for the results

class vtkAlgorithmOutput;
class vtkDataSet;
class vtkInformation;

namespace nephoscope
{
class OutputPiece;
struct FlowStep;
struct SeriesInterval;
struct SetPlan;
struct TextureSets;
struct TextureState;
class TimeSeries;
}

class VTKNEPHOSCOPEFILTERSTEXTUREADVECTION_EXPORT vtkTextureCoordinateAdvection
  : public vtkDataSetAlgorithm
{
public:
  static vtkTextureCoordinateAdvection* New();
  vtkTypeMacro(vtkTextureCoordinateAdvection, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum IntegratorType
  {
    EULER = 0,
    RUNGE_KUTTA_4 = 1,
    RUNGE_KUTTA_45 = 2
  };

  enum GridType
  {
    AUTOMATIC = 0,
    GLOBE = 1,
    MAP = 2,
    CARTESIAN = 3
  };

  ///@{
  /**
   * Port 1, optional: points to trace instead of the points of the grid, such as a cloud surface at
   * the requested time. The output is then this dataset.
   */
  void SetPointsConnection(vtkAlgorithmOutput* points);
  void RemovePoints() { this->SetInputConnection(1, nullptr); }
  ///@}

  ///@{
  /**
   * Lifetime of a set of coordinates, in seconds, 0 or more. The second set starts half a period
   * after the first. 0, the default:
   * FindPeriod of the first time step.
   */
  vtkSetMacro(Period, double);
  vtkGetMacro(Period, double);
  ///@}

  /**
   * The automatic period: 86400 s, 24 hours, for data from Globe Grid and for data without a wind,
   * otherwise the time in which the fastest air crosses a quarter of the diagonal of the bounds.
   */
  double FindPeriod(vtkDataSet* winds);
  /** Seconds in which the fastest air crosses the diagonal of the bounds; 0 without a wind. */
  double FindCrossingTime(vtkDataSet* winds);

  ///@{
  /** The Period and TimeStep in use, in seconds: your values or the automatic ones. */
  double GetPeriodUsed() const;
  double GetTimeStepUsed() const;
  ///@}

  ///@{
  /**
   * RungeKutta4 (default): fixed steps of fourth order. Euler: first order, as in the paper; it
   * needs steps of a minute to be as accurate. RungeKutta45: steps of order 5 (4) with error
   * control by Tolerance.
   */
  vtkSetClampMacro(Integrator, int, EULER, RUNGE_KUTTA_45);
  vtkGetMacro(Integrator, int);
  void SetIntegratorToEuler() { this->SetIntegrator(EULER); }
  void SetIntegratorToRungeKutta4() { this->SetIntegrator(RUNGE_KUTTA_4); }
  void SetIntegratorToRungeKutta45() { this->SetIntegrator(RUNGE_KUTTA_45); }
  ///@}

  ///@{
  /**
   * Longest integration step, in seconds, 0 or more. Steps end at the time steps of the series. The
   * cost is inversely proportional to it. 0, the default: 1/24 of FindPeriod of the first time
   * step, 3600 for data from Globe Grid.
   */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Error tolerance of one step of RungeKutta45: in radians on a globe, otherwise in units of
   * length of the data; greater than 0. Default 1e-6.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Seconds per unit of the pipeline's time, 3600 for time steps in hours. Greater than 0; default
   * 1.
   */
  vtkSetMacro(TimeScale, double);
  vtkGetMacro(TimeScale, double);
  ///@}

  ///@{
  /**
   * Interval of a set's age, in seconds, at which coordinates are computed. Times in between are
   * interpolated, at almost no cost, but never across the start of a set. 0 (default): all are
   * computed. Not used for the points of port 1.
   */
  vtkSetMacro(KeyFrameInterval, double);
  vtkGetMacro(KeyFrameInterval, double);
  ///@}

  ///@{
  /**
   * Geometry of the grid. Automatic (default): from the field data of vtkGlobeGrid; without them a
   * globe if the points lie on meridians and parallels around the origin, otherwise Cartesian. Map:
   * plate carree in units of PlanetRadius.
   */
  vtkSetClampMacro(Grid, int, AUTOMATIC, CARTESIAN);
  vtkGetMacro(Grid, int);
  void SetGridToAutomatic() { this->SetGrid(AUTOMATIC); }
  void SetGridToGlobe() { this->SetGrid(GLOBE); }
  void SetGridToMap() { this->SetGrid(MAP); }
  void SetGridToCartesian() { this->SetGrid(CARTESIAN); }
  ///@}

  ///@{
  /**
   * Displayed radius at height 0, for grids without the field data of vtkGlobeGrid; 0 (default):
   * the radius of the first point (map: 6371000).
   */
  vtkSetMacro(PlanetRadius, double);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /**
   * On a globe or map: writes Cartesian coordinates on the sphere, in units of the equator's
   * length, which have no seam and no poles. Off by default.
   */
  vtkSetMacro(CartesianCoordinates, bool);
  vtkGetMacro(CartesianCoordinates, bool);
  vtkBooleanMacro(CartesianCoordinates, bool);
  ///@}

  ///@{
  /**
   * The wind before the first time step. Off (default): the wind of the first time step is held
   * constant. On: there is no wind, so that at the first time step the coordinates of both sets are
   * the positions of the points, as in the paper; the weights are the same.
   */
  vtkSetMacro(StartFromGrid, bool);
  vtkGetMacro(StartFromGrid, bool);
  vtkBooleanMacro(StartFromGrid, bool);
  ///@}

  ///@{
  /** In Cartesian grids: length of one texture unit; 0 (default): the width of the grid along x. */
  vtkSetMacro(TextureLength, double);
  vtkGetMacro(TextureLength, double);
  ///@}

  ///@{
  /**
   * On a globe or map: names of point arrays of pressure (falling upwards) and of omega, its rate
   * following the air, in the same unit per second. With both, vertical motion is integrated in
   * pressure instead of displayed height, which is exact on pressure and hybrid levels. Default ""
   * and ""; "None", from ParaView's menus, is the same as "".
   */
  void SetPressureArrayNames(const std::string& pressure, const std::string& omega);
  void SetPressureArrayName(const std::string& name);
  vtkGetMacro(PressureArrayName, std::string);
  void SetOmegaArrayName(const std::string& name);
  vtkGetMacro(OmegaArrayName, std::string);
  ///@}

  ///@{
  /**
   * Writes FiniteTimeLyapunovExponent of the older set: the logarithm of the largest factor by
   * which the backward map stretches lengths, over the age; horizontally on globes and maps. Grids
   * only. Off by default.
   */
  vtkSetMacro(ComputeLyapunovExponent, bool);
  vtkGetMacro(ComputeLyapunovExponent, bool);
  vtkBooleanMacro(ComputeLyapunovExponent, bool);
  ///@}

  ///@{
  /**
   * Fades to the younger set where the older set is deformed: a set that is stretched by this
   * factor has half its weight, and one stretched by much more has almost none. Writes
   * TextureWeights on points. Greater than 1; 0 (default): weights depend on the age only. Grids
   * only.
   */
  vtkSetMacro(MaximumStretch, double);
  vtkGetMacro(MaximumStretch, double);
  ///@}

  ///@{
  /** Results of the last update: integration steps taken, over all points; time steps in memory. */
  vtkGetMacro(NumberOfSteps, vtkIdType);
  vtkGetMacro(NumberOfTimeStepsHeld, int);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkTextureCoordinateAdvection();
  ~vtkTextureCoordinateAdvection() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTextureCoordinateAdvection(const vtkTextureCoordinateAdvection&) = delete;
  void operator=(const vtkTextureCoordinateAdvection&) = delete;

  // The series; in vtkTextureCoordinateAdvectionSeries.cxx.
  bool HasSeries() const;
  nephoscope::TimeSeries Series() const;
  nephoscope::TextureSets Sets() const;
  double RequestedSeconds() const;
  void AskForPoints(vtkInformation* input, vtkInformation* points, vtkInformation* output);
  void PlanReading();
  bool ChooseNext();
  void ReportOtherInput(vtkDataObject* input);
  void Stop(vtkInformation* request);

  // Settings and a time step; in vtkTextureCoordinateAdvectionInput.cxx.
  bool CheckSettings();
  bool CheckSeries();
  vtkMTimeType PipelineMTime();
  bool KnowsPeriod();
  void TakePeriodOf(vtkDataSet* winds);
  bool ReadTimeStep(vtkDataSet* input, vtkInformation* inInfo);
  bool MakeFlow(vtkDataSet* input);
  bool CheckExtent(vtkDataSet* input, vtkInformation* inInfo);

  // The coordinates of a time.
  bool MakeTexture(vtkDataSet* points, vtkInformation* outInfo, vtkDataSet* output);
  nephoscope::SetPlan PlanSet(int set, double time);
  nephoscope::FlowStep PresentStep(const nephoscope::SeriesInterval& interval) const;
  vtkSmartPointer<vtkDataSet> DataAt(double time) const;
  bool FollowPaths(
    const nephoscope::SetPlan plans[2], vtkDataSet* points, const nephoscope::OutputPiece& piece);
  bool FollowFrom(double start, const std::vector<int>& sets, const nephoscope::SetPlan plans[2],
    vtkDataSet* points, const std::function<bool(double)>& report);
  std::vector<float> DisplacementsOf(
    int set, const nephoscope::SetPlan& plan, std::size_t count) const;
  void WriteSets(const std::vector<float> displacements[2], vtkDataSet* output);
  void WriteStretch(const std::vector<float> displacements[2], vtkDataSet* output);
  bool NeedsStretch() const;
  void SetName(std::string& member, const std::string& name);
  bool Report(double fraction);

  double Period = 0.0;
  int Integrator = RUNGE_KUTTA_4;
  double TimeStep = 0.0;
  double Tolerance = 1e-6;
  double TimeScale = 1.0;
  double KeyFrameInterval = 0.0;
  int Grid = AUTOMATIC;
  double PlanetRadius = 0.0;
  bool CartesianCoordinates = false;
  bool StartFromGrid = false;
  double TextureLength = 0.0;
  std::string PressureArrayName;
  std::string OmegaArrayName;
  bool ComputeLyapunovExponent = false;
  double MaximumStretch = 0.0;
  vtkIdType NumberOfSteps = 0;
  int NumberOfTimeStepsHeld = 0;

  std::unique_ptr<nephoscope::TextureState> State;
};

#endif
