// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Speeds and lengths of the vectors of a dataset's samples, and how far what is drawn of them
 * reaches, without making a list of them.
 */
#ifndef nephoscope_SplatVectorBounds_h
#define nephoscope_SplatVectorBounds_h

#include "SplatReach.h"
#include "SplatShapes.h"
#include "SplatSpeeds.h"

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

/** Sums over visible samples whose vectors are finite and not 0. */
struct VectorSums
{
  SpeedCounts Speeds;
  double Cells = 0; ///< sum of the lengths of cells along their vectors
  double Count = 0;

  double MeanCell() const
  {
    return this->Count > 0 && this->Cells > 0 ? this->Cells / this->Count : 1.0;
  }
};

/** `vectors` may be null, or of other than three components: none. */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT VectorSums SumVectors(
  const SplatShapes& shapes, vtkDataArray* vectors);

/** The speeds alone, in less time. `data` and `vectors` may be null. */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT SpeedCounts CountSpeeds(
  vtkDataSet* data, const SplatSampling& sampling, vtkDataArray* vectors);

/**
 * Extends the bounds of splats to those of their streaks, or of their segments; all of these as if
 * they were of the greatest speed.
 */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT void AddVectorBounds(const SplatShapes& shapes,
  vtkDataArray* vectors, const VectorLook& look, double kernelRadius, double bounds[6]);

} // namespace nephoscope

#endif
