// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** How much space splats stand for, and how a scalar fills it: what the automatic unit distance is made of. */
#ifndef SplatMeasures_h
#define SplatMeasures_h

#include "CellMeasures.h"
#include "SplatShapes.h"

namespace nephoscope
{

/**
 * Of a piece whose samples are points or cells; `scalars` may be null, vectors count by their magnitude. Integrals come from about 1e5
 * evenly chosen samples.
 */
CellMeasures measureSplats(vtkDataSet* data, vtkDataArray* scalars, const SplatSampling& sampling);

} // namespace nephoscope

#endif
