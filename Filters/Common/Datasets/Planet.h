// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground below data: a planet, or flat.
#ifndef nephoscope_Planet_h
#define nephoscope_Planet_h

#include "Vector3.h"

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include <array>

class vtkDataSet;

namespace nephoscope
{
struct VTKNEPHOSCOPEFILTERSCOMMON_EXPORT Planet
{
  double Radius = 0;         // 0: flat ground
  Vector3 Up{ { 0, 0, 1 } }; // from flat ground, of length 1

  // The unit vector upwards at a place: on a globe away from the centre.
  Vector3 UpAt(const Vector3& place) const;

  // East, north and up of flat ground: x, y and z, turned the shortest way until z points up.
  std::array<Vector3, 3> Horizon() const;
  Vector3 FromHorizon(const Vector3& coordinates) const;
};

// That of vtkGlobeGrid, or flat ground.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT Planet FindPlanet(
  vtkDataSet* data, const Vector3& up = { { 0, 0, 1 } });

// The planet's radius, if the data are on a map of vtkGlobeGrid, x and y of which are the radius
// times longitude and latitude; 0 elsewhere.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT double RadiusOfMap(vtkDataSet* data);
}

#endif
