// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The functions of OpenVDB that the VTK classes use. No OpenVDB header is needed here: a build
 * without OpenVDB has the same functions, which fail with a sentence that gives the remedy
 * (NoOpenVDB.cxx).
 */
#ifndef nephoscope_VdbFile_h
#define nephoscope_VdbFile_h

#include "AffineGrid.h"

#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace nephoscope
{

bool HasOpenVDB();

/** A grid of a file, described by its metadata. */
struct VdbGridInfo
{
  std::string Name;    ///< unique in the file: of several grids of a name, the later ones have a
                       ///< number in brackets
  std::string Type;    ///< of the values: "float", "vec3s", ...
  std::string Class;   ///< "fog volume", "level set", "staggered" or "unknown"
  std::string Refusal; ///< why it cannot be read; empty if it can
  bool Staggered = false;
  bool Half = false; ///< saved with 16 bits for a number
  vtkTypeInt64 ActiveVoxels = 0;
  int Extent[6] = { 0, -1, 0, -1, 0, -1 }; ///< indices of the active voxels: first and last
  AffineMatrix IndexToWorld{};

  bool IsEmpty() const { return this->Extent[1] < this->Extent[0]; }
};

/** The grids of a file, by name; empty with an `error` if it cannot be read. */
std::vector<VdbGridInfo> ListVdbGrids(const std::string& file, std::string& error);

struct VdbRequest
{
  std::string File;
  std::vector<VdbGridInfo> Grids; ///< those to read; the first gives the lattice
  bool SplitTiles = true;         ///< points: one for every voxel of a tile
  double MemoryLimit = 0;         ///< bytes
  std::function<bool()> Aborted;
};

/**
 * The active voxels as points with one array for a grid. Returns an error, or nothing. Sentences to
 * warn of are appended.
 * Grids of the first one's lattice add their active voxels; others are interpolated at these.
 */
std::string ReadVdbPoints(
  const VdbRequest& request, vtkPolyData* points, std::vector<std::string>& warnings);

/** The same on all points of the image, whose lattice and extent are set. */
std::string ReadVdbImage(
  const VdbRequest& request, vtkImageData* image, std::vector<std::string>& warnings);

} // namespace nephoscope

#endif
