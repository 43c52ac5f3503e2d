// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of an array of light: a preset in its unit, up to the light that is white.
#ifndef nephoscope_ColorsOfLight_h
#define nephoscope_ColorsOfLight_h

#include <string>

class vtkPVDataInformation;
class vtkSMProxy;
class vtkSMSourceProxy;

namespace nephoscope
{
/**
 * The light that is drawn white: WhiteLight of vtkSunlight; for smoke 0.7 times its greatest light,
 * at most 0.6. 0: the range of the colours does not change. Thin smoke sends less light than
 * clouds: in their colours it would be grey.
 */
double LightThatIsWhite(vtkPVDataInformation* data, const std::string& array);

/** A preset in its unit, which data do not change; with a range up to `white`, unless that is 0. */
void ApplyFixedPreset(vtkSMProxy* colors, const char* preset, double white);

/**
 * Follow Camera changes what is white. As long as the colours have the range that they have now,
 * they get that of the light after each change.
 */
void FollowEyeOfLight(
  vtkSMSourceProxy* source, int port, vtkSMProxy* colors, const std::string& array);
}

#endif
