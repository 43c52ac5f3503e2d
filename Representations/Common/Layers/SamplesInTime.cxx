// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "SamplesInTime.h"

#include "vtkRenderWindow.h"
#include "vtkTimerLog.h"

namespace nephoscope
{

double SamplesInTime::Draw(
  vtkRenderWindow* window, const SampleSettings& settings, const std::function<void(double)>& draw)
{
  this->LastDistance = settings.AutoAdjust
    ? this->Distance.Choose(1.0 / window->GetDesiredUpdateRate(), settings.Maximum)
    : settings.Distance;
  const double start = vtkTimerLog::GetUniversalTime();
  draw(this->LastDistance);
  glFinish();
  const double seconds = vtkTimerLog::GetUniversalTime() - start;
  this->Distance.Measure(seconds, this->LastDistance);
  return seconds;
}

} // namespace nephoscope
