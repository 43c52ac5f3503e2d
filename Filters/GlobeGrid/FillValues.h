// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Values such as -999 that stand for missing ones, and that a reader has left in place.
#ifndef nephoscope_FillValues_h
#define nephoscope_FillValues_h

#include <string>

class vtkDataSet;

namespace nephoscope
{
/**
 * Which arrays of one component hold a usual fill value that is far from all their other values,
 * how often, and what to do; an empty text if none does. Larger fill values count as missing
 * without a word (MissingValue.h).
 */
std::string DescribeFillValues(vtkDataSet* data);
}

#endif
