// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Discrete ordinates by short characteristics (KunaszAuer1988): the diffuse light that a given source function makes, direction by direction.
 *
 *     S(d) = albedo / (4 pi) (fluence + 3 g d . flux + P(d . s) T)
 *
 * P: Henyey-Greenstein, whose mean over the directions is made 1. T: the sun's beam. Plain C++17.
 */
#ifndef nephoscope_DirectionSweep_h
#define nephoscope_DirectionSweep_h

#include "DirectionSet.h"
#include "LightBalance.h"
#include "LightGrid.h"

#include <vector>

namespace nephoscope
{
class DirectionSweep
{
public:
  /** `beam`: mean transmittance of the sun's beam around each point. */
  DirectionSweep(const LightGrid& grid, const std::vector<float>& beam,
    const std::vector<Direction>& directions, const Parallel& parallel);

  /** The light emitted by the sources of `known`. */
  void Run(const DiffuseField& known, DiffuseField& found);

private:
  struct Sums;
  struct OneDirection;
  void MakeBeams(const std::vector<float>& transmittance);
  std::vector<float> GroundLight(const DiffuseField& known) const;

  const LightGrid& Grid;
  const std::vector<Direction>& Directions;
  const Parallel& Rows;
  std::vector<std::vector<float>>
    Beams; ///< what the beam scatters into each direction, times 4 pi / albedo / extinction
  std::vector<std::vector<float>> Seams; ///< radiance where the grid closes, of the last run
  std::vector<Vector> Rate;              ///< 1 / Step
};
}

#endif
