// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkContourCellSplitter
 * @brief   cells divided at contour values, with the contour surfaces between them
 *
 *     any dataset with 3-D cells, a point scalar, values v0 < v1 < ...
 *                                  |
 *                      vtkContourCellSplitter
 *                                  |
 *     vtkUnstructuredGrid: convex pieces in one layer each,
 *                          Layer 0 | v0 | Layer 1 | v1 | Layer 2 ...,
 *                          and the triangles and quadrilaterals of the contour surfaces
 *
 * Every 3-D cell that a value crosses is divided into tetrahedra, pyramids, wedges and hexahedra
 * that lie on one side of every value, as Max, Crawfis and Becker (1993), section 2, divide cells
 * so that colour and opacity may be discontinuous at a contour surface. All other 3-D cells stay
 * unchanged.
 *
 * 1. Give each point a code: the values between which it lies, or the value on which it lies.
 * 2. Divide the crossed cells into tetrahedra; every face as a fan from its first vertex (by x,
 *    then y, then z), so that neighbours agree (Dompierre et al. 1999). The scalar is linear in
 *    each.
 * 3. Divide the tetrahedra into slabs between the values.
 * 4. Give each cut of an edge one number; place it; interpolate the arrays.
 *
 * Neighbouring divided cells share whole faces. Where an undivided cell shares a quadrilateral with
 * a divided cell, the divided cell has the two triangles of step 2. There is no hanging point, and
 * if the four vertices are not coplanar, the two triangles define the face.
 * vtkCellCompositingMapper draws the face in this way, and PolyhedralTransitions writes it in this
 * way.
 *
 * Points 0 to n-1 of the output are those of the input. The cuts follow: one for each edge and
 * value, at which the scalar is exactly the value. An integer scalar array becomes double; for a
 * float array, values are rounded to float. Other point arrays are interpolated linearly along the
 * edge (text and bits: from the nearer end; global and pedigree ids: -1, and the arrays are no
 * longer active). Where only the centre of a cell sees all its faces (polyhedra with faces in one
 * plane, warped hexahedra), it becomes a point too, with the mean of the vertices' values. A scalar
 * that differs from a value only by rounding is set to the value. This means a difference below
 * 1e-12 of the scalar's range in the cell, or one so small that rounding would determine the
 * position of the cut. Two values whose relative difference is below 1e-12 count as one.
 *
 * Cell arrays are copied to the pieces. Cell arrays written:
 * - Layer, int, 1 component: the number of distinct values less than the largest scalar of the
 *   piece, 0 to n. All scalars of a piece in layer k are in [v(k-1), v(k)]. -1: the cell is left
 *   whole because a scalar is not a finite number or it has no volume. For a polygon the number of
 *   values less than its own.
 * - ContourIndex, int, 1 component: for a polygon the index i of its value, as in SetValue(i, v)
 *   (of equal values the first one); -1 for 3-D cells.
 *
 * The polygons come after all 3-D cells. They face the higher scalars (right-hand rule) and have
 * the cell arrays of the cell that they were cut from. If the scalar equals the value on whole
 * faces of cells, the surface consists of the triangles of those faces that have a piece above the
 * value on at least one side. Each triangle appears once, even with such pieces on both sides.
 *
 * Hidden and refined cells (vtkGhostType, blanking) and cells that touch hidden points are left
 * out; duplicate (ghost) cells are divided like others and stay ghosts. Cells that are not
 * three-dimensional are left out with a warning. Quadratic and other non-linear cells that are
 * crossed are divided as VTK triangulates them, with a warning. Cells must be convex; other cells
 * are divided nevertheless, with a warning.
 *
 * Parallel (vtkSMPTools); the output does not depend on the number of threads. Blocks are divided
 * one by one; those that lack the array are left out, as by vtkContourFilter, and it is an error if
 * all of them do.
 */
#ifndef vtkContourCellSplitter_h
#define vtkContourCellSplitter_h

