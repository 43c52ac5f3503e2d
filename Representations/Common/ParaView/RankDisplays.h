// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Ranks that cannot draw, because they have no display. */
#ifndef nephoscope_RankDisplays_h
#define nephoscope_RankDisplays_h

#include <string>

namespace nephoscope
{

/**
 * Why ranks will wait for one another for ever: some can draw and others cannot. Empty where all
 * can, or none; and from the second call on. Collective.
 */
std::string WhyRanksWait();

} // namespace nephoscope

#endif
