// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCloudSurface
 * @brief   contour surfaces of a smoothed field on a structured grid, with every point array
 *
 *     image, rectilinear or structured grid, a point scalar, values
 *                               |
 *     smooth (vtkStructuredSmoothing) -> contour (vtkFlyingEdges3D) -> drop what is hidden
 *                               |
 *     join seams and poles -> normals
 *                               |
 *     vtkPolyData: triangles, all point arrays, Normals, ContourIndex
 *
 * Max, Crawfis and Becker, "New Techniques in 3D Scalar and Vector Field Visualization", Pacific
 * Graphics 1993, section 4, draw clouds as contour surfaces of the smoothed cloud fraction. Only
 * the contoured array is smoothed; all other arrays are interpolated without smoothing.
 *
 * 1. Smooth, in double precision. Points with the same position (the seam and the poles of
 *    vtkGlobeGrid's output) get one value.
 * 2. Contour in index space, where every structured grid is an image, so that VTK's fastest filter
 *    can be used; positions and arrays are interpolated along the edges of the grid.
 * 3. Drop the triangles in cells that are hidden (HIDDENCELL, or a corner HIDDENPOINT), are ghosts
 *    of another piece (DUPLICATECELL) or have a corner without a value.
 * 4. Points on both sides of a seam, and those of a row at a pole, become one: the surface is
 *    closed there. Arrays that jump at the seam, such as a longitude, keep the value of the first
 *    column.
 * 5. Normals: opposite to the gradient of the smoothed field in the space of the grid, and
 *    therefore out of the cloud if the field is higher inside. They are not means of the triangles'
 *    normals. Triangles face the same way (right-hand rule).
 *
 * Point arrays written: those of the input, under the same names. The contoured array has the value
 * of the contour (float if it is float, otherwise double). Numbers are interpolated linearly
 * (integers to float, as VTK does); text, bits and ids come from the nearer point; Normals, float,
 * 3 components, of length 1. vtkGhostType is not passed on. Cell array written: ContourIndex, int,
 * the index i of the value, as in SetValue(i, v).
 * Coordinates have the precision of the input's points; double for images and rectilinear grids.
 *
 * Adjacent grids of a group are smoothed and contoured as one grid: each gets ghost cells from its
 * neighbours (on the same process and with the same arrays), so that the surface has no crack
 * between them.
 *
 * In parallel each process requests the whole input and contours its part of the cells; the pieces
 * fit together and have the same normals.
 * The result does not depend on the number of threads.
 */
#ifndef vtkCloudSurface_h
#define vtkCloudSurface_h

#include "vtkContourValues.h"                       // for inline methods
#include "vtkNephoscopeFiltersCloudSurfaceModule.h" // for export macro
#include "vtkNew.h"                                 // for members
#include "vtkPolyDataAlgorithm.h"
#include "vtkStructuredSmoothing.h" // for inline methods

#include <memory> // for members
#include <string> // for array names
#include <vector> // for values

class vtkDataArray;

namespace nephoscope
{
class BlockNeighbours;
class BlocksWithArray;
class SmoothingPlan;
}

class VTKNEPHOSCOPEFILTERSCLOUDSURFACE_EXPORT vtkCloudSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkCloudSurface* New();
  vtkTypeMacro(vtkCloudSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The contour values, finite, in the unit of the scalar, in any order; duplicates count once. As
   * in vtkContourFilter, the default is the single value 0. SetInputArrayToProcess selects the
   * scalar (a point array of one component); the default is the active point scalars.
   */
  void SetValue(int i, double value);
  double GetValue(int i) { return this->ContourValues->GetValue(i); }
  double* GetValues() { return this->ContourValues->GetValues(); }
  void GetValues(double* contourValues) { this->ContourValues->GetValues(contourValues); }
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours() { return this->ContourValues->GetNumberOfContours(); }
  ///@}

  ///@{
  /**
   * Sets this number of values at equal steps, from the first to the last of the range.
   */
  void GenerateValues(int numContours, double range[2])
  {
    this->GivenValues()->GenerateValues(numContours, range);
  }
  void GenerateValues(int numContours, double rangeStart, double rangeEnd)
  {
    this->GivenValues()->GenerateValues(numContours, rangeStart, rangeEnd);
  }
  ///@}

  ///@{
  /**
   * Number of times the 3 x 3 x 3 filter is applied before contouring, 0 or more. Default 1. See
   * vtkStructuredSmoothing.
   */
  void SetNumberOfSmoothingIterations(int number)
  {
    this->Smoothing->SetNumberOfIterations(number);
  }
  int GetNumberOfSmoothingIterations() { return this->Smoothing->GetNumberOfIterations(); }
  ///@}

  ///@{
  /**
   * Settings of the smoothing and of periodic axes, as in vtkStructuredSmoothing. A periodic
   * structured grid whose last points are neighbours of the first points in space gets a row of
   * cells between them.
   */
  void SetPeriodic(int axis, bool periodic) { this->Smoothing->SetPeriodic(axis, periodic); }
  bool GetPeriodic(int axis) { return this->Smoothing->GetPeriodic(axis); }
  void SetPeriodicI(bool periodic) { this->Smoothing->SetPeriodic(0, periodic); }
  void SetPeriodicJ(bool periodic) { this->Smoothing->SetPeriodic(1, periodic); }
  void SetPeriodicK(bool periodic) { this->Smoothing->SetPeriodic(2, periodic); }
  bool GetPeriodicI() { return this->Smoothing->GetPeriodic(0); }
  bool GetPeriodicJ() { return this->Smoothing->GetPeriodic(1); }
  bool GetPeriodicK() { return this->Smoothing->GetPeriodic(2); }
  void SetFindSeam(bool find) { this->Smoothing->SetFindSeam(find); }
  bool GetFindSeam() { return this->Smoothing->GetFindSeam(); }
  void SetConservative(bool conservative) { this->Smoothing->SetConservative(conservative); }
  bool GetConservative() { return this->Smoothing->GetConservative(); }
  void SetMassArrayName(const std::string& name) { this->Smoothing->SetMassArrayName(name); }
  std::string GetMassArrayName() { return this->Smoothing->GetMassArrayName(); }
  void SetIsotropic(bool isotropic) { this->Smoothing->SetIsotropic(isotropic); }
  bool GetIsotropic() { return this->Smoothing->GetIsotropic(); }
  void SetCoordinates(int coordinates) { this->Smoothing->SetCoordinates(coordinates); }
  int GetCoordinates() { return this->Smoothing->GetCoordinates(); }
  void SetCoordinatesToAutomatic() { this->SetCoordinates(vtkStructuredSmoothing::AUTOMATIC); }
  void SetCoordinatesToCartesian() { this->SetCoordinates(vtkStructuredSmoothing::CARTESIAN); }
  void SetCoordinatesToLongitudeLatitude()
  {
    this->SetCoordinates(vtkStructuredSmoothing::LONGITUDE_LATITUDE);
  }
  ///@}

  ///@{
  /**
   * On (default): writes Normals from the gradient of the smoothed field.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /**
   * On (default): points of a seam or a pole with the same position are merged. Off: each column
   * keeps its own points, so that arrays that are discontinuous there, such as texture coordinates,
   * are correct on both sides.
   */
  vtkSetMacro(JoinSeams, bool);
  vtkGetMacro(JoinSeams, bool);
  vtkBooleanMacro(JoinSeams, bool);
  ///@}

  /** The latest modification time of this filter, its contour values and its smoothing. */
  vtkMTimeType GetMTime() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkCloudSurface();
  ~vtkCloudSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkCloudSurface(const vtkCloudSurface&) = delete;
  void operator=(const vtkCloudSurface&) = delete;

  std::string ReasonOfEmptiness(vtkDataArray* scalars, const std::vector<double>& field,
    const std::vector<double>& values, vtkInformation* outInfo);
  bool TakesDefaultValue();
  void BeginExecution();
  void EndExecution();
  vtkDataArray* FindScalars(vtkDataSet* input, vtkInformationVector** inputs);
  bool FindValues(std::vector<double>& values, std::vector<int>& indices);
  bool BuildSurface(vtkDataSet* input, const nephoscope::SmoothingPlan& plan, vtkDataArray* scalars,
    vtkInformation* outInfo, vtkPolyData* output);

  vtkContourValues* GivenValues()
  {
    if (!this->AreValuesGiven)
    {
      this->AreValuesGiven = true;
      this->Modified();
    }
    return this->ContourValues;
  }

  vtkNew<vtkContourValues> ContourValues;
  bool AreValuesGiven = false;
  double DefaultValue = 0.0;                // of all blocks, used if no value is given
  vtkNew<vtkStructuredSmoothing> Smoothing; // holds the settings
  bool ComputeNormals = true;
  bool JoinSeams = true;
  std::string Reason; // why there is no surface
  bool HasSurface = false;
  int ExecutionDepth = 0;
  std::unique_ptr<nephoscope::BlocksWithArray> Blocks;     // some may lack the array
  std::unique_ptr<nephoscope::BlockNeighbours> Neighbours; // while a group is executed
  vtkMTimeType ToldOfInput = 0;                            // for HasOtherInput
};

#endif
