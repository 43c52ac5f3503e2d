// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The functions of OpenVDB that the writer uses. No OpenVDB header is needed here, as in VdbFile.h.
 */
#ifndef nephoscope_VdbWriting_h
#define nephoscope_VdbWriting_h

#include <map>
#include <string>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

enum class VdbPrecision
{
  AsInput,
  Single,
  Half
};

enum class VdbCompression
{
  None,
  Zip,
  Blosc
};

struct VdbWriteSettings
{
  std::string File;
  std::string Creator;
  std::vector<std::string> Arrays;          ///< to write; all if empty
  std::map<std::string, std::string> Names; ///< of grids, where they differ from those of arrays
  double Tolerance = 0;                     ///< values up to it are background
  VdbPrecision Precision = VdbPrecision::AsInput;
  VdbCompression Compression = VdbCompression::Blosc;
  double VoxelSize = 0;  ///< of particles; 0: their mean spacing
  std::string MassArray; ///< of particles; empty: 1 for each
};

/**
 * Writes the arrays of an image, of sparse voxels as points, or of particles. Returns an error, or
 * nothing.
 */
std::string WriteVdb(
  const VdbWriteSettings& settings, vtkDataSet* data, std::vector<std::string>& warnings);

} // namespace nephoscope

#endif
