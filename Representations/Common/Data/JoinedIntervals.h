// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Fewer intervals for a piecewise-linear function with many.
 *
 * From the first interval on, each is joined to those before it as long as one straight line per
 * channel passes all their ends within the tolerance (O'Rourke 1981, an on-line algorithm for
 * fitting straight lines between data ranges). This gives the fewest possible intervals, in a time
 * proportional to their number. Lines need not pass through the values at the nodes, so that values
 * rounded to 8 bits can be joined too; where two lines meet they differ by at most twice the
 * tolerance. Between nodes the error is no larger than at them. An interval that is joined to none
 * keeps its values.
 */
#ifndef nephoscope_JoinedIntervals_h
#define nephoscope_JoinedIntervals_h

#include "TransferFunctionTable.h"

#include <vector>

namespace nephoscope
{

/**
 * `colorTolerance` is absolute. `opacityTolerance` is a fraction of the opacity itself: where it is
 * 0 it remains 0. The nodes ascend; the intervals are one more than the nodes, of which the first
 * and the last, outside the nodes, do not change.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT void JoinIntervals(std::vector<double>& nodes,
  std::vector<TransferFunctionTable::Interval>& intervals, double colorTolerance,
  double opacityTolerance);

} // namespace nephoscope

#endif
