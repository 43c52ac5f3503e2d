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
 * and are evaluated by Gauss-Legendre quadrature: nothing is ever subtracted, so thin segments keep their
 * relative accuracy in float, where the closed form with erf and Dawson loses it.
 *
 * shaders/OpticalSegment.glsl is the same algorithm; TestOpticalSegmentShader compares the two.
 */
#ifndef OpticalSegment_h
#define OpticalSegment_h

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

/** Abscissae on [0, 1] and weights for 4, 6, 10 and 16 nodes, one after the other. */
constexpr int numberOfQuadratureNodes = 36;
constexpr double quadratureNodes[numberOfQuadratureNodes][2] = {
  { 0.069431844202973714, 0.17392742256872684 },
  { 0.33000947820757187, 0.3260725774312731 },
  { 0.66999052179242813, 0.3260725774312731 },
  { 0.93056815579702623, 0.17392742256872684 },
  { 0.033765242898423975, 0.085662246189584873 },
  { 0.16939530676686776, 0.18038078652406947 },
  { 0.38069040695840151, 0.23395696728634569 },
  { 0.61930959304159849, 0.23395696728634569 },
  { 0.83060469323313224, 0.18038078652406947 },
  { 0.96623475710157603, 0.085662246189584873 },
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
 * The cheapest rule whose error stays below 6e-7 in float for optical depths up to `largest` (beyond 1000: 1e-6);
 * all of it is the rounding of float: in double the rules err by 1.5e-8 at most (TestOpticalSegment).
 */
template <typename Real>
constexpr QuadratureRule quadratureRule(Real largest)
{
  return largest <= Real(0.25) ? QuadratureRule{ 0, 4 }
    : largest <= Real(1)       ? QuadratureRule{ 4, 6 }
    : largest <= Real(10)      ? QuadratureRule{ 10, 10 }
                               : QuadratureRule{ 20, 16 };
}

/** Where along [0, 1] the optical depth reaches 18: what lies behind is darker than 1.5e-8 and is left out. */
template <typename Real>
Real opaqueEnd(Real tauFront, Real tauBack)
{
  constexpr Real cut = 18;
  const Real discriminant = tauFront * tauFront + 2 * (tauBack - tauFront) * cut;
  return discriminant > 0 ? std::min(Real(1), 2 * cut / (tauFront + std::sqrt(discriminant))) : Real(1);
}

/** Weights of the two end colours; optical depths >= 0. */
template <typename Real>
SegmentWeights<Real> exactSegmentWeights(Real tauFront, Real tauBack)
{
  const Real difference = tauBack - tauFront;
  const Real end = opaqueEnd(tauFront, tauBack);
  const QuadratureRule rule = quadratureRule(std::max(tauFront, tauBack));
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

/** The rule of MaxCrawfisBecker1993 section 2: exact transparency, mean of the two colours. */
template <typename Real>
SegmentWeights<Real> averageSegmentWeights(Real tauFront, Real tauBack)
{
  const Real half = Real(-0.5) * std::expm1(Real(-0.5) * (tauFront + tauBack));
  return { half, half };
}

} // namespace nephoscope

#endif
