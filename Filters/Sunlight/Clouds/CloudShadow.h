// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Light that other data let through. */
#ifndef nephoscope_CloudShadow_h
#define nephoscope_CloudShadow_h

#include "SunFrame.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{
/** What clouds leave of the light, at each of some places. */
struct CloudShadow
{
  std::vector<float> Fraction;   ///< of sunlight; empty: the clouds have no array SunTransmittance
  std::vector<float> Irradiance; ///< by sun and diffuse light; negative: not known, as beside the
                                 ///< clouds. Empty: they have no diffuse light
};

/**
 * Inside the mesh of lit clouds their light is that of its arrays; below it that where the ray
 * towards the sun, of length 1, enters the mesh. Elsewhere all sunlight arrives.
 */
CloudShadow FindCloudShadow(
  vtkDataSet* clouds, const std::vector<Place>& places, const Place& towardsSun);
}

#endif
