// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The light that a display should show as white: an exposure for clouds as they are.
#ifndef nephoscope_WhiteLight_h
#define nephoscope_WhiteLight_h

#include <array>

class vtkDataSet;

namespace nephoscope
{
/**
 * Adds the field array WhiteLight to data that have Sunlight and ScaledExtinction: 1.1 times the
 * light that 2 % of the points in clouds exceed, but at least 0.15, so that night stays dark, and
 * at most 1.2; 0.6 without clouds. Light that depends on the direction of view is that towards
 * cameras with the sun behind them, in the mean over all such directions. `sun`: towards it.
 */
void AddWhiteLight(vtkDataSet* data, const std::array<double, 3>& sun);
}

#endif
