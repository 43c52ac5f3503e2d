// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The regions of space in which ranks draw, one each, where a view divides the data among them. */
#ifndef nephoscope_RankRegions_h
#define nephoscope_RankRegions_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro

#include <array>
#include <limits>
#include <vector>

class vtkBoundingBox;
class vtkView;

namespace nephoscope
{

/** Bounds as in VTK; infinite where no other rank is next to it. */
using RankRegion = std::array<double, 6>;

constexpr double noBorder = std::numeric_limits<double>::infinity();
constexpr RankRegion wholeSpace{ { -noBorder, noBorder, -noBorder, noBorder, -noBorder,
  noBorder } };

/** That of this rank; all space where the view has not divided the data. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT RankRegion RegionOfRank(vtkView* view);

/**
 * False where the view has divided the data and none of it is this rank's: there are fewer parts
 * than ranks.
 */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT bool HasRegion(vtkView* view);

/** The boxes of all ranks, by their numbers; null where the view has not divided the data. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT const std::vector<vtkBoundingBox>* BoxesOfRanks(vtkView* view);

} // namespace nephoscope

#endif
