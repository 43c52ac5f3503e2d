// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The range of the default point arrays of all data: of the pieces of all ranks, where each rank
// computes one.
#ifndef nephoscope_DefaultRange_h
#define nephoscope_DefaultRange_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include <array>

class vtkAlgorithm;
class vtkMultiProcessController;

namespace nephoscope
{
// For the input of a filter that is about to execute; the first value is above the last if there is
// none. All ranks call it that compute pieces.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT std::array<double, 2> RangeOfAllPieces(vtkAlgorithm* filter);

// The ranks that compute one piece each for a filter that is about to execute. Null if this process
// computes alone and must not wait for others.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkMultiProcessController* RanksOfPieces(vtkAlgorithm* filter);

// Whether it is true of any of the ranks that compute pieces, all of which call it.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT bool IsTrueOfAnyPiece(vtkAlgorithm* filter, bool mine);
}

#endif
