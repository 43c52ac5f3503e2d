// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Haze whose density falls exponentially with altitude, density = exp(-h): the length X of air of
 * the density at altitude 0 that lies along a ray. With extinction k at altitude 0 light is dimmed
 * by the transparency T = exp(-k X), and haze of the colour C adds C (1 - T).
 *
 * All lengths are in scale heights. Nothing here overflows or cancels in 32-bit float;
 * shaders/Haze.glsl is the same for shaders.
 */
#ifndef nephoscope_Haze_h
#define nephoscope_Haze_h

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

/**
 * exp(x^2) erfc(x), x >= 0: (1 + 2 x) of it is a polynomial in (x - 3) / (x + 3); relative error
 * below 8e-8.
 */
template <typename Real>
Real ScaledErfc(Real x)
{
  constexpr double coefficients[11] = { 1.25300806, -0.135620239, -0.0475621569, 0.129627505,
    -0.119275275, 0.0684095817, -0.0237635764, 0.0022865137, 0.00187507912, -0.000513850513,
    -9.25451669e-05 };
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
Real MeanDecay(Real x)
{
  return x < Real(0.03) ? 1 - x * (Real(0.5) - x * (Real(1.0 / 6) - x * Real(1.0 / 24)))
                        : (1 - std::exp(-x)) / x;
}

/**
 * int_0^1 exp(-front t - (back - front) t^2 / 2) dt, 0 <= front <= back: the mean transparency of a
 * segment whose extinction rises (Psi of WilliamsMax1992). By Gauss-Legendre quadrature where thin,
 * else by the error function.
 */
template <typename Real>
Real MeanTransparency(Real front, Real back)
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
  return Real(1.7724538509055160) / q *
    (ScaledErfc(front / q) - transparency * ScaledErfc(back / q));
}

/** Density over that at altitude 0; of no more use, but finite, far below it. */
template <typename Real>
Real HazeDensity(Real altitude)
{
  return std::exp(-std::max(altitude, Real(-20)));
}

/** Along a segment over flat ground. */
template <typename Real>
Real FlatHazeLength(Real altitude1, Real altitude2, Real length)
{
  return length * HazeDensity(std::min(altitude1, altitude2)) *
    MeanDecay(std::abs(altitude2 - altitude1));
}

/**
 * A ray over flat ground, up to where there is no haze, or down to altitude 0; `rise` is the sine
 * of its elevation.
 */
template <typename Real>
Real FlatHazeLengthToSky(Real altitude, Real rise)
{
  const Real slope = std::max(std::abs(rise), Real(1e-6));
  return (rise >= 0 ? HazeDensity(altitude) : std::max(Real(0), 1 - HazeDensity(altitude))) / slope;
}

template <typename Real>
using HazeVector = std::array<Real, 3>;

