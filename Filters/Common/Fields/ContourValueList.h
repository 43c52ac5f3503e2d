// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour values that are all initialized: vtkContourValues leaves values that were not set
// uninitialized.
#ifndef nephoscope_ContourValueList_h
#define nephoscope_ContourValueList_h

#include "vtkContourValues.h"

#include <algorithm>

namespace nephoscope
{

/** New values are 0. */
inline void SetNumberOfContours(vtkContourValues* values, int number)
{
  const int before = values->GetNumberOfContours();
  values->SetNumberOfContours(number);
  for (int i = before; i < number; ++i)
  {
    values->SetValue(i, 0.0);
  }
}

/** Values between the last one and this one are 0. */
inline void SetContourValue(vtkContourValues* values, int i, double value)
{
  SetNumberOfContours(values, std::max(values->GetNumberOfContours(), i + 1));
  values->SetValue(i, value);
}

}

#endif
