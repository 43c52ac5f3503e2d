// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Discrete ordinates by short characteristics (KunaszAuer1988): the diffuse light that a given
 * source function makes, direction by direction.
 *
 *     S(d) = albedo / (4 pi) (fluence + 3 g d . flux + 5 h (P2(z) moment + 3 z (x, y) . tilt) + P(d
 *     . s) T)
 *
 * d = (x, y, z). g and h are the first Legendre coefficients of P, whose mean over the directions
 * is made 1. The integrals of x^2 - y^2 and x y are left out: they change no column of the test
 * clouds by more than 1 %. T: the sun's beam. Plain C++17.
 */
#ifndef nephoscope_DirectionSweep_h
#define nephoscope_DirectionSweep_h

#include "DirectionSet.h"
#include "LightBalance.h"
#include "LightGrid.h"

#include <array>
#include <vector>

namespace nephoscope
{
class DirectionSweep
{
public:
  /**
   * `beam`: mean transmittance of the sun's beam around each point. Directions of the same zenith
   * angle are next to one another.
   */
  DirectionSweep(const LightGrid& grid, const std::vector<float>& beam,
    const std::vector<Direction>& directions, const Parallel& parallel);

  /** The light emitted by the sources of `known`. */
  void Run(const DiffuseField& known, DiffuseField& found);

private:
  struct Cone;
  void MakeBeams(const std::vector<float>& transmittance);
  std::vector<float> GroundLight(const DiffuseField& known) const;
  void RunCone(Cone& cone, const DiffuseField& known, const std::vector<float>& ground);
  void Emit(Cone& cone, const DiffuseField& known, int level) const;
  float Outside(float z, std::size_t column) const;
  void SweepPlane(Cone& cone, std::size_t direction, int level, class RowSweep& sweep);
  void SweepRow(Cone& cone, std::size_t direction, int level, int row, int beside, RowSweep& sweep);

  const LightGrid& Grid;
  const std::vector<Direction>& Directions;
  const Parallel& Rows;
  std::vector<std::vector<float>>
    Beams; ///< what the beam scatters into each direction, times 4 pi / albedo / extinction
  std::array<std::vector<std::vector<float>>, 2>
    Seams; ///< radiance where the grid closes along an axis, of the last run
  std::array<std::vector<float>, 3> Rates; ///< 1 / Step
  std::vector<float> NoRates;
};
}

#endif
