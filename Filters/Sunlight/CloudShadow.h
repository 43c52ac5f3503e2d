// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The shadow of other data, which have light already. */
#ifndef nephoscope_CloudShadow_h
#define nephoscope_CloudShadow_h

#include <array>
#include <vector>

class vtkDataSet;

namespace nephoscope
{
/** The share of direct sunlight that clouds let through to each place; 1 outside of them. Empty if they have no array SunTransmittance. */
std::vector<float> cloudShadow(
  vtkDataSet* clouds, const std::vector<std::array<double, 3>>& places);
}

#endif
