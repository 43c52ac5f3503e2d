// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds that repeat beyond the sides of a grid.
#include "vtkSunlight.h"

#include "RepeatedGrid.h"
#include "vtkSunlightInternals.h"

#include "vtkDataSet.h"

#include <utility>

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
  if (this->OpenSides)
  {
    vtkWarningMacro(
      << "PeriodicSides and OpenSides are both on: the clouds repeat, and no side is open. "
         "Turn one of them off.");
  }
  Work whole;
  whole.Planet = work.Planet;
  whole.Sun = work.Sun;
  whole.Repeats = true;
  whole.Taken = work.Taken;
  whole.Places = nephoscope::PlacesOf(repeated.GetGrid());
  whole.Extinction = repeated.Of(work.Extinction);
  whole.Scaled = repeated.Of(work.Scaled);
  whole.Albedo = repeated.Of(work.Albedo);
  whole.Asymmetry = repeated.Of(work.Asymmetry);
  if (!this->Light(repeated.GetGrid(), whole))
  {
    return false;
  }
  Work light = whole.At(repeated.GetNumbers());
  light.Places = std::move(work.Places);
  work = std::move(light);
  return true;
}
