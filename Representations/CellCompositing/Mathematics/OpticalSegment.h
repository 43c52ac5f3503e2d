// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The optical model of a ray segment: extinction and source colour vary linearly along it.
 *
 * With optical depths tf = L a_front and tb = L a_back, the light that the segment adds is
 *   I = front * C_front + back * C_back,   front + back = alpha = 1 - T,   T = exp(-(tf + tb) / 2)
 * (WilliamsMax1992). The weights are integrals of positive functions,
 *   front = int_0^1 (1 - t) a(t) exp(-A(t)) dt,   back = int_0^1 t a(t) exp(-A(t)) dt,
 *   a(t) = tf + (tb - tf) t,   A(t) = tf t + (tb - tf) t^2 / 2,
 * and are evaluated by Gauss-Legendre quadrature: nothing is ever subtracted, so thin segments keep
 * their relative accuracy in float, where the closed form with erf and Dawson loses it.
 *
 * shaders/OpticalSegment.glsl is the same algorithm; TestOpticalSegmentShader compares the two.
 */
#ifndef nephoscope_OpticalSegment_h
#define nephoscope_OpticalSegment_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{

template <typename Real>
struct SegmentWeights
{
  Real Front; ///< weight of the source colour at the front end, in [0, 1]
  Real Back;  ///< weight of the source colour at the back end, in [0, 1]
  /** Absorbed fraction of the light behind, 1 - T. */
  Real Alpha() const { return this->Front + this->Back; }
};

/** A rule of Gauss-Legendre quadrature: `Size` nodes from `First` on in quadratureNodes. */
struct QuadratureRule
{
  int First;
  int Size;
};

/** Abscissae on [0, 1] and weights for 10 and 16 nodes, one after the other. */
constexpr int numberOfQuadratureNodes = 26;
constexpr double quadratureNodes[numberOfQuadratureNodes][2] = {
  { 0.013046735741414128, 0.033335672154344034 },
  { 0.067468316655507732, 0.074725674575290182 },
  { 0.16029521585048778, 0.10954318125799101 },
  { 0.28330230293537639, 0.13463335965499826 },
  { 0.42556283050918442, 0.14776211235737649 },
  { 0.57443716949081558, 0.14776211235737649 },
  { 0.71669769706462361, 0.13463335965499826 },
  { 0.83970478414951222, 0.10954318125799101 },
  { 0.93253168334449232, 0.074725674575290182 },
  { 0.98695326425858587, 0.033335672154344034 },
  { 0.0052995325041750307, 0.013576229705877019 },
  { 0.0277124884633837, 0.031126761969323853 },
  { 0.067184398806084122, 0.047579255841246296 },
  { 0.1222977958224985, 0.062314485627767015 },
  { 0.19106187779867811, 0.074797994408288382 },
  { 0.27099161117138632, 0.08457825969750131 },
  { 0.35919822461037054, 0.091301707522461806 },
  { 0.45249374508118129, 0.094725305227534293 },
  { 0.54750625491881877, 0.094725305227534293 },
  { 0.64080177538962946, 0.091301707522461806 },
  { 0.72900838882861363, 0.08457825969750131 },
  { 0.80893812220132189, 0.074797994408288382 },
  { 0.87770220417750155, 0.062314485627767015 },
  { 0.93281560119391593, 0.047579255841246296 },
  { 0.9722875115366163, 0.031126761969323853 },
  { 0.99470046749582497, 0.013576229705877019 },
};

/**
 * The rule for segments that are not thin: its error stays below 6e-7 in float for optical depths
 * up to `largest` (beyond 1000: 1e-6); all of it is the rounding of float: in double the rules err
 * by 1.5e-8 at most (TestOpticalSegment).
 */
template <typename Real>
constexpr QuadratureRule ChooseQuadratureRule(Real largest)
{
  return largest <= Real(10) ? QuadratureRule{ 0, 10 } : QuadratureRule{ 10, 16 };
}

/** Up to this optical depth at either end a segment counts as thin. */
constexpr double thinSegment = 1;

