// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How many rays are drawn while the camera moves.
#include "OpenGLFunctions.h"

#include "vtkCellCompositingMapper.h"

#include "CellCompositingInternals.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTimerLog.h"

double vtkCellCompositingMapper::GetLastImageSampleDistance()
{
  const vtkInternals& self = *this->Internals;
  return this->UsesRays() && !self.Peeled ? self.Options.ImageSampleDistance : 1.0;
}

// With as many rays as there is time for. What the window has yet to draw before counts too: OpenGL draws in order.
void vtkCellCompositingMapper::DrawInTime(
  vtkOpenGLRenderWindow* window, const std::vector<vtkMedium>& media)
{
  if (media.empty())
  {
    return;
  }
  vtkInternals& self = *this->Internals;
  const double distance = this->AutoAdjustSampleDistances
    ? self.Distance.Choose(1.0 / window->GetDesiredUpdateRate(), this->MaximumImageSampleDistance)
    : this->ImageSampleDistance;
  for (const vtkMedium& medium : media)
  {
    medium.Mapper->Internals->Options.ImageSampleDistance = distance;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->DrawMedia(window, media);
  glFinish();
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  if (!self.Peeled)
  {
    self.Distance.Measure(this->TimeToDraw, distance);
  }
}
