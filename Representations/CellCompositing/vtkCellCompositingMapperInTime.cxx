// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How many rays are drawn while the camera moves.
#include "vtkCellCompositingMapper.h"

#include "CellCompositingInternals.h"

#include "vtkOpenGLRenderWindow.h"

double vtkCellCompositingMapper::GetLastImageSampleDistance()
{
  const vtkInternals& self = *this->Internals;
  return this->UsesRays() && !self.Peeled ? self.Options.ImageSampleDistance : 1.0;
}

void vtkCellCompositingMapper::DrawInTime(
  vtkOpenGLRenderWindow* window, const std::vector<vtkMedium>& media)
{
  if (media.empty() || this->Internals->Peeled)
  {
    this->DrawMedia(window, media);
    return;
  }
  const auto draw = [&](double distance) {
    for (const vtkMedium& medium : media)
    {
      medium.Mapper->Internals->Options.ImageSampleDistance = distance;
    }
    this->DrawMedia(window, media);
  };
  const nephoscope::SampleSettings settings = { this->AutoAdjustSampleDistances,
    this->ImageSampleDistance, this->MaximumImageSampleDistance };
  this->TimeToDraw = this->Internals->Samples.Draw(window, settings, draw);
}
