// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where each sample of a dataset is and which shape its splat has, without making a list of them.
 *
 * Points that are voxels of a sparse volume have the shape of a voxel, where no cell size is asked
 * for: the columns of the matrix in the field data array "IndexToWorld" (16 numbers, row by row),
 * times the point array "VoxelScale" if there is one.
 */
#ifndef nephoscope_SplatShapes_h
#define nephoscope_SplatShapes_h

#include "CellSamples.h"
#include "GridSamples.h"
#include "SplatMatrix.h"
#include "SplatRegion.h"

#include "vtkNephoscopeRepresentationsTexturedSplatsModule.h" // for export macro
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkFieldData;

namespace nephoscope
{

struct SplatSampling
{
  bool OnCells = false;
  double CellSize =
    0; ///< edge of the cell of samples without a grid; 0: that of its voxel, or the mean spacing
  std::string ShapeArrayName = {}; ///< the columns of every sample's Jacobian, and perhaps its
                                   ///< share; empty: none
  double RadiusFactor = 1;         ///< on every Jacobian: splats that are so many times as wide
  SplatFrame Frame = {};
  std::string SizeArrayName = {}; ///< of one component: every sample's edge, or volume; empty: none
  bool SizesAreVolumes = false;
  bool FromCells = false;     ///< shapes of the cells around, where no cell size is asked for
  vtkDataSet* Mesh = nullptr; ///< whose first points are the samples, and which has all cells
                              ///< around them; null: the data
  bool FromNeighbors = false; ///< instead of the mean spacing: that of a point's neighbours
  bool WholeCells = false;    ///< a share is not what lies inside the data, but what is left of a
                              ///< splat that is wider than its cell
};

/** The arrays on cells, or those on points. */
vtkFieldData* AttributesOf(vtkDataSet* data, bool onCells);

/** Where a sample is: a point, or the centre of a cell. `grid`: of the same data. */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT Vector3 PlaceOf(
  vtkDataSet* data, const GridSamples& grid, bool onCells, vtkIdType id);

class VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT SplatShapes
{
public:
  /**
   * An array of shapes that is missing, or has neither nine nor ten components, is none. Without a
   * grid and a cell size it looks at every sample, to find the mean spacing.
   */
  SplatShapes(vtkDataSet* data, const SplatSampling& sampling);
  /** The problem with the array of sizes, or empty. */
  static std::string Check(vtkDataSet* data, const SplatSampling& sampling);

  /** Number of points or cells, hidden ones too. */
  vtkIdType GetNumberOfIds() const { return this->Count; }
  /**
   * Not hidden, not the repeated column of a closed grid or a point in the place of another, whose
   * splat represents both, not of cells that are nothing, and not a duplicate of what another rank
   * has, unless those are wanted.
   */
  bool IsVisible(vtkIdType id) const;
  /** Visible but for its size, which is not positive or not finite. */
  bool HasWrongSize(vtkIdType id) const { return !this->IsSized(id) && this->IsShown(id); }
  /** Its position may not be finite. */
  Vector3 Place(vtkIdType id) const { return PlaceOf(this->Data, this->Grid, this->OnCells, id); }
  /**
   * Edges of the sample's cell, times the radius factor; none is so short that the splat would be
   * flat.
   */
  SplatMatrix Jacobian(vtkIdType id) const;
  /**
   * The part of the sample's cell that counts: that of a point on the boundary of a mesh lies
   * partly outside.
   */
  double Share(vtkIdType id) const;
  /** The same, but for the ends of a grid. */
  double ShareInShown(vtkIdType id) const;
  bool HaveOneShape() const
  {
    return !this->ShapeArray && !this->SizeArray && this->Cells.IsEmpty() &&
      this->Spacing.empty() && (this->Grid.IsGrid() ? this->Grid.IsUniform() : !this->Scale);
  }
  /** Samples without shapes of their own, grid, voxels or cell size. */
  bool HaveMeanSpacing() const { return this->Spaced; }
  /** Shapes follow from the cells around the samples. */
  bool AreOfCells() const { return !this->Cells.IsEmpty(); }
  const GridSamples& GetGrid() const { return this->Grid; }
  /**
   * Samples that are voxels of a sparse volume: edges of the voxels, and the place of the one whose
   * indices are 0.
   */
  bool AreVoxels() const { return this->Voxels; }
  const SplatMatrix& GetVoxel() const { return this->Voxel; }
  const Vector3& GetFirstVoxel() const { return this->FirstVoxel; }

private:
  double FindMeanSpacing() const;
  void FindRepeated();
  double SizeOf(vtkIdType id) const;
  bool IsSized(vtkIdType id) const;
  bool IsShown(vtkIdType id) const;
  SplatMatrix OwnJacobian(vtkIdType id) const;
  double NumberOfShape(vtkIdType id, int number) const;
  bool FindVoxels();

  vtkDataSet* Data;
  bool OnCells;
  GridSamples Grid;
  vtkDataArray* ShapeArray = nullptr;
  const float* ShapeNumbers = nullptr; // of an array of floats: they are read quickly
  vtkDataArray* SizeArray = nullptr;
  bool SizesAreVolumes;
  CellSamples Cells;
  std::vector<float> Spacing; // of neighbours
  bool Spaced = false;
  std::vector<unsigned char> Hidden;
  std::vector<unsigned char> Repeated; // points of a surface in the place of another that is shown
  vtkIdType Count;
  double CellSize;
  double RadiusFactor;
  SplatMatrix Voxel{}; // the shape of samples without a grid
  bool Voxels = false; // they are those of a sparse volume
  Vector3 FirstVoxel{};
  vtkDataArray* Scale = nullptr; // of voxels of several sizes
};

/**
 * Bounds of the splats of visible samples: all that kernels of that radius (in cells) reach.
 * Invalid bounds if there are none.
 */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT void FindSplatBounds(
  const SplatShapes& shapes, double kernelRadius, double bounds[6]);

} // namespace nephoscope

#endif
