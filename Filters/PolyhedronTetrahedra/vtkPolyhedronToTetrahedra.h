// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyhedronToTetrahedra
 * @brief   divides the polyhedra that are not convex into tetrahedra
 *
 *     vtkUnstructuredGrid ──► every VTK_POLYHEDRON: convex? ── yes ──► passed
 *                                                     └─────── no ───► tetrahedra inside the cell
 *
 * Algorithms that assume convex cells give correct results on the output. Neighbours stay
 * conforming: the triangles of a face depend only on the face, no point is added on a face, and
 * vtkCellCompositingMapper cuts the faces of undivided cells into the same triangles. Volumes are
 * conserved, and no tetrahedron is inverted.
 *
 * A cell counts as convex if no vertex lies outside the mean plane of a face by more than the warp
 * of the cell's most warped face, and if the tetrahedra from its first vertex, by which it would be
 * drawn, fill it. Cells with slightly warped faces, as in dual meshes and in layers over terrain,
 * are therefore passed on.
 *
 * A cell is divided by the first of these methods that works:
 * 1. all tetrahedra share one of its vertices;
 * 2. all share one new point, near the middle of the cell's kernel, the region from which the whole
 *    interior is visible;
 * 3. TetGen (Si2015), if the build has it: for cells in which no single point sees everything,
 *    including cells with tunnels and cavities.
 *
 * The tetrahedra get every cell array. At new points, point arrays are mean-value interpolations
 * (JuSchaeferWarren2005): exact for linear fields, never outside the range of the cell's values.
 * Integers are rounded.
 *
 * A cell that cannot be divided, because its faces do not close, a coordinate is not finite, or it
 * needs TetGen, is passed on unchanged. One warning names the first such cell and the remedy. Cells
 * that a ghost array hides, or that touch a hidden point, are passed on unchecked. Datasets other
 * than vtkUnstructuredGrid are passed on.
 *
 * All steps run in parallel except TetGen, which keeps its state in global variables. It runs in a
 * separate process, so that its failure gives a message instead of a crash. The result does not
 * depend on the number of threads.
 */
#ifndef vtkPolyhedronToTetrahedra_h
#define vtkPolyhedronToTetrahedra_h

#include "vtkDataSetAlgorithm.h"
#include "vtkNephoscopeFiltersPolyhedronTetrahedraModule.h" // for export macro

#include <cstddef>
#include <vector> // for lists of cells

class VTKNEPHOSCOPEFILTERSPOLYHEDRONTETRAHEDRA_EXPORT vtkPolyhedronToTetrahedra
  : public vtkDataSetAlgorithm
{
public:
  static vtkPolyhedronToTetrahedra* New();
  vtkTypeMacro(vtkPolyhedronToTetrahedra, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Divides convex polyhedra too, so that no polyhedron is left. Default: off. */
  vtkSetMacro(DivideConvexPolyhedra, bool);
  vtkGetMacro(DivideConvexPolyhedra, bool);
  vtkBooleanMacro(DivideConvexPolyhedra, bool);
  ///@}

  ///@{
  /**
   * Largest distance of a face's vertices from its mean plane, as a fraction of the diagonal of the
   * cell's bounding box, at which the face still counts as planar: 0 to 1, default 0.1. 0: every
   * cell with a warped face is divided. Cells that would be drawn wrong are always divided.
   */
  vtkSetClampMacro(FaceWarpTolerance, double, 0.0, 1.0);
  vtkGetMacro(FaceWarpTolerance, double);
  ///@}

  ///@{
  /**
   * Uses TetGen, if the build has it, for cells that are not star-shaped (no inner point sees all
   * of the interior). Default: on.
   */
  vtkSetMacro(UseTetGen, bool);
  vtkGetMacro(UseTetGen, bool);
  vtkBooleanMacro(UseTetGen, bool);
  ///@}

  /** Whether the build has TetGen. */
  static bool HasTetGen();

  ///@{
  /**
   * Results of the last execution: numbers of divided cells, of added points, and of cells that
   * could not be divided.
   */
  vtkGetMacro(NumberOfDividedCells, vtkIdType);
  vtkGetMacro(NumberOfNewPoints, vtkIdType);
  vtkGetMacro(NumberOfUndividedCells, vtkIdType);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkPolyhedronToTetrahedra() = default;
  ~vtkPolyhedronToTetrahedra() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPolyhedronToTetrahedra(const vtkPolyhedronToTetrahedra&) = delete;
  void operator=(const vtkPolyhedronToTetrahedra&) = delete;

  struct vtkWork;
  void DivideInParallel(vtkWork& work);
  void DivideByTetGen(vtkWork& work);
  void DivideBatchByTetGen(vtkWork& work, const std::vector<std::size_t>& cells);
  void Report(const vtkWork& work);

  bool DivideConvexPolyhedra = false;
  double FaceWarpTolerance = 0.1;
  bool UseTetGen = true;
  vtkMTimeType ToldOfInput = 0; // for HasOtherInput
  vtkMTimeType ToldOfEmptiness = 0;
  vtkIdType NumberOfDividedCells = 0;
  vtkIdType NumberOfNewPoints = 0;
  vtkIdType NumberOfUndividedCells = 0;
};

#endif
