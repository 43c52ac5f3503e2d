// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSparseVolumeReader
 * @brief   reads the grids of a .vdb file as points, one for each active voxel, or as an image
 *
 *     .vdb file ──► grids that are chosen ──► active voxels
 *         ──► vtkPolyData: points, one array for a grid    (OutputToPoints)
 *         └─► vtkImageData of their bounding box           (OutputToImage)
 *
 * Points take memory only for active voxels. The field data array "IndexToWorld" (double, 16
 * components: the rows of a 4 x 4 matrix from voxel indices to positions) gives the shape of the
 * voxels; vtkTexturedSplatMapper draws splats of that shape. If tiles are kept whole, the point
 * array "VoxelScale" (float) gives the edge length of each in voxels.
 *
 * An image has the voxel indices as its extent and the transform as origin, spacing and direction;
 * inactive voxels have the grid's value there (its background value, with a minus sign inside level
 * sets).
 *
 * Values become arrays of float, double, int, long long or unsigned char (bool and mask), with 3
 * components for vectors; numbers saved with 16 bits become float. Staggered (MAC) velocities,
 * whose components are stored at the faces of voxels, are averaged to their centres. All chosen
 * grids share the lattice of the grid with the smallest voxels (the first by name, if several are
 * equal): grids with the same transform add their active voxels, others are interpolated there
 * (trilinearly; the nearest value for integers and bools).
 *
 * Sheared voxels can be read as points only; frustums and grids of points are rejected with a
 * message.
 *
 * A build without OpenVDB also has this class, but it fails with a message that gives the remedy
 * (HasOpenVDB).
 *
 * Reference: K. Museth, VDB: High-Resolution Sparse Volumes with Dynamic Topology, ACM Transactions
 * on Graphics 32(3), 2013 (Museth2013).
 */
#ifndef vtkSparseVolumeReader_h
#define vtkSparseVolumeReader_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkNephoscopeFiltersSparseVolumeModule.h" // for export macro
#include "vtkNew.h"                                 // for the selection

#include <memory> // for std::unique_ptr
#include <string> // for the file name

class vtkDataArraySelection;

class VTKNEPHOSCOPEFILTERSSPARSEVOLUME_EXPORT vtkSparseVolumeReader : public vtkDataObjectAlgorithm
{
public:
  static vtkSparseVolumeReader* New();
  vtkTypeMacro(vtkSparseVolumeReader, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Whether this build can read .vdb files. */
  static bool HasOpenVDB();

  ///@{
  /** Path of the file. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  /** 1 if the file begins like a .vdb file. */
  static int CanReadFile(VTK_FILEPATH const char* name);

  /**
   * Grids to read. UpdateInformation() fills in the names; all readable grids are selected by
   * default. If several grids have the same name, a number in brackets follows each name; a grid
   * without a name is "unnamed".
   */
  vtkDataArraySelection* GetGridSelection();

  ///@{
  /**
   * After UpdateInformation(): the grids of the file, from 0, by name, and whether one can be read.
   */
  int GetNumberOfGrids();
  std::string GetGridName(int grid);
  /**
   * Type of the values: "float", "double", "int32", "int64", "bool", "mask", "vec3s" (float),
   * "vec3d", "vec3i".
   */
  std::string GetGridType(int grid);
  /** "fog volume", "level set", "staggered" or "unknown". */
  std::string GetGridClass(int grid);
  /** Number of active voxels, including those of tiles. */
  vtkTypeInt64 GetGridNumberOfActiveVoxels(int grid);
  /**
   * First and last index of the active voxels along each axis; last is less than first if there are
   * none.
   */
  void GetGridExtent(int grid, int extent[6]);
  /** Edges of a voxel, in units of length of the file. */
  void GetGridSpacing(int grid, double spacing[3]);
  /** Why a grid cannot be read; empty if it can. */
  std::string GetGridRefusal(int grid);
  /** All of this in a sentence. */
  std::string GetGridDescription(int grid);
  ///@}

  enum OutputTypes
  {
    POINTS = 0,
    IMAGE = 1
  };
  ///@{
  /** Type of the output. Default: points. */
  vtkSetClampMacro(OutputType, int, POINTS, IMAGE);
  vtkGetMacro(OutputType, int);
  void SetOutputToPoints() { this->SetOutputType(POINTS); }
  void SetOutputToImage() { this->SetOutputType(IMAGE); }
  ///@}

  ///@{
  /**
   * Points: whether tiles (cubes of 8, 128 or 4096 voxels a side with one value) become a point for
   * every voxel. Off: one point at the centre of each tile, if a single grid is read. Ignored for
   * images. Default: on.
   */
  vtkSetMacro(SplitTiles, bool);
  vtkGetMacro(SplitTiles, bool);
  vtkBooleanMacro(SplitTiles, bool);
  ///@}

  ///@{
  /**
   * Maximum memory of the output, in GiB, > 0. Larger output is rejected with a message. Default:
   * 4.
   */
  vtkSetClampMacro(MemoryLimit, double, 1e-9, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkSparseVolumeReader();
  ~vtkSparseVolumeReader() override;

  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  std::string FileName;
  int OutputType = POINTS;
  bool SplitTiles = true;
  double MemoryLimit = 4.0;

private:
  vtkSparseVolumeReader(const vtkSparseVolumeReader&) = delete;
  void operator=(const vtkSparseVolumeReader&) = delete;

  vtkNew<vtkDataArraySelection> GridSelection;
  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
