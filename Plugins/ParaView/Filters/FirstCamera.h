// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Data that come into a view whose camera suits other data: a globe in metres where longitudes and
// latitudes were shown in degrees, for one.
#ifndef nephoscope_FirstCamera_h
#define nephoscope_FirstCamera_h

class vtkSMProxy;

namespace nephoscope
{
/**
 * Call it for a new display. Where that comes into a view whose camera suits data shown there, but
 * would see nothing of the new ones, or them as a dot, the camera is reset to the new data when the
 * view is next updated, unless it has been moved by then. Data that are shown alone must fill more
 * of the picture than a dot does. As long as the camera has its initial direction, a globe that is
 * shown alone is seen from above middle latitudes instead of the pole, and a region of it from
 * straight above.
 */
void ResetCameraWhereShown(vtkSMProxy* display);
}

#endif
