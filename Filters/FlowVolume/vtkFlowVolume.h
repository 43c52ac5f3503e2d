// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowVolume
 * @brief   smoke: the volume that a flow sweeps from a generating polygon, as tetrahedra
 *
 *     port 0: any dataset with a velocity        port 1 (optional): generating polygon
 *                        |                                        |
 *                        +-----------> vtkFlowVolume <------------+
 *                                            |
 *             vtkUnstructuredGrid of tetrahedra, EmissionStep, Age, Density
 *
 * The flow volume of MaxBeckerCrawfis1993 (N. Max, B. Becker, R. Crawfis, "Flow Volumes for
 * Interactive Vector Field Visualization", IEEE Visualization 1993) and of section 6 of
 * MaxCrawfisBecker1993:
 *
 * 1. Divide the polygon into triangles.
 * 2. Move its points along the flow, layer by layer. Before a step, edges that would get too long
 *    are divided and edges that have become short are merged; steps in which the flow turns,
 *    spreads or diverges too much are halved.
 * 3. Divide the prisms between layers into tetrahedra that fit their neighbours: no cracks, no
 *    hanging points.
 * 4. Give every prism its density, the emitted mass over its volume.
 * 5. Interpolate every point array of the input to the points.
 *
 * Steady: the flow of the current time step. A prism ends as a whole where one of its corners
 * leaves the data or meets a blanked cell; the rest of the layer continues, so a volume divides at
 * an obstacle.
 * Unsteady: the volume of the smoke released from the start to the current time (streaklines), from
 * a time series that is read once, step by step.
 *
 * The velocity is the array chosen with SetInputArrayToProcess(0, ...): three components, in units
 * of length of the dataset per second. Without a choice it is DisplayVelocity (of vtkGlobeGrid) if
 * there is one, else the active vectors, else the only array of three components; arrays on points
 * come before arrays on cells. Composite datasets are one field.
 *
 * Cell arrays written:
 * - EmissionStep, int. Steady: number of time steps since the smoke left the polygon. Unsteady: the
 *   time step in which it left.
 * - Age, double, s: time since the smoke left the polygon, in the middle of the cell's step.
 * - Density, double: InitialDensity times emitted volume over present volume. The sum over cells of
 *   density times volume is the emitted mass.
 * Point arrays written, besides those of the input:
 * - Age, double, s, at the point. It replaces an input array of that name, with a warning.
 * - SmoothDensity, double: the mean Density of the cells at the point, by their volume, for
 *   drawing. Interpolated linearly it has the same mass.
 * Field data are passed on. Unsteady smoke has one more field array, of one double: InitialDensity,
 * to which drawing refers the density, so that the pictures of a film are comparable. Up to the
 * first release there are no cells, and the field array BoundsToCome has the six bounds of the
 * data.
 *
 * Moving the polygon or changing a setting is fast: the search structure of the input is kept until
 * the input changes.
 *
 * These give an error and an empty output: no velocity; negative or infinite settings; more than a
 * million time steps; a polygon without area, wholly outside the data, in blanked cells, where the
 * velocity is not a number or zero, or parallel to the flow.
 * Warnings report a polygon that is partly outside, a volume that is coarser than requested because
 * of MaximumNumberOfTetrahedra, and a volume that ended at once.
 */
#ifndef vtkFlowVolume_h
#define vtkFlowVolume_h

#include "vtkNephoscopeFiltersFlowVolumeModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <array>      // for positions
#include <functional> // for interpolating arrays
#include <memory>     // for the state between updates
#include <string>     // for messages

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkInformation;
class vtkMultiProcessController;
class vtkPointData;
class vtkPolyData;

namespace nephoscope
{
class FlowVolumeExchange;
struct FlowField;
struct FlowVolumeSettings;
struct FlowVolumeState;
struct MissingVelocities;
struct PolygonFlow;
struct PolygonMesh;
struct SmokeMesh;
struct SmokeReport;
class VelocityField;
struct WholeVolume;
}

class VTKNEPHOSCOPEFILTERSFLOWVOLUME_EXPORT vtkFlowVolume : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkFlowVolume* New();
  vtkTypeMacro(vtkFlowVolume, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum IntegratorType
  {
    RUNGE_KUTTA_4 = 0,
    RUNGE_KUTTA_45 = 1
  };

  /**
   * The generating polygon (port 1): polygons of a vtkPolyData, planar, convex or not. Without a
   * connection it is the regular polygon described by Center, Radius, NumberOfSides and Normal.
   */
  void SetPolygonConnection(vtkAlgorithmOutput* polygon);

  ///@{
  /** Centre of the regular polygon, in the coordinates of the input. Default (0, 0, 0). */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Circumradius of the regular polygon; 0 (default): 1/50 of the diagonal of the bounds of the
   * input.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** Number of sides of the regular polygon, 3 or more. Default 12. */
  vtkSetClampMacro(NumberOfSides, int, 3, 1000);
  vtkGetMacro(NumberOfSides, int);
  ///@}

  ///@{
  /**
   * Normal of the regular polygon; need not have unit length. Ignored with NormalToFlow. Default
   * (0, 0, 1).
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  enum NormalToFlowType
  {
    AS_GIVEN = 0,
    NORMAL_TO_FLOW = 1,
    NORMAL_UNLESS_GIVEN = 2
  };

  ///@{
  /**
   * Turns the generating polygon about its centre until its normal is the direction of the flow
   * there: on (1), off (0), or, the default (2), the regular polygon only, while a polygon from
   * port 1 keeps its orientation.
   */
  vtkSetClampMacro(NormalToFlow, int, AS_GIVEN, NORMAL_UNLESS_GIVEN);
  vtkGetMacro(NormalToFlow, int);
  vtkBooleanMacro(NormalToFlow, int);
  ///@}

  ///@{
  /**
   * Maximum edge length of the triangles of the generating polygon; 0 (default): a quarter of the
   * polygon's longest extent.
   */
  vtkSetMacro(PolygonEdgeLength, double);
  vtkGetMacro(PolygonEdgeLength, double);
  ///@}

  ///@{
  /**
   * Time for which the smoke flows, in seconds; 0 (default): the time in which the flow at the
   * polygon crosses half the diagonal of the bounds, found once for all times of a series unless
   * the flow becomes four times as fast or as slow. Unsteady: older smoke is dropped; 0 keeps all
   * smoke.
   */
  vtkSetMacro(Duration, double);
  vtkGetMacro(Duration, double);
  ///@}

  ///@{
  /**
   * Time between two layers, in seconds; 0 (default): 1/64 of the duration, and no longer than the
   * flow at the polygon takes for 1/32 of the diagonal of the bounds; unsteady: 1/64 of the time
   * from the start to the last time step. Longer if MaximumNumberOfTetrahedra requires it, or if
   * the duration would take more than a million steps; more than two million give a warning. The
   * cost is inversely proportional to it.
   */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Longer edges of a layer are split; 0 (default): three times the polygon's longest edge;
   * unsteady: or three times the distance that the flow covers in a time step, if that is longer.
   * Longer if MaximumNumberOfTetrahedra requires it.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * Edges of a layer are halved down to MaximumEdgeLength over 2 to this power, 0 to 16; shorter
   * edges stay whole, however long the flow makes them in the next step. Default 6: 1/64. Steady
   * flow.
   */
  vtkSetClampMacro(EdgeLevels, int, 0, 16);
  vtkGetMacro(EdgeLevels, int);
  ///@}

  ///@{
  /**
   * Shorter edges of a layer, where streamlines converge, are collapsed; 0 (default): never. Keep
   * it below a third of MaximumEdgeLength; above MaximumEdgeLength it is an error. Unsteady: edges
   * of tetrahedra, at each release; the tetrahedra around share the mass.
   */
  vtkSetMacro(MinimumEdgeLength, double);
  vtkGetMacro(MinimumEdgeLength, double);
  ///@}

  ///@{
  /**
   * A time step is halved if the path of a vertex turns by more than this angle, in degrees; 0:
   * never. Default 15, which gives an error of about 1 % (1 - sin a / a) in the volume of a prism.
   * Unsteady: vertices whose path turns more are moved in halves of the step, unless the integrator
   * is RungeKutta45, which chooses its steps; and layers are released between the regular ones
   * while the smoke that leaves the polygon turns by more between two of them.
   */
  vtkSetClampMacro(MaximumTurnAngle, double, 0.0, 180.0);
  vtkGetMacro(MaximumTurnAngle, double);
  ///@}

  ///@{
  /**
   * A time step is halved if the area of a triangle of the layer changes by more than this factor
   * in it, greater than 1; 0: never. Default 2. Steady flow.
   */
  vtkSetMacro(MaximumAreaRatio, double);
  vtkGetMacro(MaximumAreaRatio, double);
  ///@}

  ///@{
  /**
   * A time step is halved if the divergence of the flow times the step is more than this; 0: never.
   * Default 0.5. Steady flow.
   */
  vtkSetMacro(MaximumDivergence, double);
  vtkGetMacro(MaximumDivergence, double);
  ///@}

  ///@{
  /**
   * How often a time step is halved at most, 0 to 16. Default 4: into 16 parts. Less if
   * MaximumNumberOfTetrahedra requires it.
   */
  vtkSetClampMacro(MaximumHalvings, int, 0, 16);
  vtkGetMacro(MaximumHalvings, int);
  ///@}

  ///@{
  /**
   * Before smoke ends at an obstacle, its triangles are divided until their edges are no longer
   * than MaximumEdgeLength over 2 to this power, 0 to 16. Default 2: a quarter. 0: never. Unsteady:
   * tetrahedra with an obstacle between their corners.
   */
  vtkSetClampMacro(ObstacleLevels, int, 0, 16);
  vtkGetMacro(ObstacleLevels, int);
  ///@}

  ///@{
  /**
   * Length of the smallest obstacles that are found where no corner of the smoke meets them: the
   * velocity is sampled inside the prisms (unsteady: tetrahedra) at this distance, at most 64 times
   * along an edge. 0 (default): the size of the smallest blanked cell; without blanked cells,
   * corners only. Set it for holes of unstructured data and for values that are not numbers. A
   * length greater than the edges switches the search off.
   */
  vtkSetMacro(ObstacleSize, double);
  vtkGetMacro(ObstacleSize, double);
  ///@}

  ///@{
  /**
   * Runge-Kutta of fourth order with fixed steps (default), or Runge-Kutta 4-5 with adaptive steps,
   * controlled by Tolerance.
   */
  vtkSetClampMacro(Integrator, int, RUNGE_KUTTA_4, RUNGE_KUTTA_45);
  vtkGetMacro(Integrator, int);
  void SetIntegratorToRungeKutta4() { this->SetIntegrator(RUNGE_KUTTA_4); }
  void SetIntegratorToRungeKutta45() { this->SetIntegrator(RUNGE_KUTTA_45); }
  ///@}

  ///@{
  /**
   * Error tolerance of one step of RungeKutta45, relative to the polygon's longest edge. Default
   * 1e-6.
   */
  vtkSetClampMacro(Tolerance, double, 1e-14, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Off (default): the flow of the current time step. On: smoke released throughout a time series,
   * up to the requested time (the last one, if none is requested). Going forward in time, every
   * time step is read once, and two are in memory; going back or changing a setting starts again.
   * Between time steps the velocity is linear in time. The generating polygon is that of the start
   * time, or of the first time step thereafter with any flow. Ignored, with a warning, if the input
   * has fewer than two time steps.
   *
   * Every TimeStep seconds a layer is released, and all layers move with the flow. Edges of
   * tetrahedra that become longer than MaximumEdgeLength (and than those of the polygon's
   * triangles) are halved at any age, with all adjacent tetrahedra; those shorter than
   * MinimumEdgeLength are collapsed. A tetrahedron ends when one of its corners leaves the data.
   * Until then it keeps its mass: Density is mass over volume.
   */
  vtkSetMacro(Unsteady, bool);
  vtkGetMacro(Unsteady, bool);
  vtkBooleanMacro(Unsteady, bool);
  ///@}

  ///@{
  /**
   * Unsteady: time of the first release, in the pipeline's unit. Before the first time step (the
   * default): that step.
   */
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /**
   * Unsteady: seconds per unit of the pipeline's time, 3600 for time steps in hours. 0 (default):
   * the seconds in the unit that the field array `time_units` of the first time step names, as
   * readers of NetCDF files write it ("hours since 2011-10-11"); 1 if there is no such array. A
   * warning appears if the flow hardly moves in the whole series, or crosses the data several
   * times between two time steps.
   */
  vtkSetMacro(TimeScale, double);
  vtkGetMacro(TimeScale, double);
  ///@}

  ///@{
  /** Density of the smoke at the polygon. Default 1. */
  vtkSetMacro(InitialDensity, double);
  vtkGetMacro(InitialDensity, double);
  ///@}

  ///@{
  /**
   * Maximum number of tetrahedra in the volume. If it would have more, the filter computes it again
   * with longer edges of the layers, a polygon of fewer triangles or longer steps, until the whole
   * duration fits. It warns, unless these settings were automatic and this number is at least the
   * default. Unsteady: fewer edges are split. Default 100,000, which take some tenths of a second.
   */
  vtkSetClampMacro(MaximumNumberOfTetrahedra, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfTetrahedra, vtkIdType);
  ///@}

  ///@{
  /**
   * Results of the last update: the mean normal of the generating polygon after NormalToFlow;
   * duration and time step in seconds, and the longest edge that was not divided, also where they
   * were chosen automatically or coarsened. Zero after an error.
   */
  vtkGetVector3Macro(NormalUsed, double);
  vtkGetMacro(DurationUsed, double);
  vtkGetMacro(TimeStepUsed, double);
  vtkGetMacro(MaximumEdgeLengthUsed, double);
  ///@}

  ///@{
  /**
   * Results of the last update, in InitialDensity times volume of the dataset: the mass that has
   * come from the polygon, the part of it that has left the data, met a blanked cell or is in cells
   * without volume (which are left out), and the part that is older than Duration (unsteady). What
   * is left is the sum of Density times volume. ObstacleMass is the part of LostMass
   * that ended at obstacles inside the data: bodies, blanked cells or values that are not
   * numbers, with data again ahead of them. If it is more than 1 % of EmittedMass, a warning says
   * so. FoldedMass is the mass of prisms that ended because the flow would have folded them, even
   * in the shortest step.
   */
  vtkGetMacro(EmittedMass, double);
  vtkGetMacro(LostMass, double);
  vtkGetMacro(ObstacleMass, double);
  vtkGetMacro(FoldedMass, double);
  vtkGetMacro(ExpiredMass, double);
  ///@}

  ///@{
  /**
   * The ranks that share the input and the polygon: all of them compute the same volume, and each
   * outputs a part of it. Default: the global controller. Null: this process only.
   */
  virtual void SetController(vtkMultiProcessController*);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkFlowVolume();
  ~vtkFlowVolume() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.0;
  double Normal[3] = { 0.0, 0.0, 1.0 };

private:
  vtkFlowVolume(const vtkFlowVolume&) = delete;
  void operator=(const vtkFlowVolume&) = delete;

  void ResetResults();
  nephoscope::FlowVolumeExchange Exchange() const;
  bool CheckSettings();
  bool CheckNumberOfSteps(double duration, double timeStep);
  std::shared_ptr<const nephoscope::FlowField> MakeField(vtkDataObject* input);
  bool MakePolygon(const nephoscope::FlowField& field, const nephoscope::VelocityField& velocity,
    double time, vtkPolyData* given, nephoscope::PolygonMesh& polygon);
  bool TriangulatePolygon(const nephoscope::FlowField& field,
    const nephoscope::VelocityField& velocity, double time, vtkPolyData* given, double edge,
    nephoscope::PolygonMesh& polygon);
  bool MakeRegularPolygon(const nephoscope::FlowField& field,
    const nephoscope::VelocityField& velocity, double time, double edge,
    nephoscope::PolygonMesh& polygon);
  bool MakeGivenPolygon(const nephoscope::FlowField& field,
    const nephoscope::VelocityField& velocity, double time, vtkPolyData* given, double edge,
    nephoscope::PolygonMesh& polygon);
  bool IsStill(const nephoscope::FlowField& field) const;
  void ReportZeroVelocity(const nephoscope::FlowField& field, const std::string& where);
  bool FindDirection(const nephoscope::FlowField& field, const nephoscope::VelocityField& velocity,
    double time, const std::array<double, 3>& center, std::array<double, 3>& direction);
  bool CheckPlace(const nephoscope::FlowField& field, const nephoscope::PolygonMesh& polygon,
    const nephoscope::PolygonFlow& flow);
  bool CheckFlow(const nephoscope::FlowField& field, const nephoscope::PolygonFlow& flow);

  // In vtkFlowVolumeSteady.cxx.
  void MakeSteadyVolume(vtkDataObject* input, vtkPolyData* given, vtkUnstructuredGrid* output);
  double FindCrossingTime(const nephoscope::FlowField& field, const nephoscope::PolygonFlow& flow);
  bool FindSettings(const nephoscope::FlowField& field, const nephoscope::PolygonFlow& flow,
    nephoscope::FlowVolumeSettings& settings);
  double UsualTimeStep(double duration) const;
  bool HasTooManySteps(double duration) const;
  void WarnOfManySteps(double duration);
  void ReportSteady(const nephoscope::WholeVolume& whole);
  bool IsSizeAutomatic() const;
  void WarnOfCoarsening(double polygonEdgeLength, bool isMuch);
  void WarnOfLongEdges();
  void WarnOfLimit();
  void WarnOfLeaving(const nephoscope::SmokeMesh& mesh, const nephoscope::FlowField& field);
  void WarnOfObstacles(const nephoscope::SmokeReport& report, bool isMissing);
  nephoscope::MissingVelocities CountMissing(const nephoscope::FlowField& field) const;
  bool WarnOfMissing(const nephoscope::FlowField& field);
  void WarnOfNothing(const nephoscope::SmokeReport& report);

  // For a time series; in vtkFlowVolumeUnsteady.cxx.
  bool CheckSeries();
  double Seconds(double time) const;
  double StartSeconds() const;
  double RequestedSeconds() const;
  void PlanReading(vtkInformation* output);
  void MakeRoom();
  void MakeUnsteadyVolume(vtkInformation* request, vtkDataObject* input, vtkPolyData* given,
    vtkInformation* outputInformation);
  bool ReadTimeStep(vtkDataObject* input);
  bool BeginStreak(vtkPolyData* given);
  void WarnOfTimeScale(double speed);
  void WriteBounds(vtkUnstructuredGrid* output) const;
  bool AdvanceStreak();
  bool HasTimeSteps() const;
  std::string NameOfTimeStep() const;
  bool IsToldFirst(vtkMTimeType& told);
  void WarnOfNoSmokeYet();
  void WarnOfNoDataYet();
  void WarnOfLoss(const nephoscope::SmokeReport& report);
  void EndSeries(vtkInformation* request);
  std::unique_ptr<nephoscope::VelocityField> StreakVelocity() const;
  void SampleStreakArrays(const nephoscope::SmokeMesh& mesh, vtkPointData* arrays);
  nephoscope::SmokeMesh StreakMeshAt(double seconds);
  void WriteStreak(vtkUnstructuredGrid* output);

  bool Report(double share);
  void WriteMasses(vtkUnstructuredGrid* output) const;
  void WriteOutput(nephoscope::SmokeMesh& mesh,
    const std::function<void(const nephoscope::SmokeMesh&, vtkPointData*)>& sampleArrays,
    vtkUnstructuredGrid* output);

  static constexpr double maximumNumberOfSteps = 1e6;
  static constexpr vtkIdType moderateNumberOfTetrahedra = 100000;

  vtkMultiProcessController* Controller = nullptr;
  int NumberOfSides = 12;
  int NormalToFlow = NORMAL_UNLESS_GIVEN;
  double PolygonEdgeLength = 0.0;
  double Duration = 0.0;
  double TimeStep = 0.0;
  double MaximumEdgeLength = 0.0;
  double MinimumEdgeLength = 0.0;
  int EdgeLevels = 6;
  double MaximumTurnAngle = 15.0;
  double MaximumAreaRatio = 2.0;
  double MaximumDivergence = 0.5;
  int MaximumHalvings = 4;
  int ObstacleLevels = 2;
  double ObstacleSize = 0.0;
  int Integrator = RUNGE_KUTTA_4;
  double Tolerance = 1e-6;
  bool Unsteady = false;
  double StartTime = VTK_DOUBLE_MIN;
  double TimeScale = 0.0;
  double InitialDensity = 1.0;
  vtkIdType MaximumNumberOfTetrahedra = moderateNumberOfTetrahedra;

  double NormalUsed[3] = { 0.0, 0.0, 0.0 };
  double DurationUsed = 0.0;
  double TimeStepUsed = 0.0;
  double MaximumEdgeLengthUsed = 0.0;
  double EmittedMass = 0.0;
  double LostMass = 0.0;
  double ObstacleMass = 0.0;
  double FoldedMass = 0.0;
  double ExpiredMass = 0.0;

  std::unique_ptr<nephoscope::FlowVolumeState> State;
};

#endif
