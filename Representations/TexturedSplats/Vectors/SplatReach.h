// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How far what is drawn of a splat reaches: its kernel, and its vector, which may be longer. Plain
// C++17.
#ifndef nephoscope_SplatReach_h
#define nephoscope_SplatReach_h

#include "EllipsoidSplat.h"
#include "VectorTexture.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
// The kernel on which streaks are drawn has, along the vector, cells of this share of the streaks'
// period at least.
constexpr double streakKernelShare = 0.5;

// From the place of a segment to the end of it, or of the one that fades out, in segments: half of
// one, and the way it moves.
constexpr double segmentReach = 0.5 + 0.5 * (1.0 + segmentFade);

// Lengths in units of the data.
struct VectorLook
{
  bool Segments = false;
  double Unit = 1.0;
  double StreakPeriod = 4.0;  // units
  double SegmentLength = 2.0; // units, at the greatest speed
};

// The cell of the kernel on which the streaks of a vector are drawn; the vector must not be 0.
inline SplatMatrix LengthenedCell(
  const SplatMatrix& jacobian, const Vector3& vector, const VectorLook& look)
{
  const double cell = ReachAlong(jacobian, vector);
  const double longer =
    std::max(1.0, streakKernelShare * look.StreakPeriod * look.Unit / cell) - 1.0;
  const double square = Dot(vector, vector);
  SplatMatrix lengthened = jacobian;
  for (Vector3& column : lengthened)
  {
    const double along = longer * Dot(vector, column) / square;
    for (std::size_t c = 0; c < 3; ++c)
    {
      column[c] += along * vector[c];
    }
  }
  return lengthened;
}

// At most, from the centre of a splat whose Jacobian stretches lengths by `stretch`, whatever its
// vector. A segment is somewhere in its cell.
inline double VectorReach(const VectorLook& look, double kernelRadius, double stretch)
{
  constexpr double halfDiagonal = 0.866026;
  return look.Segments
    ? halfDiagonal * stretch + segmentReach * look.SegmentLength * look.Unit
    : kernelRadius * std::hypot(stretch, streakKernelShare * look.StreakPeriod * look.Unit);
}
}

#endif
