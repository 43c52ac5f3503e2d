// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Haze whose density falls exponentially with altitude, density = exp(-h / H): the length X of air of the density at the ground that
 * lies along a ray. With extinction k at the ground, light is dimmed by exp(-k X).
 *
 * Nothing here overflows or cancels in 32-bit float.
 */
#ifndef Haze_h
#define Haze_h

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

/** exp(x^2) erfc(x), x >= 0: (1 + 2 x) of it is a polynomial in (x - 3) / (x + 3); relative error below 8e-8. */
template <typename Real>
Real scaledErfc(Real x)
{
  constexpr double coefficients[11] = { 1.25300806, -0.135620239, -0.0475621569, 0.129627505, -0.119275275, 0.0684095817,
    -0.0237635764, 0.0022865137, 0.00187507912, -0.000513850513, -9.25451669e-05 };
  const Real t = (x - 3) / (x + 3);
  Real sum = 0;
  for (int i = 10; i >= 0; --i)
  {
    sum = sum * t + Real(coefficients[i]);
  }
  return sum / (1 + 2 * x);
}

/** (1 - exp(-x)) / x, x >= 0. */
template <typename Real>
Real meanDecay(Real x)
{
  return x < Real(0.03) ? 1 - x * (Real(0.5) - x * (Real(1.0 / 6) - x * Real(1.0 / 24))) : (1 - std::exp(-x)) / x;
}

/**
 * int_0^1 exp(-front t - (back - front) t^2 / 2) dt, 0 <= front <= back: the mean transparency of a segment whose extinction rises
 * (Psi of WilliamsMax1992). By Gauss-Legendre quadrature where thin, else by the error function.
 */
template <typename Real>
Real meanTransparency(Real front, Real back)
{
  if (back <= 1)
  {
    constexpr double nodes[4][2] = { { 0.069431844202973714, 0.17392742256872693 },
      { 0.33000947820757187, 0.32607257743127307 }, { 0.66999052179242813, 0.32607257743127307 },
      { 0.93056815579702629, 0.17392742256872693 } };
    Real sum = 0;
    for (const auto& node : nodes)
    {
      const Real t = Real(node[0]);
      sum += Real(node[1]) * std::exp(-t * (front + (back - front) * t / 2));
    }
    return sum;
  }
  const Real q = std::sqrt(2 * std::max(back - front, Real(1e-6) * back));
  const Real transparency = std::exp(-(front + back) / 2);
  return Real(1.7724538509055160) / q * (scaledErfc(front / q) - transparency * scaledErfc(back / q));
}

/** Along a segment over flat ground, between altitudes h1 and h2. All in one unit of length. */
template <typename Real>
Real flatHazeLength(Real h1, Real h2, Real length, Real scaleHeight)
{
  return length * std::exp(-std::min(h1, h2) / scaleHeight) * meanDecay(std::abs(h2 - h1) / scaleHeight);
}

/** Density over that at the ground; of no more use, but finite, far inside the planet. */
template <typename Real>
Real hazeDensity(Real radius, Real planetRadius, Real scaleHeight)
{
  return std::exp(std::min((planetRadius - radius) / scaleHeight, Real(20)));
}

/** A segment about the centre of a planet. */
template <typename Real>
struct HazeSegment
{
  Real Radius1 = 0;  ///< of its two ends
  Real Radius2 = 0;
  Real Along1 = 0;   ///< of its two ends, from the place that is nearest to the centre
  Real Along2 = 0;   ///< >= Along1
  Real Nearest = 0;  ///< distance of that place, which need not be on the segment
};

template <typename Real>
HazeSegment<Real> hazeSegment(const std::array<Real, 3>& p, const std::array<Real, 3>& q)
{
  const auto norm = [](const std::array<Real, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); };
  const std::array<Real, 3> d{ { q[0] - p[0], q[1] - p[1], q[2] - p[2] } };
  const Real length = norm(d);
  HazeSegment<Real> result;
  result.Radius1 = norm(p);
  result.Radius2 = norm(q);
  result.Nearest = result.Radius1;
  if (length > 0)
  {
    result.Along1 = (p[0] * d[0] + p[1] * d[1] + p[2] * d[2]) / length;
    result.Along2 = result.Along1 + length;
    const Real s = result.Along1 / length;
    result.Nearest = norm({ { p[0] - s * d[0], p[1] - s * d[1], p[2] - s * d[2] } });
  }
  return result;
}

/** Rays near the horizon, or past it: error functions about the nearest place, with the first correction for curvature. */
template <typename Real>
Real levelHazeLength(const HazeSegment<Real>& s, Real planetRadius, Real scaleHeight)
{
  const Real b = s.Nearest;
  const Real x1 = s.Along1 / std::sqrt((s.Radius1 + b) * scaleHeight);
  const Real x2 = s.Along2 / std::sqrt((s.Radius2 + b) * scaleHeight);
  const Real e1 = hazeDensity(s.Radius1, planetRadius, scaleHeight);
  const Real e2 = hazeDensity(s.Radius2, planetRadius, scaleHeight);
  constexpr Real halfRootPi = Real(0.88622692545275801);
  const Real tail1 = halfRootPi * e1 * scaledErfc(std::abs(x1));
  const Real tail2 = halfRootPi * e2 * scaledErfc(std::abs(x2));
  const bool past = x1 < 0 && x2 > 0;
  const Real g = past ? 2 * halfRootPi * hazeDensity(b, planetRadius, scaleHeight) - tail1 - tail2
                      : std::abs(tail1 - tail2);
  const Real second = (g - x2 * e2 + x1 * e1) / 2;
  return std::max(Real(0), std::sqrt(2 * b * scaleHeight) * (g + Real(0.75) * scaleHeight / b * second));
}

/** Steep rays, from their lower end on: altitude along them as a parabola, as along a segment whose extinction rises. */
template <typename Real>
Real steepHazeLength(Real lowerRadius, Real sine, Real length, Real planetRadius, Real scaleHeight)
{
  const Real front = sine * length / scaleHeight;
  const Real back = front + (1 - sine * sine) * length / lowerRadius * (length / scaleHeight);
  return length * hazeDensity(lowerRadius, planetRadius, scaleHeight) * meanTransparency(front, back);
}

/** From p to q about the centre of a planet. All in one unit of length; relative error below 1e-4 in the atmosphere of the Earth. */
template <typename Real>
Real globeHazeLength(
  const std::array<Real, 3>& p, const std::array<Real, 3>& q, Real planetRadius, Real scaleHeight)
{
  const HazeSegment<Real> s = hazeSegment(p, q);
  const bool rising = s.Along1 >= 0;
  const bool falling = s.Along2 <= 0;
  const Real lowerRadius = std::min(s.Radius1, s.Radius2);
  const Real sine = std::min(Real(1), (rising ? s.Along1 : -s.Along2) / lowerRadius);
  const Real length = s.Along2 - s.Along1;
  const bool isShort = length < Real(0.005) * lowerRadius; // differences of error functions would cancel
  if ((rising || falling) && (isShort || sine > Real(0.2)))
  {
    return steepHazeLength(lowerRadius, sine, length, planetRadius, scaleHeight);
  }
  if (isShort)
  {
    return steepHazeLength(s.Nearest, Real(0), -s.Along1, planetRadius, scaleHeight) +
      steepHazeLength(s.Nearest, Real(0), s.Along2, planetRadius, scaleHeight);
  }
  return levelHazeLength(s, planetRadius, scaleHeight);
}

} // namespace nephoscope

#endif
