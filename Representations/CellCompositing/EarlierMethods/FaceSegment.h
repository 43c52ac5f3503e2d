// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The step of the faces method (Lucas1992; MaxCrawfisBecker1993 section 2): what the segment
 * between the face drawn last at a pixel and the face drawn now does to the light F that comes from
 * behind. In the right order the face drawn now is nearer, and
 *   F <- T F + Near C_now + Far C_last,   T = exp(-(tau_now + tau_last) / 2).
 *
 * Lengths are signed, L = (z_last - z_now) sqrt(1 + x^2 + y^2): where the faces come in the wrong
 * order L is negative, T > 1, and the step takes a segment back that an earlier one has added. With
 * the same colour and extinction everywhere the lengths add up to the right sum whatever the order,
 * and F depends on the sum alone.
 *
 * How often the medium is crossed between two faces is counted, too: +1 at a face where the ray
 * leaves the volume away from the eye, -1 where it enters it on the eye's side, 0 inside. In the
 * right order the count of what is drawn is 1 inside the volume and 0 in the gaps and before the
 * first face; multiplied into the length, sum count (z_last - z_now) = sum_leaving z - sum_entering
 * z in any order, for volumes with holes as well.
 */
#ifndef nephoscope_FaceSegment_h
#define nephoscope_FaceSegment_h

#include "OpticalSegment.h"

#include <cmath>

namespace nephoscope
{

template <typename Real>
struct SegmentStep
{
  Real Near;         ///< factor of the colour at the nearer end
  Real Far;          ///< factor of the colour at the farther end
  Real Transparency; ///< factor of the light behind; greater than 1 where a segment is taken back
};

/**
 * The largest optical depth of a step in either direction: exp(300) is far from the largest double.
 */
constexpr double largestStep = 300;

/**
 * Optical depths at the nearer and the farther end, >= 0; `takeBack`: the segment is removed, not
 * added.
 */
template <typename Real>
SegmentStep<Real> FaceSegmentStep(Real tauNear, Real tauFar, bool takeBack, bool average)
{
  const Real mean = Real(0.5) * (tauNear + tauFar);
  const Real scale = mean > Real(largestStep) ? Real(largestStep) / mean : Real(1);
  const Real depth = scale * mean;
  SegmentWeights<Real> weights = average ? AverageSegmentWeights(scale * tauNear, scale * tauFar)
                                         : ExactSegmentWeights(scale * tauNear, scale * tauFar);
  const Real alpha = -std::expm1(-depth);
  const Real correction =
    weights.Alpha() > 0 ? alpha / weights.Alpha() : Real(1); // so that one colour stays that colour
  weights.Front *= correction;
  weights.Back *= correction;
  if (!takeBack)
  {
    return { weights.Front, weights.Back, std::exp(-depth) };
  }
  const Real inverse = std::exp(depth); // F = (F' - I) / T
  return { -weights.Front * inverse, -weights.Back * inverse, inverse };
}

} // namespace nephoscope

#endif
