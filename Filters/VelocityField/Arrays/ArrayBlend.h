// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays between two times.
#ifndef nephoscope_ArrayBlend_h
#define nephoscope_ArrayBlend_h

#include "vtkNephoscopeFiltersVelocityFieldModule.h" // for export macro

class vtkDataSetAttributes;

namespace nephoscope
{
// Turns the arrays of `second` into (1 - weight) first + weight second. Integers are those of the
// nearer time; an array that only one of the two has is left as it is, or left out.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT void BlendArrays(
  vtkDataSetAttributes* first, double weight, vtkDataSetAttributes* second);
}

#endif
