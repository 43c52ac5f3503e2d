// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A splat in the shape of its grid cell: the kernel as a function of |J^-1 (x - centre)|, where the
// columns of J are the cell's edges. What a ray meets of it is exact, for parallel and for
// perspective rays. Plain C++17.
#ifndef nephoscope_EllipsoidSplat_h
#define nephoscope_EllipsoidSplat_h

#include "SplatMatrix.h"

#include <algorithm>

namespace nephoscope
{
// How far the ball of one cell reaches along a vector, which must not be 0.
inline double ReachAlong(const SplatMatrix& jacobian, const Vector3& vector)
{
  double sum = 0.0;
  for (const Vector3& edge : jacobian)
  {
    sum += Dot(edge, vector) * Dot(edge, vector);
  }
  return std::sqrt(sum) / Norm(vector);
}

// Columns shorter than `thinnest` of the longest are lengthened to it, for the precision of
// shaders. Those of cells that degenerate (at a pole, or of a flat grid), a hundredth of that or
// less, become `share` of the longest, so that such cells are seen; a column of no length gets a
// direction at right angles to the others.
inline SplatMatrix WithoutFlatColumns(SplatMatrix jacobian, double share, double thinnest)
{
  double lengths[3], longest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    lengths[c] = Norm(jacobian[c]);
    longest = std::max(longest, lengths[c]);
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (lengths[c] >= thinnest * longest || longest == 0.0)
    {
      continue;
    }
    const double target = (lengths[c] > 0.01 * thinnest * longest ? thinnest : share) * longest;
    Vector3 direction = jacobian[c];
    if (lengths[c] == 0.0)
    {
      direction = Cross(jacobian[(c + 1) % 3], jacobian[(c + 2) % 3]);
    }
    const double length = Norm(direction);
    for (std::size_t i = 0; i < 3; ++i)
    {
      jacobian[c][i] = length > 0.0 ? target * direction[i] / length : (i == c ? target : 0.0);
    }
  }
  return jacobian;
}
}

#endif
