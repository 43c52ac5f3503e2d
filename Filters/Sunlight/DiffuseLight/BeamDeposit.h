// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The light that the sun's beam loses in the layers between points above one another: the
 * difference of what enters and leaves, not a sample of it. Plain C++17.
 */
#ifndef nephoscope_BeamDeposit_h
#define nephoscope_BeamDeposit_h

#include "LightGrid.h"

#include <cstddef>
#include <vector>

namespace nephoscope
{
struct BeamDeposit
{
  std::vector<float> InLayer; ///< power that goes out of the beam between a point and the one
                              ///< above, in the area that they share
  std::vector<float>
    Beam; ///< its mean transmittance in the box around a point, by what it loses there
};
BeamDeposit FindBeamDeposit(const LightGrid& grid, const Parallel& parallel);

/** The mean of a beam between two optical depths, exponential between them. */
double MeanBeam(double from, double to);
}

#endif
