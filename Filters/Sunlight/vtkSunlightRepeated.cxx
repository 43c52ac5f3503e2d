// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds that repeat beyond the sides of a grid.
#include "vtkSunlight.h"

#include "RepeatedGrid.h"
#include "vtkSunlightInternals.h"

#include "vtkDataSet.h"

bool vtkSunlight::LightRepeated(vtkDataSet* data, Work& work)
{
  const nephoscope::RepeatedGrid repeated(
    data, work.Planet, work.Places, work.Extinction, this->OnCells);
  if (!repeated.Exists())
  {
    vtkWarningMacro(
      << "PeriodicSides needs an image, a rectilinear or a structured grid of "
         "three dimensions that is not on a globe. The light is that of the data alone. "
         "Turn PeriodicSides off, or make an image by Resample To Image.");
    return this->Light(data, work);
  }
  Work whole;
  whole.Planet = work.Planet;
  whole.Sun = work.Sun;
  whole.Repeats = true;
  whole.Places = nephoscope::placesOf(repeated.GetGrid());
  whole.Extinction = repeated.Of(work.Extinction);
  whole.Scaled = repeated.Of(work.Scaled);
  whole.Albedo = repeated.Of(work.Albedo);
  whole.Asymmetry = repeated.Of(work.Asymmetry);
  if (!this->Light(repeated.GetGrid(), whole))
  {
    return false;
  }
  const auto take = [&](const auto& from, auto& to) {
    to.resize(from.empty() ? 0 : work.Places.size());
    for (std::size_t p = 0; p < to.size(); ++p)
    {
      to[p] = from[repeated.NumberOf(p)];
    }
  };
  take(whole.Extinction, work.Extinction);
  take(whole.Scaled, work.Scaled);
  take(whole.Albedo, work.Albedo);
  take(whole.Asymmetry, work.Asymmetry);
  take(whole.Transmittance, work.Transmittance);
  take(whole.ScaledDepth, work.ScaledDepth);
  take(whole.Shadow, work.Shadow);
  take(whole.BelowClouds, work.BelowClouds);
  take(whole.Fluence, work.Fluence);
  take(whole.Up, work.Up);
  take(whole.Down, work.Down);
  take(whole.Absorbed, work.Absorbed);
  take(whole.Flux, work.Flux);
  return true;
}
