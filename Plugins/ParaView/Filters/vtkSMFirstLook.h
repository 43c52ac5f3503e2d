// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMFirstLook
 * @brief how data of the plugin's sources and filters look when they are first shown
 *
 * ParaView gives structured data a solid colour at first, whatever representation the hints of
 * their source request; supports presets of colours by array name, but not of opacities; and resets
 * the camera only for the first data in a view. Load, which the plugin calls once, listens for
 * registered proxies:
 * - displays of sources with the hint NephoscopeFirstLook get the colours that it asks for with
 *   `color`: "clouds", the first array whose preset is one of clouds, else the active scalars;
 *   "solid", none; "surface", none if the array is the contoured one; else the cell array of that
 *   name;
 * - displays without an array get the active scalars when their representation becomes Cell
 *   Compositing or Textured Splats, as Volume does;
 * - contours whose representation becomes Cloud Texture are white, unless somebody has chosen the
 *   array that colours them;
 * - opacity functions of arrays that begin with the colours of a preset of this project get its
 *   opacities too;
 * - if such a display is added to a view whose camera suits other data, at another position or
 *   scale, the camera is reset to it;
 * - if it is alone in a view and shows a globe, and the camera looks at the pole, as ParaView's
 *   first camera does, the camera is turned to the side;
 * - numbers outside the range of a property of this project are kept in it, with a warning.
 * - a Sun becomes the input of the Sunlight filters that have none (SunConnection.h);
 * - in every render view the polygon of Flow Volume is drawn instead of the widget's cylinder.
 * Displays that are made by an Apply that fails get these looks when their source first has data.
 * Nothing changes while a state is loaded, and settings that the user has made or saved are kept.
 */
#ifndef vtkSMFirstLook_h
#define vtkSMFirstLook_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkObject.h"

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkSMFirstLook : public vtkObject
{
public:
  static vtkSMFirstLook* New();
  vtkTypeMacro(vtkSMFirstLook, vtkObject);

  static void Load();

protected:
  vtkSMFirstLook() = default;
  ~vtkSMFirstLook() override = default;

private:
  vtkSMFirstLook(const vtkSMFirstLook&) = delete;
  void operator=(const vtkSMFirstLook&) = delete;
};

#endif
