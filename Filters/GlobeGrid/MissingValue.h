// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_MissingValue_h
#define nephoscope_MissingValue_h

#include <cmath>

namespace nephoscope
{
// Not a number, or a fill value that the reader has left in place (netCDF's own is 9.97e36, others
// use 1e20 or -9.99e33); no field of the weather comes near.
inline bool IsMissing(double value)
{
  return !(std::abs(value) < 1e15);
}
}

#endif
