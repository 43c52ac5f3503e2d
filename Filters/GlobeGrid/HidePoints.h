// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_HidePoints_h
#define nephoscope_HidePoints_h

#include <vector>

class vtkStructuredGrid;

namespace nephoscope
{
// Adds HIDDENPOINT to the points whose flag is not 0, and HIDDENCELL to the cells that touch them:
// some filters look at the one, some at the other. Without such a point no array is made.
void HidePoints(const std::vector<unsigned char>& flags, vtkStructuredGrid* output);
}

#endif
