// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DiffuseLight.h"

#include "DirectionSweep.h"

#include <cmath>

namespace nephoscope
{
namespace
{
double MeanChange(const std::vector<float>& a, const std::vector<float>& b)
{
  double change = 0, whole = 1e-30;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    change += std::abs(a[i] - b[i]);
    whole += std::abs(b[i]);
  }
  return change / whole;
}
}

DiffuseLight FindDiffuseLight(const LightGrid& grid, const LightSettings& settings,
  const Parallel& parallel, const std::function<bool(double)>& progress)
{
  DiffuseLight light;
  const BeamDeposit deposit = FindBeamDeposit(grid, parallel);
  LightBalance balance(grid, deposit, parallel);
  balance.Solve(nullptr, light.Field, 1e-2);
  const std::vector<Direction> directions = DirectionSet(AnglesFor(settings.Angles, grid.Points()));
  DirectionSweep sweep(grid, deposit.Beam, directions, parallel);
  DiffuseField ordinates;
  do
  {
    sweep.Run(light.Field, ordinates);
    const std::vector<float> before = light.Field.Fluence;
    balance.Solve(&ordinates, light.Field, 1e-2);
    light.Change = MeanChange(before, light.Field.Fluence);
    ++light.Iterations;
  } while (progress(double(light.Iterations) / settings.MostIterations) &&
    light.Change > settings.Tolerance && light.Iterations < settings.MostIterations);
  balance.Finish(light.Field);
  light.Absorption = balance.Absorption();
  return light;
}
}
