// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyhedronToTetrahedra
 * @brief   divides the polyhedra that are not convex into tetrahedra
 *
 *     vtkUnstructuredGrid ──► every VTK_POLYHEDRON: convex? ── yes ──► passed
 *                                                     └─────── no ───► tetrahedra inside the cell
 *
 * What draws or cuts cells as if they were convex is right on the output. Neighbours stay conforming: the triangles that a
 * face is cut into depend on the face alone, no point is added on a face, and they are those by which
 * vtkCellCompositingMapper cuts the faces of the cells that are passed. Volumes are conserved, and no tetrahedron is inverted.
 *
 * A cell counts as convex if no vertex lies outside the mean plane of a face by more than the most warped face of the cell is warped,
 * and if the tetrahedra over its least vertex, by which it would be drawn, fill it; so cells with
 * slightly warped faces, as those of dual meshes and of layers over terrain, are passed.
 *
 * A cell is divided by the first of these that fits:
 * 1. all tetrahedra share one of its vertices;
 * 2. all share one new point, near the middle of the region from which the whole inside is seen (the cell's kernel);
 * 3. TetGen (Si2015), if the build has it: for cells that no single point sees the whole of, also with tunnels and cavities.
 *
 * Every cell array is carried to the tetrahedra. At new points, point arrays are mean-value interpolations
 * (JuSchaeferWarren2005): exact for linear fields, never outside the range of the cell's values. Integers are rounded.
 *
 * A cell that cannot be divided is passed as it is, with one warning that names the first such cell and the remedy: its faces do not
 * close, a coordinate is not finite, or it needs TetGen. Cells that a ghost array hides, or that touch a hidden point, are
 * passed without being looked at. Datasets other than vtkUnstructuredGrid are passed.
 *
 * The work runs in parallel but for TetGen's, which keeps its state in variables of the process; it runs in a process of its own, so
 * that a failure of it is a message and no crash. The result does not depend on the number of threads.
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
   * Largest distance of a face's vertices from its mean plane, as a fraction of the diagonal of the cell's bounding box, at which
   * the face still counts as planar: 0 to 1, default 0.1. 0: every cell with a warped face is divided. Cells that would be drawn
   * wrong are always divided.
   */
  vtkSetClampMacro(FaceWarpTolerance, double, 0.0, 1.0);
  vtkGetMacro(FaceWarpTolerance, double);
  ///@}

  ///@{
  /** Uses TetGen, if the build has it, for cells that are not star-shaped (no inner point sees all of the interior). Default: on. */
  vtkSetMacro(UseTetGen, bool);
  vtkGetMacro(UseTetGen, bool);
  vtkBooleanMacro(UseTetGen, bool);
  ///@}

  /** Whether the build has TetGen. */
  static bool HasTetGen();

  ///@{
  /** What the last execution did: cells divided, points added, cells that should have been divided and could not be. */
  vtkGetMacro(NumberOfDividedCells, vtkIdType);
  vtkGetMacro(NumberOfNewPoints, vtkIdType);
  vtkGetMacro(NumberOfUndividedCells, vtkIdType);
  ///@}

protected:
  vtkPolyhedronToTetrahedra() = default;
  ~vtkPolyhedronToTetrahedra() override = default;

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
  vtkIdType NumberOfDividedCells = 0;
  vtkIdType NumberOfNewPoints = 0;
  vtkIdType NumberOfUndividedCells = 0;
};

#endif