/**
 * Where along [0, 1] the optical depth reaches 18: what lies behind is darker than 1.5e-8 and is
 * left out.
 */
template <typename Real>
Real OpaqueEnd(Real tauFront, Real tauBack)
{
  constexpr Real cut = 18;
  const Real discriminant = tauFront * tauFront + 2 * (tauBack - tauFront) * cut;
  return discriminant > 0 ? std::min(Real(1), 2 * cut / (tauFront + std::sqrt(discriminant)))
                          : Real(1);
}

/**
 * By a series in which nothing cancels. With z half the optical depth and d half the difference of
 * its ends,
 *   Psi = e^-z integral of e^(-z x) e^(d (1 - x^2) / 4) dx / 2 over [-1, 1],
 * the second factor is expanded in d and the rest integrated term by term, in even powers of z. In
 * (wf - wb) / 2 = (1 + T) / 2 - Psi the large terms are taken together before: cosh z - sinh z / z.
 * The error of the truncation is below 3e-7 for thin segments.
 */
template <typename Real>
SegmentWeights<Real> ThinSegmentWeights(Real tauFront, Real tauBack)
{
  const Real z = Real(0.25) * (tauFront + tauBack);
  const Real d = Real(0.5) * (tauBack - tauFront);
  const Real q = z * z;
  const Real h = std::exp(-z);
  const Real halfAlpha =
    h * z * (1 + q * (Real(1.0 / 6) + q * (Real(1.0 / 120) + q * Real(1.0 / 5040))));
  const Real p0 =
    q * (Real(1.0 / 3) + q * (Real(1.0 / 30) + q * (Real(1.0 / 840) + q * Real(1.0 / 45360))));
  const Real p1 =
    Real(1.0 / 6) + q * (Real(1.0 / 60) + q * (Real(1.0 / 1680) + q * Real(1.0 / 90720)));
  const Real p2 = Real(1.0 / 60) + q * (Real(1.0 / 840) + q * Real(1.0 / 30240));
  const Real p3 = Real(1.0 / 840) + q * Real(1.0 / 15120);
  const Real excess = h * (p0 - d * (p1 + d * (p2 + d * (p3 + d * Real(1.0 / 15120)))));
  return { halfAlpha + excess, halfAlpha - excess };
}

/** By quadrature, whose terms are all positive: nothing cancels. */
template <typename Real>
SegmentWeights<Real> ThickSegmentWeights(Real tauFront, Real tauBack)
{
  const Real difference = tauBack - tauFront;
  const Real end = OpaqueEnd(tauFront, tauBack);
  const QuadratureRule rule = ChooseQuadratureRule(std::max(tauFront, tauBack));
  SegmentWeights<Real> weights = { 0, 0 };
  for (int i = rule.First; i < rule.First + rule.Size; ++i)
  {
    const Real t = end * Real(quadratureNodes[i][0]);
    const Real emitted = Real(quadratureNodes[i][1]) * (tauFront + difference * t) *
      std::exp(-t * (tauFront + Real(0.5) * difference * t));
    weights.Front += emitted * (1 - t);
    weights.Back += emitted * t;
  }
  return { weights.Front * end, weights.Back * end };
}

/** Weights of the two end colours; optical depths >= 0. */
template <typename Real>
SegmentWeights<Real> ExactSegmentWeights(Real tauFront, Real tauBack)
{
  return std::max(tauFront, tauBack) <= Real(thinSegment) ? ThinSegmentWeights(tauFront, tauBack)
                                                          : ThickSegmentWeights(tauFront, tauBack);
}

/** The rule of MaxCrawfisBecker1993 section 2: exact transparency, mean of the two colours. */
template <typename Real>
SegmentWeights<Real> AverageSegmentWeights(Real tauFront, Real tauBack)
{
  const Real half = Real(-0.5) * std::expm1(Real(-0.5) * (tauFront + tauBack));
  return { half, half };
}

} // namespace nephoscope

#endif
