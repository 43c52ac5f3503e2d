// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The points that pieces of a mesh on several ranks have in common. */
#ifndef nephoscope_RankPlaces_h
#define nephoscope_RankPlaces_h

#include "Vector3.h"

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro

#include <cstddef>
#include <vector>

namespace nephoscope
{

/**
 * A place that another rank has too: its number among the places of this rank, and the place,
 * rounded, as both have it.
 */
struct SharedPlace
{
  std::size_t Index;
  int Rank;
  Vector3 Rounded;
};

/**
 * All of this rank's places that other ranks have, once for each of them, to the rounding of
 * double: pieces of a grid share the points of their borders. Only places inside the bounds of
 * another rank are exchanged. Collective.
 */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT std::vector<SharedPlace> PlacesOfSeveralRanks(
  const std::vector<Vector3>& places);

} // namespace nephoscope

#endif
