// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions and velocities on a spherical planet and on its plate carree map. Plain C++17.
//
// Angles in radians, lengths in metres, speeds in m/s. The planet's axis is z; longitude 0 is on
// +x, longitude 90 east on +y. `height` is physical; `exaggeration` E stretches the display alone.
#ifndef nephoscope_Geodesy_h
#define nephoscope_Geodesy_h

#include "Vector3.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace geodesy
{
inline constexpr double RADIANS_PER_DEGREE = 0.017453292519943295769;

// On the map the speed along x grows without bound towards a pole; cos(latitude) is held above this
// value (89.4 degrees).
inline constexpr double SMALLEST_MAP_COSINE = 0.01;

struct Planet
{
  double radius;
  double exaggeration;
};

// Sine and cosine that are exact at the poles and the quarter turns, so that a row at a pole is one
// point and the column at 360 degrees is the column at 0.
struct Turn
{
  double sine;
  double cosine;
};

inline Turn TurnFromDegrees(double degrees)
{
  const double wrapped = std::remainder(degrees, 360.0); // exact, in [-180, 180]
  const double fromPole = 90.0 - std::abs(wrapped);
  const double sine = std::abs(wrapped) == 180.0 ? 0.0 : std::sin(wrapped * RADIANS_PER_DEGREE);
  return { sine, fromPole == 0.0 ? 0.0 : std::cos(wrapped * RADIANS_PER_DEGREE) };
}

// East, north and up at a longitude and latitude: a right-handed orthonormal frame.
struct Basis
{
  Vector3 east;
  Vector3 north;
  Vector3 up;
};

inline Basis LocalBasis(const Turn& longitude, const Turn& latitude)
{
  return { { -longitude.sine, longitude.cosine, 0.0 },
    { -latitude.sine * longitude.cosine, -latitude.sine * longitude.sine, latitude.cosine },
    { latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine } };
}

// u east + v north + w up.
inline Vector3 Combine(const Basis& basis, double u, double v, double w)
{
  Vector3 sum;
  for (int c = 0; c < 3; ++c)
  {
    sum[c] = u * basis.east[c] + v * basis.north[c] + w * basis.up[c];
  }
  return sum;
}

inline Vector3 GlobePosition(const Planet& planet, const Basis& basis, double height)
{
  return Combine(basis, 0.0, 0.0, planet.radius + planet.exaggeration * height);
}

inline Vector3 MapPosition(const Planet& planet, double longitude, double latitude, double height)
{
  return { planet.radius * longitude, planet.radius * latitude, planet.exaggeration * height };
}

// A parcel at the physical radius R + h turns about the planet's centre at (u east + v north)/(R +
// h); the display radius is r = R + E h, so d(position)/dt = r/(R + h) (u east + v north) + E w up.
// No division by the cosine of the latitude: exact at the poles. `wind` is Cartesian.
inline Vector3 GlobeDisplayVelocity(
  const Planet& planet, const Basis& basis, double height, const Vector3& wind)
{
  const double w = Dot(wind, basis.up);
  const double ratio = (planet.radius + planet.exaggeration * height) / (planet.radius + height);
  Vector3 velocity;
  for (int c = 0; c < 3; ++c)
  {
    velocity[c] = ratio * (wind[c] - w * basis.up[c]) + planet.exaggeration * w * basis.up[c];
  }
  return velocity;
}

// x = R longitude, y = R latitude: dx/dt = R u / ((R + h) cos latitude), dy/dt = R v / (R + h).
inline Vector3 MapDisplayVelocity(
  const Planet& planet, double cosineOfLatitude, double height, double u, double v, double w)
{
  const double ratio = planet.radius / (planet.radius + height);
  return { ratio * u / std::max(cosineOfLatitude, SMALLEST_MAP_COSINE), ratio * v,
    planet.exaggeration * w };
}
}
}

#endif
