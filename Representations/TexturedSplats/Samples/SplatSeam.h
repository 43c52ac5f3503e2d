// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a structured grid comes back to where it began along an axis, as a globe does: its last
// column of points is then its first once more, to be drawn once. Plain C++17.
#ifndef nephoscope_SplatSeam_h
#define nephoscope_SplatSeam_h

#include "SplatMatrix.h"

#include <algorithm>

namespace nephoscope
{
// Compares columns of points, one by one: the first, the one after it, and the last.
class SplatSeam
{
public:
  static constexpr int FewestColumns = 4;

  void Compare(const Vector3& first, const Vector3& second, const Vector3& last)
  {
    this->LongestEdge = std::max(this->LongestEdge, Norm(second - first));
    this->Farthest = std::max(this->Farthest, Norm(last - first));
  }

  // All of the last column lies where the first does, to a ten thousandth of the longest edge
  // between columns.
  bool IsClosed() const
  {
    return this->LongestEdge > 0 && this->Farthest <= 1e-4 * this->LongestEdge;
  }

private:
  double LongestEdge = 0.0;
  double Farthest = 0.0;
};
}

#endif
