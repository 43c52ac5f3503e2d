// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The sun of a renderer, which haze without a sun of its own takes; and what the data of a scene
// tell in their field data.
#ifndef nephoscope_RendererSun_h
#define nephoscope_RendererSun_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

class vtkRenderer;

namespace nephoscope
{
/** Three components, towards the sun, in coordinates of the scene; null: no sun. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT void SetSunOf(
  vtkRenderer* renderer, const double* towardsSun);
/** False: it has none. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT bool FindSunOf(
  vtkRenderer* renderer, double towardsSun[3]);

/**
 * The greatest first number of field arrays of this name in the data that are visible, and their
 * blocks; `otherwise`, if that is greater or there is none.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double GreatestFieldValue(
  vtkRenderer* renderer, const char* name, double otherwise);

/**
 * Whether volumes of these mappers are visible, and the data of none of them have this array, at
 * points or cells.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT bool HasVolumesWithout(
  vtkRenderer* renderer, const char* array);
}

#endif