#include "vtkContourValues.h"                          // for inline methods
#include "vtkNephoscopeFiltersCellSubdivisionModule.h" // for export macro
#include "vtkNew.h"                                    // for the values
#include "vtkUnstructuredGridAlgorithm.h"

#include <array>  // for members
#include <memory> // for members
#include <string> // for messages
#include <vector> // for batches

namespace nephoscope
{
class BlocksWithArray;
class ContourLevels;
class ContourScalars;
struct SplitBatch;
}
class vtkDataArray;

class VTKNEPHOSCOPEFILTERSCELLSUBDIVISION_EXPORT vtkContourCellSplitter
  : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkContourCellSplitter* New();
  vtkTypeMacro(vtkContourCellSplitter, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The contour values, finite, in the unit of the scalar, in any order; duplicates count once. As
   * in vtkContourFilter, the default is the single value 0. Without any value all cells stay whole,
   * in layer 0. SetInputArrayToProcess selects the scalar (a point array of one component); the
   * default is the active point scalars.
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
   * On (default): the output has the polygons of the contour surfaces after the 3-D cells.
   */
  vtkSetMacro(GenerateSurfaces, bool);
  vtkGetMacro(GenerateSurfaces, bool);
  vtkBooleanMacro(GenerateSurfaces, bool);
  ///@}

  ///@{
  /**
   * Off (default): every cell that no value crosses keeps its type. On: such cells that share a
   * polygon with a divided cell become polyhedra (VTK_POLYHEDRON) with the same points, with the
   * two or more triangles of that polygon as faces. Every face is then shared by two cells or lies
   * in the boundary, even if its four vertices are not coplanar. Faces are recognised by their
   * points.
   */
  vtkSetMacro(PolyhedralTransitions, bool);
  vtkGetMacro(PolyhedralTransitions, bool);
  vtkBooleanMacro(PolyhedralTransitions, bool);
  ///@}

  ///@{
  /**
   * Coordinates of the output: vtkAlgorithm::DOUBLE_PRECISION (default), SINGLE_PRECISION, or
   * DEFAULT_PRECISION, which is that of the input's points (image data and rectilinear grids:
   * double). Only double conserves the volume to rounding error; single precision can invert thin
   * pieces.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /** The later modification time of this filter and its contour values. */
  vtkMTimeType GetMTime() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkContourCellSplitter();
  ~vtkContourCellSplitter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkContourCellSplitter(const vtkContourCellSplitter&) = delete;
  void operator=(const vtkContourCellSplitter&) = delete;

  vtkDataArray* FindScalars(vtkDataSet* input, vtkInformationVector** inputs);
  bool FindLevels(vtkDataArray* scalars, nephoscope::ContourLevels& levels);
  bool SplitCells(vtkDataSet* input, const nephoscope::ContourScalars& scalars,
    std::vector<nephoscope::SplitBatch>& batches);
  void Assemble(vtkDataSet* input, vtkDataArray* array, const nephoscope::ContourScalars& scalars,
    std::vector<nephoscope::SplitBatch>& batches, vtkUnstructuredGrid* output);
  bool TakesDefaultValue();
  std::string ReasonForNoDivision(vtkDataArray* array);
  void BeginExecution();
  void EndExecution();
  void Warn(
    vtkDataSet* input, vtkDataArray* array, const std::vector<nephoscope::SplitBatch>& batches);

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
  bool GenerateSurfaces = true;
  bool PolyhedralTransitions = false;
  int OutputPointsPrecision = DOUBLE_PRECISION;
  std::string Reason; // why no cell is divided
  std::array<double, 2> DefaultRange = { 0.0,
    0.0 }; // of the scalars of all blocks, used if no value is given
  bool HasDivided = false;
  int ExecutionDepth = 0;
  std::unique_ptr<nephoscope::BlocksWithArray> Blocks; // some may lack the array
  vtkMTimeType ToldOfInput = 0;                        // for HasOtherInput
  vtkMTimeType ToldOfEmptiness = 0;
};

#endif
