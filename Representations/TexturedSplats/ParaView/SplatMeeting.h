// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The data exchanged by ranks that draw one picture of splats: lengths, speeds, and the splats at
 * the borders of their regions.
 */
#ifndef nephoscope_SplatMeeting_h
#define nephoscope_SplatMeeting_h

#include "SplatReach.h"
#include "SplatRegion.h"
#include "SplatSpeeds.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkBoundingBox;
class vtkDataSet;

namespace nephoscope
{

/** The common measures of the samples of all ranks. */
struct SplatCommons
{
  double Origin[3] = { 0, 0, 0 }; ///< the middle of their places
  double LongestEdge = 0;         ///< of their cells
  vtkIdType MostSamples = 0;      ///< that one rank has
  double MaximumSpeed = 0;        ///< at which vectors are fully drawn; 0 without vectors
  double MeanCell = 1;            ///< length of a sample's cell along its vector
};

/** The speeds of all ranks. Collective. */
SpeedCounts SpeedsOfRanks(const SpeedCounts& mine);

/**
 * From vertices with the array of shapes that SplatVertices makes; `vectors`: name of a cell array,
 * or empty. Collective.
 */
SplatCommons FindSplatCommons(vtkDataSet* vertices, const std::string& vectors);

/**
 * The regions of ranks whose boxes, as the view has them, fill a box: grown to infinity where that
 * ends. Empty if they overlap or leave gaps.
 */
std::vector<SplatRegion> RegionsOfRanks(const std::vector<vtkBoundingBox>& boxes);

/** How far splats reach, in cells and units of the data. */
struct SplatReaches
{
  double KernelRadius = 1; ///< cells
  double RadiusFactor = 1; ///< on cells
  bool Vectors = false;
  VectorLook Look;
};

/**
 * This rank's vertices, and after them, marked as duplicates, those of other ranks that reach into
 * its region: SplatRegion.h says why.
 * Collective.
 */
vtkSmartPointer<vtkDataSet> WithNeighbors(
  vtkDataSet* vertices, const std::vector<SplatRegion>& regions, const SplatReaches& reaches);

} // namespace nephoscope

#endif
