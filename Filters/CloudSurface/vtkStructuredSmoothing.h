// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStructuredSmoothing
 * @brief   3 x 3 x 3 smoothing of fields on structured grids, across seams and poles, optionally
 *          conserving mass
 *
 *     image, rectilinear or structured grid
 *         ->  vtkStructuredSmoothing  ->  the same grid, arrays smoothed
 *
 * One iteration is the filter of Max, Crawfis and Becker, "New Techniques in 3D Scalar and Vector
 * Field Visualization", Pacific Graphics 1993, section 4: weights 8, 4, 2, 1 (/64) for centre,
 * faces, edges and corners of 3 x 3 x 3 points. It is done as three passes with weights 1, 2, 1
 * (/4), one along each axis. A wave of N points along an axis is multiplied by cos^2(pi/N): N = 2
 * by 0, 4 by 0.5, 8 by 0.853553, 16 by 0.961940. The standard deviation of white noise is
 * multiplied by 0.229640. At an end of an axis the weights are 3, 1 (/4).
 *
 * Every pass is an exchange between neighbours (SmoothingKernel.h): a constant stays constant
 * exactly, and no value leaves the range of its neighbours. With Conservative, sum (mass * field)
 * is conserved to rounding error, on grids with cells of any size.
 *
 * - Seam. A structured grid whose last points have the positions of its first points, such as the
 *   output of vtkGlobeGrid, is automatically smoothed across that seam; both keep the same values.
 *   For other periodic grids see SetPeriodic.
 * - Poles. A row whose points coincide (a pole of vtkGlobeGrid's output; latitude +-90 of a
 *   longitude-latitude grid) gets its mean. The mean is correct for scalars and Cartesian vectors,
 *   but not for eastward and northward components: smooth vtkGlobeGrid's Wind instead.
 * - Missing data. Hidden points (HIDDENPOINT), values that are not finite and fill values (1e30 or
 *   more) are ignored and stay unchanged.
 *
 * Float and double arrays keep their type, and integers become double. Every component of an array
 * is smoothed separately. All other arrays are passed on. The order of the computation is fixed:
 * the result does not depend on the number of threads.
 *
 * Adjacent grids of a group on the same process with the same arrays are smoothed as one grid, so
 * that values at common faces agree.
 *
 * In parallel each process requests the whole input, because seam and poles join points with
 * distant indices, and outputs its piece.
 */
#ifndef vtkStructuredSmoothing_h
#define vtkStructuredSmoothing_h

#include "vtkDataSetAlgorithm.h"
#include "vtkNephoscopeFiltersCloudSurfaceModule.h" // for export macro

#include <memory> // for members
#include <string> // for array names
#include <vector> // for array names

class vtkDataArray;

namespace nephoscope
{
class BlockNeighbours;
class BlocksWithArray;
class SmoothingPlan;
struct SmoothingSettings;
}

