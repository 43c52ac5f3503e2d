// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Which rank draws a sample that several have. */
#ifndef SplatOwners_h
#define SplatOwners_h

#include "SplatMatrix.h"

#include <vector>

namespace nephoscope
{

/**
 * For each of this rank's places, whether no lower rank has a sample at exactly the same one: pieces of a grid share the points of
 * their borders. Only places inside the bounds of another rank are exchanged. Collective.
 */
std::vector<bool> ownedByThisRank(const std::vector<SplatVector>& places);

} // namespace nephoscope

#endif
