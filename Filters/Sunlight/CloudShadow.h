// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Direct sunlight that other data let through. */
#ifndef nephoscope_CloudShadow_h
#define nephoscope_CloudShadow_h

#include "SunFrame.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{
/**
 * The fraction of sunlight that reaches the places through clouds with the array SunTransmittance: inside their mesh that array, below it the array where
 * the ray towards the sun, of length 1, enters the mesh; 1 elsewhere. Empty: the clouds have no such array.
 */
std::vector<float> cloudShadow(
  vtkDataSet* clouds, const std::vector<Place>& places, const Place& towardsSun);
}

#endif
