// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The position and density of haze: its settings and, where these are automatic, values from the
 * scene.
 *
 *     data of vtkGlobeGrid       its ground and exaggeration, a scale height of 8000 m
 *     the size of the Earth      about the origin, in m or km: a globe; its surface may be
 *                                coarse, so a scale height of 0.5 % of the radius
 *     anything else              flat ground under the scene, a scale height of a third of its
 *                                height, at least a tenth of its width
 *
 * The visibility left open is 24.5 displayed scale heights: straight down, 15 % of the light is the
 * air's, and 196 km are those of a clear day.
 * Over flat ground under the scene it is at least 5.7 widths of the scene, so that a thin scene is
 * visible from the side.
 */
#ifndef nephoscope_HazePlacement_h
#define nephoscope_HazePlacement_h

#include "HazeScene.h"

#include <string>

class vtkHaze;

namespace nephoscope
{

struct HazePlacement
{
  bool Exists = false; ///< false: an empty scene, of which the haze left something open
  bool OnGlobe = true;
  double Radius = 6371000;   ///< of the globe
  double BaseLevel = 0;      ///< of flat ground
  bool MovesDown = false;    ///< with an eye under flat ground that was found from the bounds
  double ScaleHeight = 8000; ///< as displayed
  double Extinction = 0;
  std::string Problem; ///< empty, or why nothing can be seen, and what to set

  HazePlacement() = default;
  HazePlacement(vtkHaze* haze, const HazeScene& scene);
};

} // namespace nephoscope

#endif