class VTKNEPHOSCOPEFILTERSCLOUDSURFACE_EXPORT vtkStructuredSmoothing : public vtkDataSetAlgorithm
{
public:
  static vtkStructuredSmoothing* New();
  vtkTypeMacro(vtkStructuredSmoothing, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CoordinatesType
  {
    AUTOMATIC = 0,
    CARTESIAN = 1,
    LONGITUDE_LATITUDE = 2
  };

  ///@{
  /**
   * Number of times the filter is applied, 0 to 1000. Default 1. 0 passes the input through. n
   * iterations smooth over about sqrt(n/2) points on either side (standard deviation); the cost is
   * proportional.
   */
  vtkSetClampMacro(NumberOfIterations, int, 0, 1000);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Whether the grid is periodic along an axis (0, 1, 2, also called I, J, K): the first point is
   * the neighbour of the last. Off by default. The filter detects a last point that repeats the
   * first (all point arrays repeat). Not needed for a seam that the filter detects (FindSeam), nor
   * for longitudes that Coordinates declares.
   */
  void SetPeriodic(int axis, bool periodic);
  bool GetPeriodic(int axis);
  void SetPeriodicI(bool periodic) { this->SetPeriodic(0, periodic); }
  void SetPeriodicJ(bool periodic) { this->SetPeriodic(1, periodic); }
  void SetPeriodicK(bool periodic) { this->SetPeriodic(2, periodic); }
  bool GetPeriodicI() { return this->Periodic[0]; }
  bool GetPeriodicJ() { return this->Periodic[1]; }
  bool GetPeriodicK() { return this->Periodic[2]; }
  ///@}

  ///@{
  /**
   * On (default): last points along an axis of a structured grid at the position of the first
   * points are treated as the same points.
   */
  vtkSetMacro(FindSeam, bool);
  vtkGetMacro(FindSeam, bool);
  vtkBooleanMacro(FindSeam, bool);
  ///@}

  ///@{
  /**
   * On: neighbours exchange amounts proportional to the smaller of their masses, which conserves
   * the sum of mass times field. Off (default): all masses are equal. The mass of a point is the
   * volume of the part of the grid nearest to it in index space: half a step on either side. On
   * longitudes and latitudes it is the product of the steps in longitude, in sin(latitude) (up to
   * the pole if the pole is within 0.8 of a step) and in level; for pressure levels this is
   * proportional to the mass of air.
   */
  vtkSetMacro(Conservative, bool);
  vtkGetMacro(Conservative, bool);
  vtkBooleanMacro(Conservative, bool);
  ///@}

  ///@{
  /**
   * Name of a point array of masses, one component, 0 or more, to use instead of volumes (Gauss
   * weights, masses of a model's layers). Default "": none. Only with Conservative.
   */
  vtkSetMacro(MassArrayName, std::string);
  vtkGetMacro(MassArrayName, std::string);
  ///@}

  ///@{
  /**
   * On: adds the masses as the point array Mass, double, 1 component. Points at a seam may
   * coincide: then only the first one has a mass, and the others have 0. Off by default. Unit: that
   * of the volume, or of the given masses; 1 each if not Conservative.
   */
  vtkSetMacro(GenerateMassArray, bool);
  vtkGetMacro(GenerateMassArray, bool);
  vtkBooleanMacro(GenerateMassArray, bool);
  ///@}

  ///@{
  /**
   * On: rows along axis 0 whose steps are shorter than those to the next rows, as near a pole, are
   * smoothed more often along axis 0, so that the reach in metres is the same in both directions.
   * The number of passes is (step across / step along)^2; if that is less than 1, one weaker pass
   * is made. Off (default): the filter works on indices, and its reach along a row shrinks towards
   * the poles. On a 2.5 degree grid an iteration costs about eight times as much.
   */
  vtkSetMacro(Isotropic, bool);
  vtkGetMacro(Isotropic, bool);
  vtkBooleanMacro(Isotropic, bool);
  ///@}

  ///@{
  /**
   * Meaning of the coordinates, for masses, poles and Isotropic. Cartesian: lengths. Longitude and
   * latitude: degrees on axes 0 and 1; if the longitudes span the globe, axis 0 is periodic.
   * Automatic (default): Cartesian, but longitude and latitude for images and rectilinear grids
   * with SetPeriodic(0, true) whose axis 0 spans 360 and whose axis 1 stays within -90 to 90.
   */
  vtkSetClampMacro(Coordinates, int, AUTOMATIC, LONGITUDE_LATITUDE);
  vtkGetMacro(Coordinates, int);
  void SetCoordinatesToAutomatic() { this->SetCoordinates(AUTOMATIC); }
  void SetCoordinatesToCartesian() { this->SetCoordinates(CARTESIAN); }
  void SetCoordinatesToLongitudeLatitude() { this->SetCoordinates(LONGITUDE_LATITUDE); }
  ///@}

  ///@{
  /**
   * The point arrays to smooth. By default the array of SetInputArrayToProcess, which itself
   * defaults to the active scalars. Names added here replace it; AllFloatArrays (off by default)
   * selects all float and double point arrays.
   */
  void AddArrayName(const std::string& name);
  void ClearArrayNames();
  int GetNumberOfArrayNames() { return static_cast<int>(this->ArrayNames.size()); }
  std::string GetArrayName(int i);
  vtkSetMacro(AllFloatArrays, bool);
  vtkGetMacro(AllFloatArrays, bool);
  vtkBooleanMacro(AllFloatArrays, bool);
  ///@}

#ifndef __VTK_WRAP__
  nephoscope::SmoothingSettings GetSettings() const;
#endif

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkStructuredSmoothing();
  ~vtkStructuredSmoothing() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkStructuredSmoothing(const vtkStructuredSmoothing&) = delete;
  void operator=(const vtkStructuredSmoothing&) = delete;

  bool HasArrays(vtkDataSet* block);
  bool FindArrays(vtkDataSet* input, vtkInformationVector** inputs, std::vector<int>& arrays);
  bool SmoothArrays(vtkDataSet* block, vtkDataSet* input, const nephoscope::SmoothingPlan& plan,
    const std::vector<int>& arrays, vtkDataSet* output);
  void AddMasses(vtkDataSet* block, vtkDataSet* input, const nephoscope::SmoothingPlan& plan,
    vtkDataSet* output);
  void BeginExecution();
  void EndExecution();

  int NumberOfIterations = 1;
  bool Periodic[3] = { false, false, false };
  bool FindSeam = true;
  bool Conservative = false;
  std::string MassArrayName;
  bool GenerateMassArray = false;
  bool Isotropic = false;
  int Coordinates = AUTOMATIC;
  std::vector<std::string> ArrayNames;
  bool AllFloatArrays = false;
  vtkMTimeType Failed = 0; // for ReportOnce
  int ExecutionDepth = 0;
  std::unique_ptr<nephoscope::BlocksWithArray> Blocks;     // some may lack the array
  std::unique_ptr<nephoscope::BlockNeighbours> Neighbours; // while a group is executed
  vtkMTimeType ToldOfInput = 0;                            // for HasOtherInput
};

#endif
