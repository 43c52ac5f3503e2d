// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The array that a host adds to data without a coloured array, so that they are drawn as a uniform
 * medium.
 */
#ifndef nephoscope_UniformMedium_h
#define nephoscope_UniformMedium_h

namespace nephoscope
{
constexpr const char* uniformMediumName = "NephoscopeUniform";
}

#endif