template <typename Real>
Real HazeDot(const HazeVector<Real>& a, const HazeVector<Real>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Real>
Real HazeNorm(const HazeVector<Real>& a)
{
  return std::sqrt(HazeDot(a, a));
}

/**
 * A position around the centre of a planet. Its altitude is known better than the difference of two
 * radii in float.
 */
template <typename Real>
struct HazePlace
{
  HazeVector<Real> FromCenter{ { 0, 0, 0 } };
  Real Radius = 0;
  Real Altitude = 0;
};

template <typename Real>
HazePlace<Real> MovedHazePlace(const HazePlace<Real>& place, const HazeVector<Real>& step)
{
  HazePlace<Real> moved;
  HazeVector<Real> both; // twice the place half way
  for (std::size_t c = 0; c < 3; ++c)
  {
    moved.FromCenter[c] = place.FromCenter[c] + step[c];
    both[c] = place.FromCenter[c] + moved.FromCenter[c];
  }
  moved.Radius = HazeNorm(moved.FromCenter);
  moved.Altitude = place.Altitude + HazeDot(both, step) / (place.Radius + moved.Radius);
  return moved;
}

/** A segment about the centre of a planet. */
template <typename Real>
struct HazeSegment
{
  Real Radius1 = 0, Altitude1 = 0,
       Along1 = 0; ///< of its ends; along it from the place that is nearest to the centre
  Real Radius2 = 0, Altitude2 = 0, Along2 = 0; ///< Along2 >= Along1
  Real Nearest = 0, NearestAltitude = 0; ///< radius of that place, which need not be on the segment
};

template <typename Real>
HazeSegment<Real> HazeSegmentOf(const HazePlace<Real>& from, const HazeVector<Real>& step)
{
  const HazePlace<Real> to = MovedHazePlace(from, step);
  HazeSegment<Real> s;
  s.Radius1 = from.Radius;
  s.Radius2 = to.Radius;
  s.Altitude1 = from.Altitude;
  s.Altitude2 = to.Altitude;
  const Real length = HazeNorm(step);
  const Real perLength = length > 0 ? 1 / length : Real(0);
  s.Along1 = HazeDot(from.FromCenter, step) * perLength;
  s.Along2 = s.Along1 + length;
  HazeVector<Real> nearest;
  for (std::size_t c = 0; c < 3; ++c)
  {
    nearest[c] = from.FromCenter[c] - s.Along1 * perLength * step[c];
  }
  s.Nearest = HazeNorm(nearest);
  const bool isFirst = std::abs(s.Along1) < std::abs(s.Along2);
  s.NearestAltitude = isFirst ? s.Altitude1 - s.Along1 * s.Along1 / (s.Radius1 + s.Nearest)
                              : s.Altitude2 - s.Along2 * s.Along2 / (s.Radius2 + s.Nearest);
  return s;
}

/**
 * Rays near the horizon, or past it: error functions about the nearest place, with the first
 * correction for curvature.
 */
template <typename Real>
Real LevelHazeLength(const HazeSegment<Real>& s)
{
  const Real b = s.Nearest;
  const Real x1 = s.Along1 / std::sqrt(s.Radius1 + b);
  const Real x2 = s.Along2 / std::sqrt(s.Radius2 + b);
  const Real e1 = HazeDensity(s.Altitude1);
  const Real e2 = HazeDensity(s.Altitude2);
  constexpr Real halfRootPi = Real(0.88622692545275801);
  const Real tail1 = halfRootPi * e1 * ScaledErfc(std::abs(x1));
  const Real tail2 = halfRootPi * e2 * ScaledErfc(std::abs(x2));
  const bool past = x1 < 0 && x2 > 0;
  const Real g = past ? 2 * halfRootPi * HazeDensity(s.NearestAltitude) - tail1 - tail2
                      : std::abs(tail1 - tail2);
  const Real second = (g - x2 * e2 + x1 * e1) / 2;
  return std::max(Real(0), std::sqrt(2 * b) * (g + Real(0.75) / b * second));
}

/**
 * Steep rays, from their lower end on: altitude along them as a parabola, as along a segment whose
 * extinction rises.
 */
template <typename Real>
Real SteepHazeLength(Real lowerRadius, Real lowerAltitude, Real sine, Real length)
{
  const Real front = sine * length;
  const Real back = front + (1 - sine * sine) * length / lowerRadius * length;
  return length * HazeDensity(lowerAltitude) * MeanTransparency(front, back);
}

/** About the centre of a planet; relative error below 1e-4 in the atmosphere of the Earth. */
template <typename Real>
Real GlobeHazeLength(const HazePlace<Real>& from, const HazeVector<Real>& step)
{
  const HazeSegment<Real> s = HazeSegmentOf(from, step);
  const bool rising = s.Along1 >= 0;
  const bool falling = s.Along2 <= 0;
  const Real lowerRadius = std::min(s.Radius1, s.Radius2);
  const Real sine = std::min(Real(1), (rising ? s.Along1 : -s.Along2) / lowerRadius);
  const Real length = s.Along2 - s.Along1;
  const bool isShort =
    length < Real(0.005) * lowerRadius; // differences of error functions would cancel
  if ((rising || falling) && (isShort || sine > Real(0.2)))
  {
    return SteepHazeLength(lowerRadius, std::min(s.Altitude1, s.Altitude2), sine, length);
  }
  if (isShort)
  {
    return SteepHazeLength(s.Nearest, s.NearestAltitude, Real(0), -s.Along1) +
      SteepHazeLength(s.Nearest, s.NearestAltitude, Real(0), s.Along2);
  }
  return LevelHazeLength(s);
}

/** A ray in a direction (of length 1), up to where there is no haze, or down to altitude 0. */
template <typename Real>
Real GlobeHazeLengthToSky(const HazePlace<Real>& from, const HazeVector<Real>& direction)
{
  constexpr Real top = 30; // exp(-30) of the haze is above
  const Real along = HazeDot(from.FromCenter, direction);
  const Real planet = from.Radius - from.Altitude;
  // Squares of half the chords within both spheres.
  const Real toGround = from.Altitude * (planet + from.Radius);
  const Real toTop = (top - from.Altitude) * (planet + top + from.Radius);
  const Real ground = along * along - toGround;
  const Real sky = along * along + toTop;
  const bool meetsGround = along < 0 && ground > 0 && from.Altitude > 0;
  if (!(sky > 0) || (along > 0 && toTop < 0))
  {
    return 0;
  }
  const Real length = meetsGround ? toGround / (std::sqrt(ground) - along) : std::sqrt(sky) - along;
  // The part above the top is left out: from far away the rest is known better.
  const Real start = along < 0 && toTop < 0 ? -along - std::sqrt(sky) : Real(0);
  HazeVector<Real> first, step;
  for (std::size_t c = 0; c < 3; ++c)
  {
    first[c] = start * direction[c];
    step[c] = (length - start) * direction[c];
  }
  return GlobeHazeLength(MovedHazePlace(from, first), step);
}

} // namespace nephoscope

#endif
