// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Measures of a medium, and ranges of arrays, of all ranks together. All are collective. */
#ifndef nephoscope_RankMeasures_h
#define nephoscope_RankMeasures_h

#include "MediumMeasures.h"
#include "RobustBounds.h"

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro

namespace nephoscope
{

VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT MediumBounds ReduceOverRanks(const MediumBounds& mine);

/** For robust bounds of the medium of all ranks. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT MediumReduction ReductionOverRanks();

/** Integrals, range and reach are of all; the bounds stay those of this rank. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT MediumMeasures ReduceOverRanks(const MediumMeasures& mine);

/** Replaces a range, empty where its lower end exceeds the upper one, by that of all ranks. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT void ReduceRange(double range[2]);

} // namespace nephoscope

#endif
