// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The light of a ray segment with linear extinction and source colour (WilliamsMax1992), three
 * independent ways, in long double: adaptive Gauss-Kronrod quadrature of the emission, the closed
 * form with erf, and a series in spherical Bessel functions.
 * Slow, and accurate to about 1e-15 of the weights.
 */
#ifndef nephoscope_SegmentReference_h
#define nephoscope_SegmentReference_h

#include <cmath>

namespace nephoscope_test
{

struct ReferenceWeights
{
  long double Front = 0;
  long double Back = 0;
};

/** Gauss-Kronrod rule of 7 and 15 nodes on [-1, 1] (QUADPACK): node, weight of 15, weight of 7. */
constexpr long double gaussKronrodNodes[8][3] = {
  { 0.991455371120812639206854697526329L, 0.022935322010529224963732008058970L, 0.0L },
  { 0.949107912342758524526189684047851L, 0.063092092629978553290700663189204L,
    0.129484966168869693270611432679082L },
  { 0.864864423359769072789712788640926L, 0.104790010322250183839876322541518L, 0.0L },
  { 0.741531185599394439863864773280788L, 0.140653259715525918745189590510238L,
    0.279705391489276667901467771423780L },
  { 0.586087235467691130294144838258730L, 0.169004726639267902826583426598550L, 0.0L },
  { 0.405845151377397166906606412076961L, 0.190350578064785409913256402421014L,
    0.381830050505118944950369775488975L },
  { 0.207784955007898467600689403773245L, 0.204432940075298892414161999234649L, 0.0L },
  { 0.0L, 0.209482141084727828012999174891714L, 0.417959183673469387755102040816327L },
};

template <typename Function>
ReferenceWeights AdaptiveIntegral(const Function& f, long double low, long double high, int depth)
{
  const long double center = 0.5L * (low + high), half = 0.5L * (high - low);
  ReferenceWeights fine, coarse;
  for (const auto& node : gaussKronrodNodes)
  {
    for (int side = node[0] > 0 ? -1 : 1; side <= 1; side += 2)
    {
      const ReferenceWeights value = f(center + side * half * node[0]);
      fine.Front += half * node[1] * value.Front;
      fine.Back += half * node[1] * value.Back;
      coarse.Front += half * node[2] * value.Front;
      coarse.Back += half * node[2] * value.Back;
    }
  }
  const auto converged = [](long double a, long double b) {
    return std::fabs(a - b) <= 1e-14L * std::fabs(a) + 1e-19L;
  };
  if (depth == 0 || (converged(fine.Front, coarse.Front) && converged(fine.Back, coarse.Back)))
  {
    return fine;
  }
  const ReferenceWeights left = AdaptiveIntegral(f, low, center, depth - 1);
  const ReferenceWeights right = AdaptiveIntegral(f, center, high, depth - 1);
  return { left.Front + right.Front, left.Back + right.Back };
}

/** Weights of the source colours at the front and back end. */
inline ReferenceWeights FindReferenceWeights(long double tauFront, long double tauBack)
{
  const long double slope = tauBack - tauFront;
  const auto emission = [&](long double t) {
    const long double emitted =
      (tauFront + slope * t) * std::exp(-t * (tauFront + 0.5L * slope * t));
    return ReferenceWeights{ (1 - t) * emitted, t * emitted };
  };
  // Pieces whose ends are near the peak, which lies at the front when the segment is dense.
  const long double ends[] = { 0, 1e-4L, 1e-3L, 1e-2L, 1e-1L, 1 };
  ReferenceWeights sum;
  for (int i = 0; i < 5; ++i)
  {
    const ReferenceWeights part = AdaptiveIntegral(emission, ends[i], ends[i + 1], 30);
    sum.Front += part.Front;
    sum.Back += part.Back;
  }
  return sum;
}

/**
 * Psi = int_0^1 exp(-A(t)) dt from erf; for tb > tf not too close to each other, and tf not large.
 */
inline long double ClosedFormPsi(long double tf, long double tb)
{
  const long double d = tb - tf, q = std::sqrt(2 * d);
  return std::sqrt(std::acos(-1.0L)) / q * std::exp(tf * tf / (2 * d)) *
    (std::erf(tb / q) - std::erf(tf / q));
}

/**
 * Psi = exp(-z) sum_k r^k i_k(z), z = (tf + tb) / 4, r = (tb - tf) / (tb + tf), i_k the modified
 * spherical Bessel functions.
 */
inline long double BesselSeriesPsi(long double tf, long double tb)
{
  const long double z = 0.25L * (tf + tb), r = (tb - tf) / (tb + tf);
  long double sum = 0, first = 1; // first = z^k / (2k + 1)!!
  for (int k = 0; k < 200; ++k)
  {
    long double term = first, bessel = 0;
    for (int m = 1; m < 400 && term > 1e-24L * bessel;
         ++m) // term_m = first (z^2/2)^m / (m! (2k+3)(2k+5)...(2k+2m+1))
    {
      bessel += term;
      term *= 0.5L * z * z / (m * (2 * k + 2 * m + 1.0L));
    }
    sum += std::pow(r, k) * bessel;
    first *= z / (2 * k + 3);
    if (first < 1e-30L)
    {
      break;
    }
  }
  return std::exp(-z) * sum;
}

} // namespace nephoscope_test

#endif
