// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The volume that splats represent, and how a scalar fills it. */
#ifndef nephoscope_SplatMeasures_h
#define nephoscope_SplatMeasures_h

#include "MediumMeasures.h"
#include "RobustBounds.h"
#include "SplatShapes.h"

namespace nephoscope
{

/**
 * Bounds of the cells that the visible samples of all processes stand for, without parts that are
 * few and far away. `data`, the piece of this one, may be null.
 */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT MediumBounds BoundsOfSamples(
  vtkDataSet* data, const SplatSampling& sampling, const MediumReduction& over = {});

/**
 * Measures a piece, which may be null, whose samples are points or cells, as far as it lies in the
 * bounds of all pieces. `scalars` may be null, vectors count by their magnitude; `opacity` may be
 * empty. Scalars above `clamp`, if that is above 0, count as `clamp`. Integrals come from about 1e5
 * samples.
 */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT MediumMeasures MeasureSplats(vtkDataSet* data,
  const SplatSampling& sampling, vtkDataArray* scalars,
  const std::function<double(double)>& opacity, const MediumBounds& common, double clamp = 0.0);

/** The opacity of vectors, and the fraction of the samples whose vectors are drawn. */
struct SuitedVectors
{
  double Opacity = 2.0;
  double Share = 1.0;
};

/**
 * Such that streaks and the medium can both be seen, from the measures of the vectors: streaks of
 * the mean speed get an optical depth of 0.6, the fastest at least 0.8 and at most 2. A ray meets
 * as many streaks as of 7 samples with the greatest speed, at most, and there are at most 6000 in a
 * sheet, up to 7 times as many in deep data. `greatestSpeed`
 * 0: that of the measures; `count`: of vectors that are not 0.
 */
VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT SuitedVectors SuitVectorsTo(
  const MediumMeasures& vectors, const MediumBounds& common, double greatestSpeed, double count);

} // namespace nephoscope

#endif
