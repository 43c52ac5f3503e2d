// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSparseVolumeWriter
 * @brief   writes images, sparse voxels and particles as grids of a .vdb file
 *
 *     vtkImageData: point and cell arrays ──────────► voxels that are not background ┐
 *     vtkPolyData of vtkSparseVolumeReader ─────────► the same voxels                ├─► tiles
 *     vtkPolyData, vtkUnstructuredGrid of vertices ─► density and weighted means     ┘     │
 *                                                                where constant, .vdb file ◄┘
 *
 * - Image: a grid for every array of one or three components; values up to Tolerance, hidden points
 *   and NaN become background and take no memory. Voxel centres are the points, or the centres of
 *   the cells.
 * - Points with the field data array "IndexToWorld": the voxels from which they were read.
 * - Particles: "density" is their mass over volume, distributed over the eight voxels around each
 *   particle, which conserves the mass and its centre (cloud in cell, HockneyEastwood1988); other
 *   arrays become mass-weighted means.
 *
 * Other data are rejected with a message: resample them to an image first.
 *
 * Scalars have the class "fog volume", which Blender and Houdini draw. Blender looks for grids
 * "density", "temperature", "velocity", Houdini for "density", "temperature", "vel": rename with
 * SetGridName. Vectors named v, or with vel or wind in the name, are marked as velocities
 * (contravariant relative), so that Houdini rotates them with the volume.
 *
 * A build without OpenVDB also has this class, but it fails with a message that gives the remedy
 * (vtkSparseVolumeReader::HasOpenVDB).
 */
#ifndef vtkSparseVolumeWriter_h
#define vtkSparseVolumeWriter_h

#include "vtkNephoscopeFiltersSparseVolumeModule.h" // for export macro
#include "vtkWriter.h"

#include <map>    // for names of grids
#include <string> // for names
#include <vector> // for names of arrays

class VTKNEPHOSCOPEFILTERSSPARSEVOLUME_EXPORT vtkSparseVolumeWriter : public vtkWriter
{
public:
  static vtkSparseVolumeWriter* New();
  vtkTypeMacro(vtkSparseVolumeWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. An existing file is overwritten. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  ///@{
  /** Arrays to write, by name. If the list is empty (default): all arrays. */
  void AddArrayName(const char* name);
  void ClearArrayNames();
  ///@}

  ///@{
  /**
   * Name of an array's grid. Default: the name of the array. "density" is the density of particles.
   */
  void SetGridName(const char* array, const char* grid);
  void ClearGridNames();
  ///@}

  ///@{
  /**
   * Image values, and lengths of vectors, up to this value become background, 0. In the unit of the
   * arrays, >= 0. Default: 0, which is lossless.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  enum PrecisionType
  {
    INPUT_PRECISION = 0,
    SINGLE_PRECISION = 1,
    HALF_PRECISION = 2
  };
  ///@{
  /**
   * Precision of floating-point numbers: that of the input, 32 bits, or 16 bits (11 bits of
   * precision, up to 65504; half the size). Default: that of the input.
   */
  vtkSetClampMacro(Precision, int, INPUT_PRECISION, HALF_PRECISION);
  vtkGetMacro(Precision, int);
  void SetPrecisionToInput() { this->SetPrecision(INPUT_PRECISION); }
  void SetPrecisionToSingle() { this->SetPrecision(SINGLE_PRECISION); }
  void SetPrecisionToHalf() { this->SetPrecision(HALF_PRECISION); }
  ///@}

  enum CompressionType
  {
    NO_COMPRESSION = 0,
    ZIP_COMPRESSION = 1,
    BLOSC_COMPRESSION = 2
  };
  ///@{
  /**
   * Blosc is fast; Zip is slow, and OpenVDB applies it only to vectors and integers, not to fog
   * volumes. Default: Blosc.
   */
  vtkSetClampMacro(Compression, int, NO_COMPRESSION, BLOSC_COMPRESSION);
  vtkGetMacro(Compression, int);
  void SetCompressionToNone() { this->SetCompression(NO_COMPRESSION); }
  void SetCompressionToZip() { this->SetCompression(ZIP_COMPRESSION); }
  void SetCompressionToBlosc() { this->SetCompression(BLOSC_COMPRESSION); }
  ///@}

  ///@{
  /**
   * Particles: edge length of a voxel, in units of length. 0 (default): the mean spacing of the
   * particles.
   */
  vtkSetClampMacro(VoxelSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /**
   * Particles: point array of their masses, >= 0. Empty (default): each mass is 1, so that density
   * is a number density.
   */
  vtkSetMacro(MassArrayName, std::string);
  vtkGetMacro(MassArrayName, std::string);
  ///@}

protected:
  vtkSparseVolumeWriter() = default;
  ~vtkSparseVolumeWriter() override = default;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  std::string FileName;
  double Tolerance = 0.0;
  int Precision = INPUT_PRECISION;
  int Compression = BLOSC_COMPRESSION;
  double VoxelSize = 0.0;
  std::string MassArrayName;

private:
  vtkSparseVolumeWriter(const vtkSparseVolumeWriter&) = delete;
  void operator=(const vtkSparseVolumeWriter&) = delete;

  std::vector<std::string> ArrayNames;
  std::map<std::string, std::string> GridNames;
};

#endif
