// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A ray segment in several overlapping media. Extinctions add, and every medium emits in proportion
 * to its own:
 *   a(t) = sum a_m(t),   E(t) = sum a_m(t) C_m(t),   I = int_0^1 E(t) exp(-A(t)) dt.
 * All a_m and C_m are linear along the segment, so that E is quadratic. With the mixed colours L of
 * the two ends, E / a there,
 *   E(t) = a(t) ((1 - t) L_front + t L_back) + bulge t (1 - t),
 *   bulge = 4 E(1/2) - (a_front + a_back) (L_front + L_back),
 * and the first part is the segment of one medium (OpticalSegment.h). Where a medium ends at
 * extinction 0 on one side, L is 0 there and the bulge makes up for it. One medium alone has no
 * bulge.
 *
 * shaders/MixedSegment.glsl is the same algorithm.
 */
#ifndef nephoscope_MixedSegment_h
#define nephoscope_MixedSegment_h

#include "OpticalSegment.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{

/** Abscissae on [0, 1] and weights of 4 nodes, for thin segments. */
constexpr double thinNodes[4][2] = {
  { 0.069431844202973714, 0.17392742256872693 },
  { 0.33000947820757187, 0.32607257743127307 },
  { 0.66999052179242813, 0.32607257743127307 },
  { 0.93056815579702629, 0.17392742256872693 },
};

/** Integral of t (1 - t) exp(-A(t)) over [0, 1]; its error is below 1e-7. */
template <typename Real>
Real BulgeWeight(Real tauFront, Real tauBack)
{
  const Real largest = std::max(tauFront, tauBack);
  const bool thin = largest <= Real(thinSegment);
  const Real end = thin ? Real(1) : OpaqueEnd(tauFront, tauBack);
  const QuadratureRule rule = thin ? QuadratureRule{ 0, 4 } : ChooseQuadratureRule(largest);
  const auto& nodes = thin ? thinNodes[0] : quadratureNodes[0];
  Real weight = 0;
  for (int i = rule.First; i < rule.First + rule.Size; ++i)
  {
    const Real t = end * Real((&nodes)[i][0]);
    weight += Real((&nodes)[i][1]) * t * (1 - t) *
      std::exp(-t * (tauFront + Real(0.5) * (tauBack - tauFront) * t));
  }
  return weight * end;
}

/**
 * One channel of the light: emission at both ends and in the middle, and extinction at both ends,
 * each times the segment's length.
 */
template <typename Real>
Real MixedLight(
  Real emissionFront, Real emissionMiddle, Real emissionBack, Real tauFront, Real tauBack)
{
  const Real colorFront = tauFront > 0 ? emissionFront / tauFront : Real(0);
  const Real colorBack = tauBack > 0 ? emissionBack / tauBack : Real(0);
  const Real bulge = 4 * emissionMiddle - (tauFront + tauBack) * (colorFront + colorBack);
  const SegmentWeights<Real> weights = ExactSegmentWeights(tauFront, tauBack);
  return weights.Front * colorFront + weights.Back * colorBack +
    BulgeWeight(tauFront, tauBack) * bulge;
}

} // namespace nephoscope

#endif
