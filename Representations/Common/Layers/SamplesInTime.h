// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws with fewer samples of the image while the camera moves: as many as the window's
 * DesiredUpdateRate leaves time for.
 */
#ifndef nephoscope_SamplesInTime_h
#define nephoscope_SamplesInTime_h

#include "SampleDistance.h"
#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <functional>

class vtkRenderWindow;

namespace nephoscope
{

/** As in vtkFixedPointVolumeRayCastMapper; distances in pixels. */
struct SampleSettings
{
  bool AutoAdjust = true;
  double Distance = 1; ///< without AutoAdjust
  double Maximum = 8;  ///< with it
};

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT SamplesInTime
{
public:
  /**
   * Calls `draw` with the distance of the samples, waits for OpenGL and returns the seconds that
   * this took. What the window has yet to draw before counts too: OpenGL draws in order.
   */
  double Draw(vtkRenderWindow* window, const SampleSettings& settings,
    const std::function<void(double)>& draw);
  /** In the last picture. */
  double GetDistance() const { return this->LastDistance; }

private:
  SampleDistance Distance;
  double LastDistance = 1;
};

} // namespace nephoscope

#endif
